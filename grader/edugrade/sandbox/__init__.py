"""Confinement of a run, without root and without packages: `confine.py` applies the layers, and `guard.py` ends all started
processes.

The starter loads these files by their path. No run can find them, and they import nothing of edugrade.
"""

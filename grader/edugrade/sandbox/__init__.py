"""Confinement of a run, without root and without packages: `confine.py` puts the layers on, `guard.py` ends all that was started.

The starter loads these files by their path. No run can find them, and they import nothing of edugrade.
"""

"""Confinement of a run, without root and without packages: `confine.py` applies the layers, and `guard.py` ends all processes of
the run.

The starter loads these files by their paths. No run can find them, and they do not import edugrade.
"""

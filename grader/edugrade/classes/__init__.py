"""Whole classes: grade all that was handed in, hand marks to platforms, find who is alike, make a mark again.

A plug-in of the grader: it imports the grader, and the grader does not import it. Read `batch/` first, then `export/` (Moodle,
Canvas, Gradescope, GitHub Classroom), `similar.py`, `verify.py`, and `doctor.py`, which shows what confines a run here.
"""

"""Tools for whole classes: grade all submissions, export marks to platforms, find similar submissions, and verify marks.

A plug-in of the grader: it imports the grader, and the grader does not import it. Read `batch/` first, then `export/` (Moodle,
Canvas, Gradescope, GitHub Classroom), `similar.py`, `verify.py`, and `doctor.py`, which shows what confines a run here.
"""

"""Tools for whole classes: they grade all submissions, export marks to platforms, find similar submissions, and verify marks.

This package is a plug-in of the grader: it imports the grader, and the grader does not import it. Read `batch/` first, then
`export/` (Moodle, Canvas, Gradescope, GitHub Classroom), `similar.py` and `verify.py`. `sandbox_proof.py` shows what confines a
run on this computer.
"""

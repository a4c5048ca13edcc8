"""The command ``edugrade batch``, which grades whole classes.

Read `entries.py` first, which finds the submissions and their students. Then read `store.py` (results on disk), `work.py`
(grading on several processors), `tables.py` (pages and tables) and `command.py`.
"""

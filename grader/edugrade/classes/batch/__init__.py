"""Whole classes: ``edugrade batch``.

In reading order: `entries.py` (what a folder, an archive or a table holds, by whom), `store.py` (results on disk),
`work.py` (what is graded, and by whom), `tables.py` (what people read), `command.py`.
"""

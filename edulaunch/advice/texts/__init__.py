"""Check a file while the student writes it. The findings have a line, a column, and an edit if it certainly corrects the
mistake.

`check(text, path)` executes no code of the file. The function checks launch files, parameter files, package files and nodes.
It predicts errors of Python and launch as `Failure` objects. The rules for errors judge these objects as they do after a
run. Start reading in `check.py`.
"""

from __future__ import annotations

from edulaunch.advice.texts.around import Around
from edulaunch.advice.texts.check import Marked, check, kind_of, marked
from edulaunch.advice.texts.edits import Edit
from edulaunch.advice.texts.text import Span, Text

__all__ = ['Around', 'Edit', 'Marked', 'Span', 'Text', 'check', 'kind_of', 'marked']

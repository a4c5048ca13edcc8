"""Writes what a student said into the progress file of the current folder."""

from __future__ import annotations

import os
from collections.abc import Callable

from edugrade.progress_file import ProgressFile

from edulaunch.errors import UnusableInput


def keep(change: Callable[[ProgressFile], None]) -> str:
    """Change the progress file. Returns what the student must be told about it, mostly nothing.

    A file that cannot be written costs nobody an answer.
    """
    try:
        with ProgressFile.changing(os.getcwd()) as file:
            change(file)
            file.save()
    except UnusableInput as error:
        return f'This is not kept: {error.message}.'
    return file.word


def kept() -> ProgressFile:
    """The progress of the current folder."""
    return ProgressFile(os.getcwd())

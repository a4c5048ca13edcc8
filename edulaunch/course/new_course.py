"""`edulaunch course new`: a whole course of one lesson and one exercise, to be changed into one's own."""

from __future__ import annotations

import os
import shutil

from edulaunch.errors import UnusableInput

STARTER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'starter')
"""The course that is copied: kept as files, so that it is read, run and checked as every course is."""


def new_course(folder: str) -> list[str]:
    """Make a course. Returns its files, relative to the folder.

    :raises UnusableInput: when the folder exists and is not empty, or cannot be made.
    """
    if os.path.lexists(folder) and not (os.path.isdir(folder) and not os.listdir(folder)):
        raise UnusableInput(f'{folder} is there already, and not empty', help='give the name of a folder that is not there yet')
    try:
        shutil.copytree(STARTER, folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns('__pycache__', 'my_*'))
    except OSError as error:
        raise UnusableInput(f'{folder} cannot be made: {error}') from None
    places = (os.path.join(place, name) for place, _, names in os.walk(folder) for name in names)
    return sorted(os.path.relpath(path, folder).replace(os.sep, '/') for path in places)

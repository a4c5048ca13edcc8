"""Where a course lies: the one around the current folder, a given one, or ours, which comes with edulaunch."""

from __future__ import annotations

import os

from edugrade.course import HIGHEST, MANIFEST

from edulaunch.errors import UnusableInput

LESSONS, EXERCISES = 'lessons', 'exercises'
_HERE = os.path.dirname(os.path.abspath(__file__))


def our_course() -> str:
    """The folder of the course that comes with edulaunch: inside the installed package, or the source tree."""
    inside = os.path.join(_HERE, 'ours')
    return inside if os.path.isdir(inside) else os.path.dirname(os.path.dirname(_HERE))


def manifest(folder: str) -> str | None:
    """The course.toml of a course: in its folder, or in ``exercises`` there; None when there is none."""
    places = (os.path.join(folder, MANIFEST), os.path.join(folder, EXERCISES, MANIFEST))
    return next((place for place in places if os.path.isfile(place)), None)


def given_course(folder: str) -> str:
    """The folder, when there is a course in it.

    :raises UnusableInput: when there is none.
    """
    if manifest(folder) is None:
        help = f'`edulaunch course new DIR` makes a course with all its parts; {MANIFEST} names its exercises'
        raise UnusableInput(f'there is no course in {folder}: neither {MANIFEST} nor {EXERCISES}/{MANIFEST}', help=help)
    return folder


def course_around(folder: str) -> str:
    """The course in this folder or above it, else ours."""
    above = os.path.abspath(folder)
    for _ in range(HIGHEST):
        if manifest(above) is not None and os.path.basename(above) != EXERCISES:
            return above
        above = os.path.dirname(above)
    return our_course()

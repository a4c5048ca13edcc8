"""A place in a file."""

from __future__ import annotations

import os
from typing import NamedTuple

from edulaunch.underlay_place import engine_folder


class Place(NamedTuple):
    """A file and, where it is known, a line of it (counted from 1)."""

    file: str
    line: int | None = None


def is_engine(file: str) -> bool:
    """Whether a file is code of edulaunch itself; the launch files that it ships are not."""
    return is_shipped(file) and not file.startswith(os.path.join(_engine(), 'underlay', 'share'))


def is_shipped(file: str) -> bool:
    """Whether a file came with edulaunch: nothing that a student can change."""
    return file.startswith(_engine() + os.sep)


def shipped_program(package: str, executable: str) -> str:
    """The path under which edulaunch runs a program of a package of its own."""
    return os.path.join(_engine(), 'underlay', 'lib', package, executable)


def comes_with_edulaunch(package: str) -> bool:
    """Whether edulaunch brings a package of this name."""
    return os.path.isdir(os.path.join(_engine(), 'underlay', 'share', package))


def _engine() -> str:
    return engine_folder()

"""Whose code a file is: the engine's, that of Python and its installed packages, or the student's."""

from __future__ import annotations

import os
import site
import sysconfig

ENGINE = os.path.dirname(os.path.dirname(os.path.abspath(__file__))) + os.sep
_KEPT = ('stdlib', 'platstdlib', 'purelib', 'platlib')
LIBRARIES = tuple(
    dict.fromkeys(
        os.path.join(folder, '')
        for folder in (os.path.dirname(os.__file__), *map(sysconfig.get_path, _KEPT), site.getusersitepackages())
        if folder  # a browser has no folder of the user
    )
)
"""Python's own folders. A workspace that was built has a `site-packages`, too, which is not among them."""


def is_engine(filename: str) -> bool:
    """Whether it is a file of edulaunch, or no file at all."""
    return filename.startswith((ENGINE, '<frozen', '<interface '))


def is_library(filename: str) -> bool:
    """Whether it belongs to Python or to a package that was installed for it; a student writes neither."""
    return filename.startswith(LIBRARIES) and not is_engine(filename)


def is_own(filename: str) -> bool:
    """Whether the student wrote it."""
    return not filename.startswith(('<frozen', '<interface ', ENGINE, *LIBRARIES))

"""The compiled code of a program's files."""

from __future__ import annotations

import warnings
from functools import lru_cache
from importlib.machinery import SourceFileLoader
from types import CodeType
from typing import Any


def read_script(path: str) -> CodeType:
    """The code of a script or launch file, of which Python keeps no compiled copy.

    :raises: whatever compiling raises.
    """
    with open(path, 'rb') as file:
        source = file.read()
    return _flawless(source, path, tuple(warnings.filters)) or compile(source, path, 'exec', dont_inherit=True)


@lru_cache(maxsize=64)
def _flawless(source: bytes, path: str, filters: tuple[Any, ...]) -> CodeType | None:
    """The code of a text that Python says nothing about, kept for the next run: a notebook or a grader runs a file many times.

    None for one with errors or warnings: these are to come each time. (`catch_warnings` is not used to find out: it makes
    Python forget which warnings it has shown, so that a first run would show more of them than a second one.)

    :param filters: those in force, which decide what is said.
    """
    said: list[Any] = []
    before, warnings.showwarning = warnings.showwarning, lambda *told, **more: said.append(told)
    try:
        code = compile(source, path, 'exec', dont_inherit=True)
    except Exception:
        return None
    finally:
        warnings.showwarning = before
    return None if said else code


def code_of(source: SourceFileLoader) -> CodeType:
    """The compiled code of a source file, through Python's own cache of compiled files."""
    code = source.get_code(source.name)
    assert code is not None
    return code

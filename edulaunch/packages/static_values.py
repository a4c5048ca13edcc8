"""Values while Python text is read without being run, and the few functions that may be called meanwhile."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any


class Unknown:
    """A value that cannot be known without running the file; remembers where it came from.

    :param line: where in the file.
    :param why: what could not be followed, as source text.
    """

    def __init__(self, line: int, why: str) -> None:
        self.line = line
        self.why = why


class Module:
    """The name of an imported module, standing for the module itself."""

    def __init__(self, name: str) -> None:
        self.name = name


def first_unknown(value: Any) -> Unknown | None:
    """The first Unknown anywhere inside `value`."""
    if isinstance(value, Unknown):
        return value
    if isinstance(value, dict):
        value = [*value.keys(), *value.values()]
    if isinstance(value, list | tuple | set):
        return next((found for item in value if (found := first_unknown(item)) is not None), None)
    return None


def callables(folder: str) -> dict[str, Callable[..., Any]]:
    """The functions that setup.py files use to list their files, with relative paths meaning `folder`."""

    def local(path: Any) -> str:
        return os.path.join(folder, os.fspath(path))

    def glob(pattern: str, recursive: bool = False) -> list[str]:
        from glob import glob as real_glob

        found = sorted(real_glob(local(pattern), recursive=recursive))
        return found if os.path.isabs(pattern) else [os.path.relpath(path, folder) for path in found]

    def walk(top: str) -> list[tuple[str, list[str], list[str]]]:
        found = sorted((path, sorted(folders), sorted(files)) for path, folders, files in os.walk(local(top)))
        return [
            (
                path
                if os.path.isabs(top)
                else os.path.normpath(os.path.join(top, os.path.relpath(path, local(top)))),
                folders,
                files,
            )
            for path, folders, files in found
        ]

    return {
        'glob.glob': glob,
        'glob.iglob': glob,
        'os.walk': walk,
        'os.listdir': lambda path='.': sorted(os.listdir(local(path))),
        'os.getcwd': lambda: folder,
        'pathlib.Path': lambda *parts: os.path.join(*parts) if parts else '.',
        'os.path.join': os.path.join,
        'os.path.basename': os.path.basename,
        'os.path.dirname': os.path.dirname,
        'os.path.splitext': os.path.splitext,
        'os.path.split': os.path.split,
        'os.path.normpath': os.path.normpath,
        'os.path.relpath': lambda path, start='.': os.path.relpath(local(path), local(start)),
        'os.path.abspath': lambda path: os.path.normpath(local(path)),
        'os.path.realpath': lambda path: os.path.realpath(local(path)),
        'os.path.exists': lambda path: os.path.exists(local(path)),
        'os.path.isfile': lambda path: os.path.isfile(local(path)),
        'os.path.isdir': lambda path: os.path.isdir(local(path)),
        'setuptools.find_packages': lambda where='.', exclude=(), include=('*',): find_packages(
            local(where), exclude, include
        ),
        'setuptools.find_namespace_packages': lambda where='.', exclude=(), include=('*',): find_packages(
            local(where), exclude, include, ''
        ),
        'str': str,
        'list': list,
        'tuple': tuple,
        'set': set,
        'sorted': sorted,
        'len': len,
        'dict': dict,
        'zip': lambda *a: list(zip(*a, strict=False)),
        'enumerate': lambda items: list(enumerate(items)),
        'sum': sum,
        'int': int,
        'bool': bool,
    }


METHODS: dict[type, frozenset[str]] = {
    str: frozenset(
        (
            'format',
            'join',
            'replace',
            'strip',
            'lstrip',
            'rstrip',
            'split',
            'splitlines',
            'startswith',
            'endswith',
            'lower',
            'upper',
            'removeprefix',
            'removesuffix',
        )
    ),
    list: frozenset(('append', 'extend', 'insert', 'copy', 'index', 'count', 'remove')),
    dict: frozenset(('items', 'keys', 'values', 'get', 'setdefault', 'update', 'copy')),
    set: frozenset(('add', 'update')),
}
"""Methods of plain values that may be called while reading."""


def find_packages(
    where: str, exclude: Any = (), include: Any = ('*',), marker: str = '__init__.py'
) -> list[str]:
    """setuptools' find_packages: dotted names of the folders below `where` that hold `marker`."""
    from fnmatch import fnmatchcase

    names = []
    for path, folders, _ in os.walk(where):
        folders[:] = sorted(
            name
            for name in folders
            if name.isidentifier()
            and os.path.isfile(os.path.join(path, name, marker))
            or not marker
            and name.isidentifier()
        )
        names += [os.path.relpath(os.path.join(path, name), where).replace(os.sep, '.') for name in folders]
    return sorted(
        name
        for name in names
        if any(fnmatchcase(name, pattern) for pattern in include)
        and not any(fnmatchcase(name, pattern) for pattern in exclude)
    )

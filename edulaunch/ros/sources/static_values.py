"""Values for the static evaluation of Python text, and the few functions that it may call."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import Any


class Unknown:
    """A value that is not known without running the file, with the place of its expression.

    :param line: the line in the file.
    :param why: the source text that could not be evaluated.
    """

    def __init__(self, line: int, why: str) -> None:
        self.line = line
        self.why = why


class Module:
    """An imported module, represented by its name."""

    def __init__(self, name: str) -> None:
        self.name = name


def first_unknown(value: Any) -> Unknown | None:
    """Return the first Unknown anywhere inside `value`, or None if `value` is known."""
    if isinstance(value, Unknown):
        return value
    if isinstance(value, dict):
        value = [*value.keys(), *value.values()]
    if isinstance(value, list | tuple | set):
        return next((found for item in value if (found := first_unknown(item)) is not None), None)
    return None


class PathText(str):
    """A `pathlib.Path` in the evaluated text. It may be relative to the package's folder."""

    folder: str

    @classmethod
    def below(cls, folder: str, *parts: str) -> PathText:
        """Return the path with these parts, relative to `folder`."""
        made = cls(os.path.join(*parts) if parts else '.')
        made.folder = folder
        return made

    def __truediv__(self, part: str) -> PathText:
        return self.joinpath(part)

    def joinpath(self, *parts: str) -> PathText:
        """Return the joined path, as `Path.joinpath` does."""
        return self.below(self.folder, self, *parts)

    def glob(self, pattern: str) -> list[PathText]:
        """Return the matching paths as `Path.glob` does, sorted."""
        return self._listed(pattern)

    def rglob(self, pattern: str) -> list[PathText]:
        """Return the matching paths as `Path.rglob` does, sorted."""
        return self._listed(os.path.join('**', pattern))

    def iterdir(self) -> list[PathText]:
        """Return the content of the folder as `Path.iterdir` does, sorted."""
        return self._listed('*')

    def _listed(self, pattern: str) -> list[PathText]:
        from glob import glob as real_glob

        found = sorted(real_glob(pattern, root_dir=os.path.join(self.folder, self), recursive=True))
        return [self.joinpath(name) for name in found]

    def is_file(self) -> bool:
        """Return whether the path is a file, as `Path.is_file` does."""
        return os.path.isfile(os.path.join(self.folder, self))

    def is_dir(self) -> bool:
        """Return whether the path is a folder, as `Path.is_dir` does."""
        return os.path.isdir(os.path.join(self.folder, self))

    def exists(self) -> bool:
        """Return whether the path exists, as `Path.exists` does."""
        return os.path.exists(os.path.join(self.folder, self))

    def relative_to(self, other: str) -> PathText:
        """Return the path relative to a folder above it, as `Path.relative_to` does."""
        return self.below(self.folder, os.path.relpath(self, other))

    def as_posix(self) -> str:
        """Return the path with forward slashes, as `Path.as_posix` does."""
        return str(self)

    def resolve(self) -> PathText:
        """Return the absolute path, as `Path.resolve` does, but without following symbolic links."""
        return self.below(self.folder, os.path.normpath(os.path.join(self.folder, self)))

    absolute = resolve

    @property
    def parent(self) -> PathText:
        """The folder that contains the path, as in `Path`."""
        return self.below(self.folder, os.path.dirname(self) or '.')

    @property
    def parents(self) -> list[PathText]:
        """The folders above the path, as in `Path`."""
        above = self.parent
        return [above] if above in ('.', os.sep) else [above, *above.parents]

    @property
    def name(self) -> str:
        """The last part of the path, as in `Path`."""
        return os.path.basename(self)

    @property
    def stem(self) -> str:
        """The last part of the path without its suffix, as in `Path`."""
        return os.path.splitext(self.name)[0]

    @property
    def suffix(self) -> str:
        """The suffix of the path, as in `Path`."""
        return os.path.splitext(self.name)[1]


PATH_ATTRIBUTES = frozenset(('parent', 'parents', 'name', 'stem', 'suffix'))
PURE: dict[str, Callable[..., Any]] = {
    'os.path.join': os.path.join,
    'os.path.basename': os.path.basename,
    'os.path.dirname': os.path.dirname,
    'os.path.splitext': os.path.splitext,
    'os.path.split': os.path.split,
    'os.path.normpath': os.path.normpath,
    'str': str,
    'int': int,
    'bool': bool,
    'list': list,
    'tuple': tuple,
    'set': set,
    'dict': dict,
    'sorted': sorted,
    'len': len,
    'range': lambda *limits: list(range(*limits)),
    'reversed': lambda items: list(reversed(items)),
    'sum': sum,
    'any': any,
    'all': all,
    'min': min,
    'max': max,
    'zip': lambda *columns: list(zip(*columns, strict=False)),
    'enumerate': lambda items: list(enumerate(items)),
}
"""Functions that the evaluation may call, because they only use their arguments."""


def callables(folder: str) -> dict[str, Callable[..., Any]]:
    """Return the functions that setup.py files use to list their files. Relative paths start at `folder`."""
    listing = _Listing(folder)
    local = listing.local
    table: dict[str, Callable[..., Any]] = {
        **PURE,
        'pathlib.Path': lambda *parts: PathText.below(folder, *parts),
        'pathlib.Path.cwd': lambda: PathText.below(folder, folder),
        'map': lambda function, *columns: list(map(function, *columns)),
        'filter': lambda function, items: list(filter(function, items)),
        'glob.glob': listing.glob,
        'glob.iglob': listing.glob,
        'os.walk': listing.walk,
        'os.listdir': lambda path='.': sorted(os.listdir(local(path))),
        'os.getcwd': lambda: folder,
        'os.path.relpath': lambda path, start='.': os.path.relpath(local(path), local(start)),
        'os.path.abspath': lambda path: os.path.normpath(local(path)),
        'os.path.realpath': lambda path: os.path.realpath(local(path)),
        'os.path.exists': lambda path: os.path.exists(local(path)),
        'os.path.isfile': lambda path: os.path.isfile(local(path)),
        'os.path.isdir': lambda path: os.path.isdir(local(path)),
        'setuptools.find_packages': listing.find_packages,
        'setuptools.find_namespace_packages': listing.find_namespace_packages,
    }
    return table


class _Listing:
    """Lists files below a folder, sorted, so that the result is the same on every computer."""

    def __init__(self, folder: str) -> None:
        self._folder = folder

    def local(self, path: Any) -> str:
        """Return a path. If it is relative, it starts at the folder."""
        return os.path.join(self._folder, os.fspath(path))

    def glob(self, pattern: str, recursive: bool = False) -> list[str]:
        """Return paths as glob.glob does."""
        from glob import glob as real_glob

        found = sorted(real_glob(self.local(pattern), recursive=recursive))
        return found if os.path.isabs(pattern) else [os.path.relpath(path, self._folder) for path in found]

    def walk(self, top: str) -> list[tuple[str, list[str], list[str]]]:
        """Return folders as os.walk yields them, sorted."""
        start = self.local(top)
        found = sorted((path, sorted(folders), sorted(files)) for path, folders, files in os.walk(start))
        return [
            (os.path.normpath(os.path.join(top, os.path.relpath(path, start))), folders, files) for path, folders, files in found
        ]

    def find_packages(self, where: str = '.', exclude: Any = (), include: Any = ('*',)) -> list[str]:
        """Return names as setuptools.find_packages does."""
        return find_packages(self.local(where), exclude, include)

    def find_namespace_packages(self, where: str = '.', exclude: Any = (), include: Any = ('*',)) -> list[str]:
        """Return names as setuptools.find_namespace_packages does."""
        return find_packages(self.local(where), exclude, include, '')


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
    PathText: frozenset(
        ('glob', 'rglob', 'iterdir', 'joinpath', 'is_file', 'is_dir', 'exists', 'relative_to', 'as_posix', 'resolve', 'absolute')
    ),
    list: frozenset(('append', 'extend', 'insert', 'copy', 'index', 'count', 'remove')),
    dict: frozenset(('items', 'keys', 'values', 'get', 'setdefault', 'update', 'copy')),
    set: frozenset(('add', 'update')),
}
"""Methods of plain values that the evaluation may call."""


def find_packages(where: str, exclude: Any = (), include: Any = ('*',), marker: str = '__init__.py') -> list[str]:
    """Return the dotted names of the folders below `where` that contain `marker`, as setuptools' find_packages does."""
    from fnmatch import fnmatchcase

    names = []
    for path, folders, _ in os.walk(where):
        folders[:] = sorted(
            name
            for name in folders
            if name.isidentifier() and os.path.isfile(os.path.join(path, name, marker)) or not marker and name.isidentifier()
        )
        names += [os.path.relpath(os.path.join(path, name), where).replace(os.sep, '.') for name in folders]
    return sorted(
        name
        for name in names
        if any(fnmatchcase(name, pattern) for pattern in include) and not any(fnmatchcase(name, pattern) for pattern in exclude)
    )

"""Relative paths in `os`, `os.path` and `io` for a program that has its own working folder."""

from __future__ import annotations

import io
import os
import sys
from collections.abc import Callable, Iterator
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.frame_owner import is_own
from edulaunch.engine.processes.module_views import copy_names
from edulaunch.engine.processes.real_machine import note_use
from edulaunch.engine.sim.task import current_task

if TYPE_CHECKING:
    from types import FrameType

    from edulaunch.engine.processes.process import Process

TIMES = frozenset(f'st_{kind}time{unit}' for kind in 'acm' for unit in ('', '_ns'))
"""The fields of `os.stat` with a time, which depends on the real computer."""


class Entry:
    """An `os.DirEntry` of a folder whose path is relative to the program's working folder."""

    __slots__ = ('_entry', 'path')

    def __init__(self, entry: Any, path: Any) -> None:
        self._entry = entry
        self.path = path

    def __getattr__(self, name: str) -> Any:
        return getattr(self._entry, name)

    def __fspath__(self) -> Any:
        return self.path

    def __repr__(self) -> str:
        return repr(self._entry)


class Listing:
    """The result of `os.scandir`: an iterator that can be closed.

    The entries are in alphabetical order, because the order in a real folder differs between computers.

    :param shown: the path of the folder as the program wrote it.
    :param folder: the path relative to the real working folder.
    """

    def __init__(self, shown: Any, folder: Any) -> None:
        self._shown = os.fspath(shown)
        self._is_moved = shown is not folder
        with os.scandir(folder) as entries:
            self._entries: Iterator[Any] = iter(sorted(entries, key=lambda entry: entry.name))

    def __iter__(self) -> Iterator[Entry]:
        return self

    def __next__(self) -> Any:
        entry = next(self._entries)
        return Entry(entry, os.path.join(self._shown, entry.name)) if self._is_moved else entry

    def __enter__(self) -> Listing:
        return self

    def __exit__(self, *_: object) -> None:
        self.close()

    def close(self) -> None:
        """End the iteration."""
        self._entries = iter(())


ONE_PATH = (
    'access',
    'chmod',
    'makedirs',
    'mkdir',
    'open',
    'readlink',
    'remove',
    'removedirs',
    'rmdir',
    'truncate',
    'unlink',
    'utime',
)
TWO_PATHS = ('link', 'rename', 'renames', 'replace')
QUESTIONS = ('abspath', 'exists', 'getsize', 'isdir', 'isfile', 'islink', 'ismount', 'lexists', 'realpath')


def inside(path: Any) -> Any:
    """Return a path for the real file system. A relative path of the running program starts in the program's own working
    folder.
    """
    folder = current_task().owner.cwd
    if folder is None or isinstance(path, int):
        return path
    return os.path.join(os.fsencode(folder) if isinstance(path, bytes) else folder, path)


class PlainFunction:
    """A function that does not become a method when it is an attribute of a class, like functions in C. `pathlib` relies on
    this.
    """

    def __init__(self, function: Callable[..., Any]) -> None:
        self._function = function
        self.__name__, self.__doc__ = function.__name__, function.__doc__

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        return self._function(*arguments, **options)


class Relative(PlainFunction):
    """A function of the real module that gets the running program's paths relative to the program's working folder.

    :param function: the function of the real module.
    :param paths: the number of leading arguments that are paths.
    """

    def __init__(self, function: Callable[..., Any], paths: int = 1) -> None:
        super().__init__(function)
        self._paths = paths

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        if current_task().owner.cwd is None:
            return self._function(*arguments, **options)
        paths = self._paths
        return self._function(*map(inside, arguments[:paths] or ('.',)), *arguments[paths:], **options)


class Stat(Relative):
    """`os.stat` or `os.lstat`."""

    def __call__(self, *arguments: Any, **options: Any) -> Any:
        _note_times()
        return super().__call__(*arguments, **options)


def _note_times() -> None:
    """Record that the calling function of the student's code reads a time of a file, if the function names such a field."""
    frame: FrameType | None = sys._getframe(2)
    while frame is not None and not is_own(frame.f_code.co_filename):
        frame = frame.f_back
    for name in sorted(TIMES.intersection(frame.f_code.co_names if frame else ())):
        note_use(current_task().owner, f'{name} of a file')


def _scandir(path: Any = '.') -> Any:
    _note_times()
    return os.scandir(path) if isinstance(path, int) else Listing(path, inside(path))


def _listdir(path: Any = '.') -> Any:
    return sorted(os.listdir(inside(path)))


def _walk(top: Any, topdown: bool = True, onerror: Any = None, followlinks: bool = False) -> Iterator[tuple[Any, Any, Any]]:
    if not topdown:
        yield from reversed([*_walk(top, True, onerror, followlinks)])
        return
    start = inside(top)
    for folder, folders, files in os.walk(start, True, onerror, followlinks):
        folders.sort()  # os.walk enters the folders in the order of this list
        files.sort()
        yield folder if start == top else os.path.join(top, os.path.relpath(folder, start)).removesuffix('/.'), folders, files


FUNCTIONS: dict[str, Callable[..., Any]] = {
    **{name: Relative(getattr(os, name)) for name in ONE_PATH if hasattr(os, name)},
    **{name: Stat(getattr(os, name)) for name in ('stat', 'lstat')},
    **{name: Relative(getattr(os, name), 2) for name in TWO_PATHS if hasattr(os, name)},
    'listdir': PlainFunction(_listdir),
    'walk': _walk,
    'scandir': PlainFunction(_scandir),
}
"""Functions for the view of `os`, which are the same for all programs."""


def _recorded_time(name: str) -> Callable[[Any], float]:
    """Return a function such as `getmtime` that records its use, because its result depends on the real computer."""

    def time_of(path: Any) -> float:
        note_use(current_task().owner, f'os.path.{name}')
        found: float = getattr(os.path, name)(inside(path))
        return found

    return time_of


def _relpath(path: Any, start: Any = os.curdir) -> Any:
    return os.path.relpath(inside(path), inside(start))


def _expanduser(path: Any) -> Any:
    text, home = os.fspath(path), current_task().owner.env.get('HOME')
    if home and isinstance(text, str) and (text == '~' or text.startswith('~/')):
        return home + text[1:]
    return os.path.expanduser(text)


def _make_path() -> ModuleType:
    view = ModuleType(os.path.__name__)
    view.__dict__.update(
        {name: Relative(getattr(os.path, name)) for name in QUESTIONS},
        **{name: _recorded_time(name) for name in ('getatime', 'getctime', 'getmtime')},
        relpath=_relpath,
        expanduser=_expanduser,
        __edulaunch_view__=True,
    )
    copy_names(view, os.path)
    return view


PATH = _make_path()
"""The view of `os.path`, which all programs share: its functions use the folder of the calling program."""


def make_path(view: ModuleType, process: Process) -> ModuleType:
    """Return `PATH`, the view of `os.path` that all programs share."""
    return PATH


def make_io(view: ModuleType, process: Process) -> ModuleType:
    """Make `io.open` the program's own `open`. `pathlib` uses it, too."""
    view.__dict__['open'] = PlainFunction(process.loader.builtins['open'])
    copy_names(view, io)
    return view

"""The computer as a launch file sees it in a dry run. Changes that the launch file would make are recorded, but not made.

A Python launch file is a program, and a dry run executes it. Programs that the launch file starts itself seem to end immediately
(`rehearsal.py`). The dry run stores the files that the launch file writes separately: the launch file can read them again, but
no other program can. Other changes seem to succeed. Libraries do not use the views of a simulated program, so Python's audit
events refuse their changes.
"""

from __future__ import annotations

import errno
import os
import re
import shutil
import socket
import sys
from collections.abc import Callable
from contextlib import suppress
from types import FrameType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.processes.frame_owner import is_library, is_own
from edulaunch.engine.processes.module_views.file_views import PlainFunction
from edulaunch.engine.processes.real_machine import REPEATS, VIEWS
from edulaunch.engine.sim.task import running_task

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

FOLDERS = ('makedirs', 'mkdir')
CHANGES = {
    **dict.fromkeys(('remove', 'unlink'), 'remove {}'),
    **dict.fromkeys(('removedirs', 'rmdir'), 'remove the folder {}'),
    **dict.fromkeys(FOLDERS, 'make the folder {}'),
    **dict.fromkeys(('rename', 'renames', 'replace'), 'rename {}'),
    **dict.fromkeys(('chmod', 'chown', 'lchown', 'truncate', 'utime'), 'change {}'),
    **dict.fromkeys(('link', 'mkfifo', 'mknod', 'symlink'), 'make {}'),
}
"""Functions of `os` that change files, with the text of the note about each."""
TWO_PATHS = ('link', 'rename', 'renames', 'replace', 'symlink')
STARTS = frozenset(('os.exec', 'os.fork', 'os.posix_spawn', 'os.startfile', 'os.system', 'subprocess.Popen'))
SPAWNS = tuple(f'spawn{ending}' for ending in ('l', 'le', 'lp', 'lpe', 'v', 've', 'vp', 'vpe'))
NETWORK = frozenset(('socket.connect', 'socket.sendto'))
OF_C = re.compile(
    r'chmod|creat|exec\w+|fopen|v?fork|kill|link|mkdir|open(64|at)?|popen|posix_spawnp?|remove|rename|rmdir|symlink|syscall|system'
    r'|truncate|unlink|write'
)
"""Functions of the C library that start or change something. `ctypes` reports the search for a function, and not its call."""
TEMPORARY = frozenset(('tempfile.mkdtemp', 'tempfile.mkstemp'))
EVENTS = {
    **{f'os.{name}': text for name, text in CHANGES.items()},
    **dict.fromkeys(STARTS, 'start {}'),
    **dict.fromkeys(NETWORK, 'connect to {}'),
    'ctypes.dlsym': 'call the function {} of the C library',
    'open': 'write {}',
    'sqlite3.connect': 'write {}',
}
"""Audit events of actions that change something."""
WRITING = os.O_WRONLY | os.O_RDWR | os.O_CREAT | os.O_TRUNC | os.O_APPEND
NOWHERE = getattr(os, 'O_TMPFILE', 0)
"""The flag for a file without a name, which no other program can see."""
OPEN = open
"""Kept by its own name, because Python removes `open` from the builtins before the last objects of a program end."""
_hearing = False


class Closed:
    """Prevents the changes that the programs of one dry run would make.

    :ivar notes: the changes that were not made, without repetitions, such as 'run the command touch x' or 'write /tmp/x'.
    """

    def __init__(self) -> None:
        self.notes: list[str] = []
        self._copies: dict[str, str] = {}
        self._folders: set[str] = set()
        self._temporary: list[str] = []
        self._room = ''
        self._is_over = False

    def note(self, text: str) -> None:
        """Record a change that was not made."""
        if text not in self.notes:
            self.notes.append(text)

    def enter(self, process: Process) -> None:
        """Replace the functions of a program that change the computer by functions that change nothing."""
        global _hearing
        if not _hearing:
            _hearing = True
            sys.addaudithook(_hear)
        builtins = process.loader.builtins
        builtins['open'] = self._opener(process, builtins['open'])
        view = process.loader.import_module('os')
        for name in CHANGES:
            if hasattr(view, name):
                setattr(view, name, PlainFunction(self._unchanged(process, name, getattr(view, name))))
        for name in filter(lambda name: hasattr(view, name), SPAWNS):
            setattr(view, name, PlainFunction(self._not_spawned(name)))

    def _not_spawned(self, name: str) -> Callable[..., int]:
        def spawn(mode: int, file: Any, *arguments: Any) -> int:
            words = arguments[0] if name.startswith('spawnv') else arguments[: -1 if name.endswith('e') else None]
            self.note(f'run the command {" ".join(map(os.fsdecode, words))}')
            return 0 if mode == os.P_WAIT else os.getpid()

        spawn.__name__ = name
        return spawn

    def _opener(self, process: Process, real_open: Callable[..., Any]) -> Callable[..., Any]:
        def open_copy(file: Any, mode: str = 'r', *arguments: Any, **options: Any) -> Any:
            if isinstance(file, int):
                return real_open(file, mode, *arguments, **options)
            path = os.path.abspath(process.path(os.fsdecode(file)))
            # `tempfile` passes a folder here, and then creates a file in it
            if not set(mode) & set('wax+') or self._may_change(path) or os.path.isdir(path):
                return real_open(self._copies.get(path, file), mode, *arguments, **options)
            return OPEN(self._copy(path, mode), mode.replace('x', 'w'), *arguments, **options)

        return open_copy

    def _copy(self, path: str, mode: str) -> str:
        """Return the path of the separate file that the program writes instead of the file at `path`."""
        folder = os.path.dirname(path)
        if not (os.path.isdir(folder) or folder in self._folders):
            raise FileNotFoundError(errno.ENOENT, os.strerror(errno.ENOENT), path)
        if 'x' in mode and os.path.exists(path):
            raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), path)
        self.note(f'write {path}')
        if self._is_over:
            return os.devnull
        if path not in self._copies:
            import tempfile

            self._room = self._room or tempfile.mkdtemp(prefix='edulaunch-dry-run-')
            self._copies[path] = os.path.join(self._room, str(len(self._copies)))
            if os.path.isfile(path):
                shutil.copyfile(path, self._copies[path])
        return self._copies[path]

    def _unchanged(self, process: Process, name: str, real: Callable[..., Any]) -> Callable[..., Any]:
        def seem(path: Any, *arguments: Any, **options: Any) -> None:
            place = os.path.abspath(process.path(os.fsdecode(path))) if not isinstance(path, int) else str(path)
            second = [os.path.abspath(process.path(os.fsdecode(one))) for one in arguments[:1] if name in TWO_PATHS]
            if all(map(self._may_change, (place, *second))) or _finds_temporary_folder():
                real(path, *arguments, **options)
                return
            if name in FOLDERS:
                if os.path.lexists(place) and not (os.path.isdir(place) and options.get('exist_ok')):
                    raise FileExistsError(errno.EEXIST, os.strerror(errno.EEXIST), place)
                self._folders.add(place)
                if os.path.isdir(place):
                    return
            self.note(CHANGES[name].format(second[0] if name in ('link', 'symlink') else place))

        seem.__name__ = name
        return seem

    def _may_change(self, path: str) -> bool:
        """Return whether a path is a device, or a temporary file that the program created itself."""
        own = (*self._temporary, *([self._room] if self._room else ()))
        return path in REPEATS or any(path == place or path.startswith(place + os.sep) for place in own)

    def hear(self, event: str, arguments: tuple[Any, ...]) -> None:
        """Check an action that a library is about to do for the student's program.

        :param event: the name of the audit event.
        :param arguments: the arguments of the audit event.
        :raises PermissionError: when the action would change something.
        """
        what = arguments[1 if event in NETWORK or event == 'ctypes.dlsym' else 0] if arguments else ''
        is_path = event not in STARTS and event != 'ctypes.dlsym' and isinstance(what, (str, bytes, os.PathLike))
        path = os.path.abspath(os.fsdecode(what)) if is_path else _address(what)
        if event in TEMPORARY:
            if not os.path.lexists(path):  # if the path exists, `tempfile` tries another name
                self._temporary.append(path)
        elif event == 'socket.connect' and arguments[0].type == socket.SOCK_DGRAM:
            return  # this sends nothing; programs use it to find the address of this computer
        elif event in ('open', 'os.remove') and _finds_temporary_folder():
            return
        elif event in STARTS or not self._may_change(path) or not all(map(self._may_change, _second_path(event, arguments))):
            link = _second_path(event, arguments)[-1:] if event in ('os.link', 'os.symlink') else []
            text = EVENTS[event].format(_command(arguments) if event in STARTS else (link or [path])[0])
            self.note(text)
            raise with_facts(PermissionError(errno.EPERM, 'not done in a dry run', path), 'launch.not-in-dry-run', undone=text)

    def close(self) -> None:
        """Remove the separate files and the temporary files of the programs.

        Later writes at the exit of Python have no effect.
        """
        self._is_over = True
        for path in filter(None, (self._room, *self._temporary)):
            with suppress(OSError):
                os.remove(path) if os.path.isfile(path) else shutil.rmtree(path)


def _finds_temporary_folder() -> bool:
    """Return whether `tempfile` is looking for a folder in which it may write. It does this once in a process."""
    frame: FrameType | None = sys._getframe(2)
    while frame is not None and frame.f_code.co_name != '_get_default_tempdir':
        frame = frame.f_back if not is_own(frame.f_code.co_filename) else None
    return frame is not None


def _second_path(event: str, arguments: tuple[Any, ...]) -> list[str]:
    """Return a list with the target of a rename or link. Return an empty list for any other audit event."""
    is_pair = event.removeprefix('os.') in TWO_PATHS
    return [os.path.abspath(os.fsdecode(one)) for one in arguments[1:2] if is_pair and isinstance(one, (str, bytes, os.PathLike))]


def _address(what: Any) -> str:
    """Return the address of a socket as 'host:port', and any other value as a string."""
    is_pair = isinstance(what, tuple) and len(what) >= 2
    return f'{what[0]}:{what[1]}' if is_pair else os.fsdecode(what) if isinstance(what, bytes) else str(what)


def _command(arguments: tuple[Any, ...]) -> str:
    """Return the command line in the arguments of an audit event."""
    words = arguments[1] if len(arguments) > 1 and arguments[1] else arguments[:1]
    return ' '.join(map(os.fsdecode, words)) if isinstance(words, (list, tuple)) else str(words)


def _hear(event: str, arguments: tuple[Any, ...]) -> None:
    if event not in EVENTS and event not in TEMPORARY:
        return
    if (event == 'open' and not _writes(arguments)) or (event == 'ctypes.dlsym' and not OF_C.fullmatch(str(arguments[1]))):
        return
    if arguments[:1] == (os.devnull,):  # also at the exit of Python, when no tasks exist any more
        return
    task = running_task()
    closed = getattr(getattr(getattr(task, 'owner', None), 'host', None), 'closed', None)
    if isinstance(closed, Closed) and _is_students():
        closed.hear(event, arguments)


def _writes(arguments: tuple[Any, ...]) -> bool:
    path, _, flags = (*arguments, None, None, None)[:3]
    if not isinstance(path, (str, bytes)) or not isinstance(flags, int) or os.path.isdir(path):
        return False  # `tempfile` passes a folder here, and then creates a file in it
    if flags & os.O_EXCL and os.path.lexists(path):
        return False  # the file exists, so the call fails anyway
    return bool(flags & WRITING) and not (NOWHERE and flags & NOWHERE == NOWHERE)


def _is_students() -> bool:
    """Return whether the student's code made this call, directly or through libraries."""
    frame: FrameType | None = sys._getframe(2)
    while frame is not None:
        file = frame.f_code.co_filename
        if is_own(file):
            return True
        if not is_library(file) and not file.startswith((VIEWS, __file__)):
            return False
        frame = frame.f_back
    return False

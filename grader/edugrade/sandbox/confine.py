"""Applies all layers of confinement to this process, and reports which layers hold."""

from __future__ import annotations

import ctypes
import os
import socket
from collections.abc import Callable, Sequence

from . import landlock, seccomp, view
from .allowance import VIEW
from .system import FAULTS, IS_LINUX, PR_CAPBSET_DROP, PR_SET_NO_NEW_PRIVS, libc, prctl

HELD = 'held'
LAYERS = {
    'files': 'it reads only what it needs, and writes only in its own folder',
    'network': 'it opens no socket',
    'signals': 'it signals only what it started itself',
    'processes': 'it cannot look into other processes, and nothing of it outlives the run',
    'privileges': 'it has no rights of root, and gains none',
}
CAP_DAC_READ_SEARCH = 2
LAST_CAPABILITY = 63
DEVICES = ('/dev/null', '/dev/zero', '/dev/full', '/dev/urandom', '/dev/random', '/dev/tty')


class Confinement:
    """The confinement of every run, prepared once.

    :param readable: the paths that all runs may read.
    :param listable: the directories whose names all runs may list, without reading the files.
    :param shown: the part of the file system that all runs see.
    :param hidden: directories in `shown` that appear empty.
    """

    def __init__(
        self, readable: Sequence[str], listable: Sequence[str], shown: Sequence[str] = (), hidden: Sequence[str] = ()
    ) -> None:
        self._programs = {
            (has_listener, has_view): seccomp.filter_program(has_listener, has_view) if IS_LINUX else None
            for has_listener in (False, True)
            for has_view in (False, True)
        }
        self._has_view = False
        self._shown, self._hidden = [*shown, *DEVICES], hidden
        can = landlock.version() > 0
        self._readable = landlock.open_paths(readable) if can else []
        self._listable = landlock.open_paths(listable) if can else []
        self._devices = landlock.open_paths(DEVICES) if can else []

    def narrow_view(self, readable: Sequence[str], home: str) -> dict[str, str]:
        """Hide all files and folders that this process may not read. Return {VIEW: HELD}, or the reason of the failure instead
        of HELD.

        :param readable: the paths that this run may read in addition.
        :param home: the private folder of the run.
        """
        narrowed = _tried(lambda: view.enter(home, [*self._shown, *readable], self._hidden))
        os.chdir(home)
        self._has_view = not isinstance(narrowed, str)
        return {VIEW: narrowed if isinstance(narrowed, str) else HELD}

    def put_on(self, readable: Sequence[str], home: str, notes: socket.socket | None = None) -> dict[str, str]:
        """Confine this process permanently. Return HELD, or the reason of its failure, for each of LAYERS.

        :param readable: the paths that this run may read in addition, such as its submission.
        :param home: the only folder to which the run may write.
        :param notes: the socket of the guard, which receives each refused call, or None.
        """
        state = dict.fromkeys(LAYERS, HELD)
        privileges = _tried(lambda: prctl(PR_SET_NO_NEW_PRIVS, 1))
        files = _tried(lambda: self._restrict_files(readable, home))
        if isinstance(privileges, str) or isinstance(files, str):
            state['files'] = state['signals'] = str(files)
        elif files < 6:
            state['signals'] = f'this kernel has version {files} of Landlock, and signals need 6'
        dropped = _tried(lambda: _drop_capabilities(keep_reading=state['files'] == HELD))
        if isinstance(privileges, str) or isinstance(dropped, str):
            state['privileges'] = str(privileges if isinstance(privileges, str) else dropped)
        filtered = _tried(lambda: self._filter_calls(notes))
        if isinstance(filtered, str):
            state['network'] = state['processes'] = filtered
        return state

    def let_go(self) -> None:
        """Close the descriptors of the paths. With many installed packages, there are more of them than a run may have open."""
        for descriptor in (*self._readable, *self._listable, *self._devices):
            os.close(descriptor)

    def _restrict_files(self, readable: Sequence[str], home: str) -> int:
        rules = [
            (self._readable, landlock.READ),
            (landlock.open_paths(readable), landlock.READ),
            (self._listable, landlock.READ_DIR),
            ([*self._devices, *landlock.open_paths(DEVICES)], landlock.OF_DEVICES),  # the view may have its own nodes
            (landlock.open_paths([home]), landlock.EVERYTHING),
        ]
        return landlock.restrict(rules)

    def _filter_calls(self, notes: socket.socket | None) -> int:
        quiet, listened = (self._programs[has_listener, self._has_view] for has_listener in (False, True))
        if quiet is None or listened is None:
            raise OSError('no filter of system calls is known for this machine')
        if notes is not None:
            try:
                listener = seccomp.restrict_with_listener(listened)
            except OSError:  # on an old kernel, or under a tracer, calls are refused without a name
                pass
            else:
                socket.send_fds(notes, [b'L'], [listener])
                os.close(listener)
                return 0
        seccomp.restrict(quiet)
        return 0


def _tried(act: Callable[[], int | None]) -> int | str:
    """Call a function, and return its result as a number, or the reason as a string if it fails.

    :raises OSError: if the computer now lacks a resource, or its disk fails. A run must not continue without a layer for this
        reason.
    """
    try:
        return act() or 0
    except OSError as error:
        if error.errno in FAULTS:
            raise
        return error.strerror or str(error)


def _drop_capabilities(keep_reading: bool) -> int:
    """Remove root's capabilities from this process and its children.

    :param keep_reading: whether to keep the capability to read files of other users. Grading needs it, and it is safe only if
        files are confined.
    """
    kept = 1 << CAP_DAC_READ_SEARCH if keep_reading else 0
    for capability in range(LAST_CAPABILITY + 1):
        if not kept >> capability & 1:
            try:
                prctl(PR_CAPBSET_DROP, capability)
            except OSError:  # there are no more capabilities, or the process is not root
                break
    header = (ctypes.c_uint32 * 2)(0x20080522, 0)
    current = (ctypes.c_uint32 * 6)()
    libc.capget(header, current)
    now = kept & current[1]
    wanted = (ctypes.c_uint32 * 6)(now, now, 0, 0, 0, 0)
    if libc.capset(header, wanted) != 0:
        raise OSError('the rights of root could not be dropped')
    return 0

"""Gives a run its own tree of directories, without the files that it may not read, and without their names and sizes.

The tree needs a mount namespace. Root may create one, and ordinary users may if the system lets them create user namespaces.
The tree is a file system in memory, in which readable paths are mounted. All of it is read-only, including devices, so the
mode and the time of a file cannot change. The run's own folder is another file system in memory with its own limit, so that
a run cannot fill a disk.
"""

from __future__ import annotations

import ctypes
import os
import stat
from collections.abc import Iterable, Sequence
from contextlib import suppress

from .allowance import MOST_BYTES, MOST_FILES
from .system import IS_LINUX, effective_capabilities, libc, syscall

NEW_NAMESPACE, NEW_USERS = 0x00020000, 0x10000000
NO_SETUID, NO_DEVICES, BIND, RECURSIVE, PRIVATE, DETACH = 2, 4, 0x1000, 0x4000, 1 << 18, 2
TREE_BYTES = 16 << 20
MOUNT_SETATTR, HERE, WITH_ALL_BELOW, READ_ONLY = 442, -100, 0x8000, 1
PIVOT_ROOT = {'x86_64': 155, 'aarch64': 41}
MOST_LINKS = 40
TERMINAL = '/dev/tty'  # can be opened only by a process with a terminal
READ_ALL = 1 << 1 | 1 << 2  # CAP_DAC_OVERRIDE, CAP_DAC_READ_SEARCH


def enter(home: str, shown: Iterable[str], hidden: Sequence[str]) -> None:
    """Limit this process and its children to the given paths from now on.

    :param home: the run's own folder, which is empty. It is the current folder afterwards.
    :param shown: existing paths, which are visible with everything below them. Other paths are left out.
    :param hidden: folders below them that appear empty.
    :raises OSError: if this user may not create namespaces. In this case, nothing has changed.
    """
    if not IS_LINUX:
        raise OSError('only Linux has namespaces')
    _unshare()
    _mount('none', '/', None, RECURSIVE | PRIVATE)
    _mount('tmpfs', home, 'tmpfs', NO_SETUID | NO_DEVICES, f'size={TREE_BYTES},mode=755')
    if os.geteuid() == 0:
        os.makedirs(home + '/dev')
        _mount('tmpfs', home + '/dev', 'tmpfs', NO_SETUID, f'size={TREE_BYTES},mode=755')
    tree = _Tree(home)
    for place in sorted({os.path.abspath(place) for place in shown}, key=lambda place: (len(os.path.realpath(place)), place)):
        tree.show(place)
    for place in hidden:
        if os.path.isdir(home + place):
            _mount('tmpfs', home + place, 'tmpfs', NO_SETUID | NO_DEVICES, 'size=4096,nr_inodes=2,mode=755')
    os.makedirs(home + home, exist_ok=True)
    os.makedirs(home + '/tmp', exist_ok=True)
    _make_read_only(home)
    own = f'size={MOST_BYTES},nr_inodes={MOST_FILES},mode=700'
    _mount('tmpfs', home + home, 'tmpfs', NO_SETUID | NO_DEVICES, own)
    os.chdir(home)
    syscall(PIVOT_ROOT[os.uname().machine], b'.', b'.')
    _checked(libc.umount2(b'.', DETACH))
    os.chdir(home)


class _Tree:
    """The new tree of directories.

    :param root: the temporary path of the tree.
    """

    def __init__(self, root: str) -> None:
        self._root = root
        self._bound: list[str] = []

    def show(self, place: str) -> None:
        """Add a path to the tree. Links in the path are also links in the tree."""
        path, links = '/', 0
        rest = [part for part in place.split('/') if part]
        while rest:
            if any(path == bound or path.startswith(bound + '/') for bound in self._bound):
                return  # links and parent folders lead to visible places or nowhere
            part = rest.pop(0)
            path = os.path.normpath(os.path.join(path, part))
            if os.path.islink(path) and links < MOST_LINKS:
                links += 1
                target = os.readlink(path)
                if not os.path.lexists(self._root + path):
                    os.makedirs(os.path.dirname(self._root + path), exist_ok=True)
                    os.symlink(target, self._root + path)
                rest = [*(each for each in target.split('/') if each), *rest]
                path = '/' if target.startswith('/') else os.path.dirname(path)
        if not os.path.exists(path) or path in self._bound:
            return
        there = self._root + path
        if os.path.isdir(path):
            os.makedirs(there, exist_ok=True)
        else:
            os.makedirs(os.path.dirname(there), exist_ok=True)
            if _is_own_device(path, there):
                self._bound.append(path)
                return
            os.close(os.open(there, os.O_CREAT | os.O_WRONLY, 0o644))
        _mount(path, there, None, BIND | RECURSIVE)
        self._bound.append(path)


def _is_own_device(path: str, there: str) -> bool:
    """Create a device node for this run, if root may do so, and return True. Return False for other files and in most containers.

    If all runs shared a node, they could send each other messages with locks on it.
    """
    found = os.stat(path)
    if os.geteuid() != 0 or not stat.S_ISCHR(found.st_mode):
        return False
    try:
        os.mknod(there, stat.S_IFCHR, found.st_rdev)
        os.chmod(there, stat.S_IMODE(found.st_mode))
        if path != TERMINAL:
            os.close(os.open(there, os.O_RDWR))
    except PermissionError:
        with suppress(FileNotFoundError):
            os.remove(there)
        return False
    return True


def _unshare() -> None:
    """Create a mount namespace. For an ordinary user, also create a user namespace in which the user ids do not change."""
    user, group = os.geteuid(), os.getegid()
    if user == 0:  # avoid a user namespace, in which root cannot read the files of students
        return _checked(libc.unshare(NEW_NAMESPACE))
    if effective_capabilities() & READ_ALL:
        raise OSError('this user reads files by a right that is lost in a namespace')
    _checked(libc.unshare(NEW_NAMESPACE | NEW_USERS))
    for name, text in (('setgroups', 'deny'), ('uid_map', f'{user} {user} 1'), ('gid_map', f'{group} {group} 1')):
        with open(f'/proc/self/{name}', 'w') as file:
            file.write(text)
    return None


def _make_read_only(place: str) -> None:
    """Make the mounts at a path and below it read-only."""
    wanted = (ctypes.c_uint64 * 4)(READ_ONLY, 0, 0, 0)
    syscall(MOUNT_SETATTR, HERE, os.fsencode(place), WITH_ALL_BELOW, ctypes.byref(wanted), ctypes.sizeof(wanted))


def _mount(source: str, place: str, kind: str | None, flags: int, options: str | None = None) -> None:
    texts = (os.fsencode(source), os.fsencode(place), kind.encode() if kind else None)
    _checked(libc.mount(*texts, ctypes.c_ulong(flags), options.encode() if options else None))


def _checked(result: int) -> None:
    if result != 0:
        number = ctypes.get_errno()
        raise OSError(number, os.strerror(number))

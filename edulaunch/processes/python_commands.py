"""Command lines that name Python themselves: `python3 script.py`, `python3 -m package.module`, `./script.py`.

Such a program runs in the simulation, as the ROS nodes that it probably holds need it.
"""

from __future__ import annotations

import os
import re

from edulaunch.packages import Program

_PYTHON = re.compile(r'python[\d.]*(\.exe)?')
_FLAGS = frozenset(('-u', '-B', '-E', '-I', '-O', '-OO', '-s', '-S', '-q', '-v'))
_FLAGS_WITH_VALUE = frozenset(('-W', '-X'))


def python_command(words: list[str], cwd: str | None, modules: frozenset[str]) -> tuple[list[str], Program] | None:
    """What the program sees of the words, and the program; None for any other command.

    :param cwd: the folder in which the command is started.
    :param modules: top-level modules of the workspaces; with `-m` any other module is left to a real Python.
    """
    if not words:
        return None
    folder = cwd or os.getcwd()
    if not _PYTHON.fullmatch(os.path.basename(words[0])):
        return _script(words, folder, needs_mark=True)
    position = 1
    while position < len(words) and words[position] in _FLAGS | _FLAGS_WITH_VALUE:
        position += 2 if words[position] in _FLAGS_WITH_VALUE else 1
    rest = words[position:]
    if len(rest) > 1 and rest[0] == '-m':
        name = rest[1]
        top = name.partition('.')[0]
        if top not in modules and not any(os.path.exists(os.path.join(folder, path)) for path in (top, f'{top}.py')):
            return None
        return rest[1:], Program('module', '', name, name, name, python_roots=(folder,))
    return _script(rest, folder, needs_mark=False)


def _script(words: list[str], folder: str, needs_mark: bool) -> tuple[list[str], Program] | None:
    """A Python file; one that is started by itself must say so in its first line."""
    path = os.path.normpath(os.path.join(folder, os.path.expanduser(words[0]))) if words else ''
    if not path.endswith('.py') or not os.path.isfile(path) or (needs_mark and not _is_marked(path)):
        return None
    return words, Program('script', '', os.path.basename(path), path, file=path)


def _is_marked(path: str) -> bool:
    with open(path, 'rb') as file:
        first = file.readline(200)
    return first.startswith(b'#!') and b'python' in first and os.access(path, os.X_OK)

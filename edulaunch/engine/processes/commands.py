"""Finds the commands that the simulation runs itself: programs of packages, Python files, tools and shell lines.

Any other command is a real program. The engine contains no tool and no shell: the creator of a machine passes both in, as a
:class:`CommandSet`.
"""

from __future__ import annotations

import os
import shlex
from collections.abc import Callable, Mapping, Sequence
from functools import partial
from types import MappingProxyType
from typing import Any, NamedTuple, Protocol

from edulaunch.engine.packages import Index, Program
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.programs import python_command, run_program
from edulaunch.engine.processes.spec import ProcessSpec

WRAPPERS = (
    'alacritty',
    'chrt',
    'env',
    'gdb',
    'gdbserver',
    'gnome-terminal',
    'gnome-terminal.wrapper',
    'ionice',
    'kitty',
    'konsole',
    'lxterminal',
    'mate-terminal',
    'nice',
    'nohup',
    'perf',
    'python',
    'python3',
    'screen',
    'setsid',
    'stdbuf',
    'strace',
    'sudo',
    'taskset',
    'terminator',
    'time',
    'tmux',
    'valgrind',
    'x-terminal-emulator',
    'xfce4-terminal',
    'xterm',
)
"""Programs that start the command after them; the simulation skips them."""

Main = Callable[[Process], object]
"""Runs inside a simulated process, and returns the exit code."""


class Shell(Protocol):
    """A shell that parses and runs shell lines."""

    def needs_shell(self, line: str) -> bool:
        """Return whether a line contains characters with a special meaning in a shell. Otherwise, the words of the line are
        the command.
        """

    def script_of(self, words: Sequence[str]) -> Sequence[str] | None:
        """Return the shell line of a command such as `sh -c LINE ARGUMENT...`, followed by its arguments. Return None for
        other commands.
        """

    def main_of(self, line: str, arguments: Sequence[str], knows: Callable[[Sequence[str]], bool]) -> Main | None:
        """Return the function that runs a shell line in simulated time, or None if a real shell must run the line.

        :param knows: a function that returns whether the simulation runs the command that consists of the given words.
        """


class Known(NamedTuple):
    """A command that the simulation runs.

    :ivar argv: the command line as the process gets it.
    :ivar main: the function that runs in the process.
    :ivar program: the program of a package or the Python file; None for a tool and for a shell line.
    :ivar tool: the name of the tool, or ''.
    """

    argv: list[str]
    main: Main
    program: Program | None = None
    tool: str = ''


class CommandSet:
    """The commands that a machine runs in addition to the programs of its packages.

    :ivar tools: the function that runs each tool, by the first word of the command line.
    :ivar shell: the shell that runs shell lines in the simulation; with None, a real shell runs all of them.
    """

    def __init__(self, tools: Mapping[str, Main] = MappingProxyType({}), shell: Shell | None = None) -> None:
        self.tools = tools
        self.shell = shell

    def find(self, spec: ProcessSpec, index: Index, modules: Callable[[], Mapping[str, Any]]) -> Known | None:
        """Return the command of a spec, or None if the simulation does not run it.

        :param modules: a function that returns the top-level modules of the workspaces, which `python3 -m` may name.
        """
        words: Sequence[str] = spec.argv
        if spec.shell:
            line = ' '.join(words)
            if self.shell is not None and self.shell.needs_shell(line):
                return self._line([line], index, modules)
            words = shlex.split(line)
        for position, word in enumerate(words):
            rest = list(words[position:])
            program = index.find_program(word)
            if program is not None:
                return Known(rest, partial(run_program, program=program), program)
            name = os.path.basename(word)
            if name in self.tools:
                return Known(rest, self.tools[name], tool=name)
            script = None if self.shell is None else self.shell.script_of(rest)
            if script is not None:
                return self._line(script, index, modules)
            if position == 0 and (name not in WRAPPERS or rest[1:2] == ['-c']):  # `-c` passes a script as text
                break
        return _python(words, spec.cwd, modules)

    def _line(self, script: Sequence[str], index: Index, modules: Callable[[], Mapping[str, Any]]) -> Known | None:
        """Return the command for a shell line, or None if the simulation runs no command in the line."""

        def knows(words: Sequence[str]) -> bool:
            return self.find(ProcessSpec(argv=tuple(words), name=''), index, modules) is not None

        if self.shell is None or not script:
            return None
        main = self.shell.main_of(script[0], script[1:], knows)
        return None if main is None else Known(['sh', '-c', *script], main)


def _python(words: Sequence[str], cwd: str | None, modules: Callable[[], Mapping[str, Any]]) -> Known | None:
    """Return the command for words that begin with Python or a Python file, or None for other words."""
    first = os.path.basename(words[0]) if words else ''
    if not first.endswith('.py') and not first.startswith('python'):
        return None
    found = python_command(list(words), cwd, frozenset(modules()))
    return None if found is None else Known(found[0], partial(run_program, program=found[1]), found[1])

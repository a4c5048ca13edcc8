"""The terminals on a page. Each terminal runs one command at a time, reads lines or keys, and completes words."""

from __future__ import annotations

import shlex
import signal
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.inputs import PipedInput
from edulaunch.engine.processes.process import Process
from edulaunch.runtime import ros2_command

if TYPE_CHECKING:
    from edulaunch.engine.packages import Index
    from edulaunch.runtime.session import Session

COUNT = 2
SIZE = (80, 24)
Start = Callable[[list[str], str, Callable[[str, str], object], Callable[[int], object]], Process]
"""Starts a program: its words, a name, a function for its output, a function for its end."""


class Pane:
    """One terminal of a page.

    :param number: the number of the terminal on the page.
    :param start: a function that starts a command on the machine.
    :param say: a function that sends a message (plain data) to the page.
    """

    def __init__(self, number: int, start: Start, say: Callable[[dict[str, Any]], object]) -> None:
        self._number = number
        self._start = start
        self._say = say
        self._job: Process | None = None
        self._left: list[Process] = []
        self._keyboard: _Keyboard | None = None

    def has_programs(self) -> bool:
        """Return whether a program that this terminal has started still runs, with or without `&`."""
        return any(one is not None and one.returncode is None for one in (self._job, *self._left))

    def line(self, text: str) -> None:
        """Handle a line that the user has typed: it is input for the running program, or a new command.

        :raises ValueError: when the command cannot be parsed.
        """
        if self._job is not None and self._job.returncode is None:
            self.keys(f'{text}\n')
            return
        words = shlex.split(text)
        background = words[-1:] == ['&']
        words = words[: len(words) - background]
        if words[:1] != ['ros2']:
            self.tell('stderr', f'{words[0] if words else text}: this terminal runs only ros2 commands\n')
            return
        job = self._start(words, 'ros2', self.tell, (lambda code: None) if background else self._ended)
        if background:
            self._left.append(job)
        else:
            self._job, self._keyboard = job, _Keyboard(self._tell_mode)
            job.streams.stdin = self._keyboard
            self._tell_mode(False)

    def keys(self, text: str) -> None:
        """Send keys to the running program."""
        if self._keyboard is not None:
            self._keyboard.feed(text)

    def interrupt(self) -> None:
        """Send SIGINT to the running program, as Ctrl-C does."""
        if self._job is not None and self._job.returncode is None:
            self._job.send_signal(signal.SIGINT)

    def tell(self, stream: str, text: str) -> None:
        """Send the output of a program to the page."""
        self._say({'text': text, 'pane': self._number})

    def _tell_mode(self, by_key: bool) -> None:
        self._say({'pane': self._number, 'runs': True, 'keys': by_key})

    def _ended(self, code: int) -> None:
        self._job = self._keyboard = None
        self._say({'pane': self._number, 'runs': False, 'keys': False})


class _Keyboard(PipedInput):
    """The input of a program in a page's terminal. The program may request single keys instead of lines."""

    is_inherited = True

    def __init__(self, tell_mode: Callable[[bool], object]) -> None:
        super().__init__()
        self._tell_mode = tell_mode

    def isatty(self) -> bool:
        """Return True, because a user types in this terminal."""
        return True

    def terminal_size(self) -> tuple[int, int]:
        """Return the fixed columns and lines of a page's terminal."""
        return SIZE

    def change_mode(self, process: Process, flags: int) -> None:
        """Report to the page whether the program reads single keys or whole lines."""
        super().change_mode(process, flags)
        self._tell_mode(self.by_key)


def completions(session: Session, words: list[str], typed: str, index: Callable[[], Index]) -> list[str]:
    """Return, in alphabetical order, the words that can come next after `ros2 WORDS...` and that begin with `typed`.

    :param session: the session of the machine.
    :param words: the complete words after `ros2`.
    :param typed: the beginning of the word that the user is typing.
    :param index: a function that returns the index of the packages that the terminal finds.
    """
    possible = ros2_command.complete(words, typed, index, lambda command: _listed(session, command))
    return sorted({word for word in possible if word.startswith(typed)})


def _listed(session: Session, command: str) -> list[str]:
    """Return the lines that a command such as `topic list` would print now. No simulated program runs for that."""
    rows, (what, *rest) = session.recorder.endpoints, command.split()
    if what == 'node':
        return [node.fully_qualified_name for node in session.graph.nodes if not node.name.startswith('_')]
    if what == 'param':
        return [row[2] for row in session.recorder.parameters if row[1] == rest[-1]]
    if what == 'topic' and rest[0] == 'type':
        return [row[2] for row in rows if row[1] == rest[-1]]
    if what == 'interface':
        from edulaunch.engine.interfaces import current_registry

        kinds = {'-m': 'msg', '-s': 'srv', '-a': 'action'}
        return current_registry().types(next((kinds[word] for word in rest if word in kinds), None))
    kinds_of = {'topic': ('publisher', 'subscription'), 'service': ('service',), 'action': ('service',)}.get(what, ())
    names = [row[1] for row in rows if row[0] in kinds_of]
    if what == 'action':
        return [name.removesuffix('/_action/send_goal') for name in names if name.endswith('/_action/send_goal')]
    return [name for name in names if '/_action/' not in name]

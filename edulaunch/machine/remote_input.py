"""The keyboard of a terminal that is connected to the machine, as what a simulated program reads."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from edulaunch.machine import wire
from edulaunch.processes.inputs import PipedInput

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class RemoteInput(PipedInput):
    """What somebody types elsewhere. The other end reads its keyboard only once a program here does.

    :param send: tells the other end something.
    :param is_terminal: whether there is a keyboard, or a pipe or a file.
    :ivar size: columns and lines of the terminal.
    """

    is_inherited = True

    def __init__(self, send: Callable[..., object], is_terminal: bool, size: tuple[int, int]) -> None:
        super().__init__()
        self.size = size
        self._send = send
        self._is_terminal = is_terminal
        self._mode = wire.PLAIN_MODE
        self._is_wanted = False

    def isatty(self) -> bool:
        """Whether somebody sits there."""
        return self._is_terminal

    def terminal_size(self) -> tuple[int, int]:
        """Of the window at the other end."""
        return self.size if self._is_terminal else super().terminal_size()

    def take_due(self) -> None:
        """A program reads, or looks whether there is something to read."""
        if not self._is_wanted:
            self._is_wanted = True
            self._send(wire.READ)

    def change_mode(self, process: Process, flags: int) -> None:
        """Let the other end's terminal give keys or lines, as the program asks for."""
        import termios

        super().change_mode(process, flags)
        signs = ((wire.CANONICAL, termios.ICANON), (wire.ECHO, termios.ECHO), (wire.SIGNALS, termios.ISIG))
        mode = sum(sign for sign, flag in signs if flags & flag)
        if self._is_terminal and mode != self._mode:
            self._mode = mode
            self._send(wire.MODE, str(mode).encode())

"""Follow a command of a terminal on the machine: show the output, forward keys and signals, and always return.

This module imports only the standard library.
"""

from __future__ import annotations

import os
import select
import signal
import socket
import sys
import time
from collections.abc import Callable

from edulaunch.desk.machine import wire
from edulaunch.desk.machine.keyboard import Keyboard
from edulaunch.runtime.framing import BadFrame, Frames, frame

TYPE_CHECKING = False  # equals `typing.TYPE_CHECKING`, but does not load `typing`
if TYPE_CHECKING:
    from types import FrameType

PASSED_ON = ('SIGINT', 'SIGTERM', 'SIGQUIT')
MOST_PRESSES = 3
"""After this many unanswered signals, a terminal stops waiting for the machine."""
LOOK_S = 1.0
ANSWER_S = 1.5
"""A machine has this many seconds to answer a signal. After that, the terminal explains the state, and ends after SIGTERM."""
EXPLAINED_S, LONG_S, GIVE_UP_S = 2.0, 20.0, 60.0
"""After this many seconds without a first answer, a terminal prints the report of the guardian, and stops waiting."""
BROKEN_PIPE = 141
CHUNK = 1 << 16


class GaveUp(Exception):
    """The machine did not answer for too long.

    :ivar code: the exit code.
    """

    def __init__(self, code: int) -> None:
        super().__init__(code)
        self.code = code


class _CannotWrite(Exception):
    """The output cannot be written, for example on a full disk."""


class _NobodyReads(Exception):
    """The reader of our output pipe has closed it."""


class Follower:
    """Follows one command in this terminal. It forwards Ctrl-C, and the program decides how to react.

    :param state: a function that returns the end of a sentence about a machine that does not answer.
    :param give_up_s: the time in seconds after which the terminal stops waiting for a first answer.
    :ivar is_welcome: whether the machine has accepted the command.
    :ivar has_explained: whether the terminal has printed that the machine does not answer.
    """

    def __init__(self, connection: socket.socket, state: Callable[[], str], give_up_s: float = GIVE_UP_S) -> None:
        self._connection = connection
        self._state = state
        self._give_up_s = give_up_s
        self._keyboard = Keyboard()
        self._frames = Frames(wire.FROM_MACHINE)
        self._poll = select.poll()
        self._unsent = bytearray()
        self._is_sending = False
        self._reads = self._has_keys = False
        self.is_welcome = False
        self._unanswered: list[int] = []
        self._explained: set[bool] = set()
        self._began_s = time.monotonic()

    @property
    def has_explained(self) -> bool:
        return bool(self._explained)

    def run(self, first: bytes) -> int | None:
        """Follow the command to its end. Return the exit code, or None if the machine has ended.

        :param first: the first frame to send.
        :raises GaveUp: when the machine does not answer for too long.
        """
        actions = dict.fromkeys(PASSED_ON, self._pass_on)
        actions |= {'SIGWINCH': self._send_size, 'SIGALRM': self._look}
        here = [(name, action) for name, action in actions.items() if hasattr(signal, name)]
        handlers = {name: signal.signal(getattr(signal, name), action) for name, action in here}
        try:
            signal.setitimer(signal.ITIMER_REAL, min(EXPLAINED_S, self._give_up_s))
            return self._follow(first)
        except _NobodyReads:
            return BROKEN_PIPE
        except _CannotWrite as error:
            sys.stderr.write(f'error: cannot write the output of the command: {error}\n')
            return 1
        except (ConnectionError, BadFrame):
            return None
        finally:
            signal.setitimer(signal.ITIMER_REAL, 0)
            self._keyboard.restore()
            for name, handler in handlers.items():
                signal.signal(getattr(signal, name), handler)

    def _follow(self, first: bytes) -> int | None:
        self._connection.setblocking(False)
        self._poll.register(self._connection, select.POLLIN)
        self._send(first)
        while True:
            for number, events in self._poll.poll():
                if number == 0:
                    self._pass_keys()
                    continue
                if events & select.POLLOUT:
                    self._send(b'')
                if not events & ~select.POLLOUT:
                    continue
                try:
                    data = self._connection.recv(CHUNK)
                except BlockingIOError:  # the wake-up was spurious
                    continue
                if not data:
                    return None
                for kind, payload in self._frames.feed(data):
                    if kind == wire.EXIT:
                        return int(payload)
                    self._take(kind, payload)

    def _take(self, kind: int, payload: bytes) -> None:
        if kind == wire.WELCOME:
            self.is_welcome = True
        elif kind == wire.ANSWER:
            self._unanswered.clear()
        elif kind == wire.MODE:
            self._keyboard.set_mode(int(payload))
        elif kind == wire.READ and not self._reads:
            self._reads = True
            self._watch_keys()
        elif kind in (wire.OUTPUT, wire.ERRORS):
            _write(1 if kind == wire.OUTPUT else 2, payload)

    def _send(self, frame: bytes) -> None:
        """Send as many bytes as the machine accepts, and keep the rest for later.

        A signal handler may call this method during another call.
        """
        self._unsent += frame
        if self._is_sending:
            return
        self._is_sending = True
        try:
            while self._unsent:
                del self._unsent[: self._connection.send(self._unsent[:CHUNK])]
        except BlockingIOError:
            pass
        finally:
            self._is_sending = False
        self._poll.modify(self._connection, select.POLLIN | (select.POLLOUT if self._unsent else 0))
        self._watch_keys()

    def _watch_keys(self) -> None:
        """Watch the keyboard while a program reads it and the machine accepts input. Otherwise, stop watching it."""
        wanted = self._reads and not self._unsent
        if wanted != self._has_keys:
            self._has_keys = wanted
            if wanted:
                self._poll.register(0, select.POLLIN)
            else:
                self._poll.unregister(0)

    def _pass_keys(self) -> None:
        try:
            keys = os.read(0, 1 << 12)
        except OSError:  # stdin is closed, or this process may not read it
            keys = b''
        self._reads = bool(keys)
        self._send(frame(wire.INPUT, keys))

    def _pass_on(self, signum: int, frame: FrameType | None) -> None:
        self._unanswered.append(signum)
        if len(self._unanswered) >= MOST_PRESSES:
            raise GaveUp(128 + signum)
        signal.setitimer(signal.ITIMER_REAL, ANSWER_S)
        self._send_in_handler(wire.SIGNAL, str(int(signum)))

    def _send_size(self, signum: int, frame: FrameType | None) -> None:
        self._send_in_handler(wire.SIZE, '{} {}'.format(*window_size()))

    def _send_in_handler(self, kind: int, text: str) -> None:
        try:
            self._send(frame(kind, text.encode()))
        except (OSError, KeyError):
            return  # the next read shows that the machine has ended

    def _look(self, signum: int, frame: FrameType | None) -> None:
        """Explain why the machine has not answered yet, or stop waiting for it."""
        if self.is_welcome and not self._unanswered:
            return
        waited_s = time.monotonic() - self._began_s
        known = self._state()
        if self._unanswered:
            left = MOST_PRESSES - len(self._unanswered)
            presses = 'once' if left == 1 else 'twice'
            self._explain(f'the machine has not answered yet (press Ctrl-C {presses} more to leave it){known}')
            if signal.SIGTERM in self._unanswered:
                raise GaveUp(128 + signal.SIGTERM)
        elif known or waited_s >= min(LONG_S, self._give_up_s):
            self._explain(f'the machine does not answer{known}')
        if not self.is_welcome and waited_s >= self._give_up_s:
            raise GaveUp(1)
        signal.setitimer(signal.ITIMER_REAL, LOOK_S)

    def _explain(self, text: str) -> None:
        kind = bool(self._unanswered)
        if kind not in self._explained:
            self._explained.add(kind)
            os.write(2, f'\nnote: {text}\n'.encode())


def window_size() -> tuple[int, int]:
    """Return the columns and lines of this terminal."""
    for number in (1, 0, 2):
        try:
            columns, lines = os.get_terminal_size(number)
        except OSError:
            continue
        return columns, lines
    return 80, 24


def _write(number: int, data: bytes) -> None:
    try:
        while data:
            data = data[os.write(number, data) :]
    except BrokenPipeError:
        raise _NobodyReads from None
    except OSError as error:
        raise _CannotWrite(error.strerror) from None

"""The trusted peer of one run: the simulation with its worlds, stock nodes and recorder. It forks the confined peer.

It sends two frames to the runner. A frame consists of a letter, eight bytes of length, and content. The first frame, ``C``, is
JSON with the layers of confinement. It comes from the confined peer before that peer reads anything of the submission.

The second frame has one of these letters:
- ``R`` is the recording of this peer: a line of JSON with the provenance of its rows and the contents of the bags, then bytes.
- ``U`` is JSON for a launch file that cannot be run, with the message of ROS 2.
- ``S`` is JSON for a stopped run. Its reason is 'timeout', 'memory', 'recording' (too large), 'processes' (too many),
  'protocol' (invalid frames) or 'broken' (an error of edulaunch in the other peer).
- ``B`` is JSON for an error of edulaunch in this peer.
"""

from __future__ import annotations

import json
import os
import signal
import socket
import time
from collections.abc import Callable
from contextlib import suppress
from types import FrameType
from typing import Any, NoReturn

from . import bags
from .system import fork

HEADER_BYTES = 9
LONGEST_WORDS = 64_000
LATER_S = 0.4  # delay after the confined peer's own alarm, which can report where the program was
PATIENCE_S = 0.5  # time limit for a peer to end after it has closed its channel
ITS_WORDS = b'US'
REASONS = {'TooMuch': 'recording', 'TooManyPrograms': 'processes'}  # by the error of the link
INTERRUPTED_S = 2.0  # simulated time in which programs can end after Ctrl-C


class TrustedPeer:
    """The trusted peer of one run.

    :param job: the input of the run; see `RunRequest.message`.
    :param channel: the socket to the runner. The runner sends values that the confined peer must not know, so they are read
        after the fork.
    :param confined: a function that runs the confined peer. Its arguments are the peer's ends of the link and of the pipe for
        its last message.
    """

    def __init__(self, job: dict[str, Any], channel: int, confined: Callable[[socket.socket, int], NoReturn]) -> None:
        self._job = job
        self._channel = channel
        ours, theirs = socket.socketpair()
        self._words, writing_end = os.pipe()
        self._pid = fork()
        if self._pid == 0:
            for end in (channel, self._words, ours.fileno()):
                os.close(end)
            confined(theirs, writing_end)
        os.close(writing_end)
        theirs.close()
        self._link = ours

    def run(self) -> NoReturn:
        """Report the confinement of the other peer to the runner, run the scenario together with that peer, and send the
        result.
        """
        state = read_words(self._words)
        if state[:1] == b'B':  # it has not been confined, and has read nothing yet
            self._answer(state[:1], state[HEADER_BYTES:])
            os._exit(0)
        if state[:1] != b'C':
            self._answer(b'B', b'{"text": "the process for the submission ended before it had read anything of it"}')
            os._exit(0)
        self._answer(state[:1], state[HEADER_BYTES:])
        os.set_blocking(self._words, False)
        signal.signal(signal.SIGCHLD, self._on_its_end)
        signal.signal(signal.SIGALRM, lambda *_: self._stopped('timeout'))
        signal.setitimer(signal.ITIMER_REAL, self._job['wall_s'] + LATER_S)
        try:
            letter, content = b'R', self._recorded()
        except MemoryError:
            self._stopped('memory')
        except Exception as error:
            letter, content = broke(error)
        signal.setitimer(signal.ITIMER_REAL, 0.0)
        signal.signal(signal.SIGCHLD, signal.SIG_DFL)
        self._answer(letter, content)
        os._exit(0)

    def _recorded(self) -> bytes:
        from edulaunch.engine.recording import Recording
        from edulaunch.runtime.link.trusted import Trusted

        trusted = Trusted(self._link, self._job['seed'], self._job['most_bytes'])
        hidden = json.loads(read_words(self._channel)[HEADER_BYTES:] or b'{}')
        trusted.host.late_s, trusted.host.fails = hidden.get('late', {}), hidden.get('fails', ())
        trusted.sent, trusted.turned = hidden.get('sent', {}), hidden.get('turned', {})
        trusted.peer.fatal = self._on_fatal  # type: ignore[method-assign]
        content = trusted.run(self._job['duration_s'])
        try:
            recording = Recording(content).to_bytes()
        except MemoryError:
            raise
        except Exception as error:  # only values that the other peer sent can have the wrong type
            self._on_fatal(error)
        provenance = trusted.recorder.provenance.as_data()
        found = self._bags_after_interrupt(trusted) if self._job['is_interrupted'] else []
        return json.dumps([*provenance, *found]).encode() + b'\n' + recording

    def _bags_after_interrupt(self, trusted: Any) -> list[dict[str, Any]]:
        """Continue after the recorded part until launch and its programs have ended, and read the bags that they have written."""

        def over(error: Exception) -> NoReturn:
            raise error

        published, end_ns = trusted.published_bytes, trusted.sim.now_ns
        trusted.peer.fatal = over
        with suppress(Exception):
            trusted.go_on(INTERRUPTED_S)
        return bags.written_bags(self._job['home'], end_ns, published)

    def _on_fatal(self, error: Exception) -> NoReturn:
        name = type(error).__name__
        if name == 'Gone':
            self._end_like_it()
        self._stopped(REASONS.get(name, 'protocol'), f'{name}: {error}')

    def _on_its_end(self, signum: int, frame: FrameType | None) -> None:
        """Close the link, so that only data that the ended peer has already sent are read. Its children may still hold the
        link open.
        """
        with suppress(OSError):
            self._link.shutdown(socket.SHUT_RDWR)

    def _end_like_it(self) -> NoReturn:
        """Pass the last message of the ended peer on, or end in the same way as that peer."""
        words = read_words(self._words)
        if words[:1] == b'B':  # a submission can break its process or pretend that it broke, so this gives no mark
            self._answer(b'S', b'{"reason": "broken", "said": %s}' % (words[HEADER_BYTES:] or b'null'))
            os._exit(0)
        if words[:1] and words[:1] in ITS_WORDS:
            self._answer(words[:1], words[HEADER_BYTES:])
            os._exit(0)
        if words:
            self._stopped('protocol')
        status = self._status()
        if status is not None and status < 0:
            with suppress(OSError, ValueError):
                signal.signal(-status, signal.SIG_DFL)
            signal.pthread_sigmask(signal.SIG_UNBLOCK, [-status])
            os.kill(os.getpid(), -status)
        os._exit(0 if status is None else status)

    def _status(self) -> int | None:
        deadline = time.monotonic() + PATIENCE_S
        while time.monotonic() < deadline:
            ended, status = os.waitpid(self._pid, os.WNOHANG)
            if ended:
                return os.waitstatus_to_exitcode(status)
            time.sleep(0.002)
        return None

    def _stopped(self, reason: str, detail: str = '') -> NoReturn:
        self._answer(b'S', json.dumps({'reason': reason, 'detail': detail}).encode())
        os._exit(0)

    def _answer(self, letter: bytes, content: bytes) -> None:
        send(self._channel, letter, content)


def send(channel: int, letter: bytes, content: bytes) -> None:
    """Write one complete frame."""
    for part in (letter + len(content).to_bytes(8, 'big'), content):
        view = memoryview(part)
        while view:
            view = view[os.write(channel, view) :]


def read_words(words: int) -> bytes:
    """Read one complete frame from a pipe, or return b'' if there is no complete frame."""
    data = b''
    with suppress(BlockingIOError):
        while len(data) < LONGEST_WORDS and not _is_whole(data):
            more = os.read(words, LONGEST_WORDS)
            if not more:
                break
            data += more
    return data if _is_whole(data) else b''


def _is_whole(data: bytes) -> bool:
    return len(data) >= HEADER_BYTES and len(data) >= HEADER_BYTES + int.from_bytes(data[1:HEADER_BYTES], 'big')


def broke(error: BaseException) -> tuple[bytes, bytes]:
    """Return the letter and content of a frame for an error of edulaunch itself."""
    import traceback

    text = ''.join(traceback.format_exception(type(error), error, error.__traceback__))
    return b'B', json.dumps({'text': f'{type(error).__name__}: {error}', 'trace': text[-8000:]}).encode()

"""Real programs of this machine, started by ExecuteProcess.

While one of them runs, simulated time keeps pace with real time, so that `sleep 2` takes two simulated seconds. Such runs
cannot repeat exactly; a recording says so.
"""

from __future__ import annotations

import codecs
import errno
import os
import queue
import subprocess
import threading
from contextlib import suppress
from typing import TYPE_CHECKING

from edulaunch.processes.process import OnExit, OnOutput
from edulaunch.processes.signals import Signals
from edulaunch.processes.spec import ProcessSpec
from edulaunch.sim.real_pace import LOOK_EVERY_NS

if TYPE_CHECKING:
    from edulaunch.processes.host import Host

READER_NAME = 'edulaunch reads '
"""How the names of the threads begin that read what real programs print."""


class RealLook:
    """One look at all real programs of a simulation: it hands on what they said and, while there are any, lets simulated
    time wait for real time.

    :ivar news: where their threads put (program, stream, text).
    """

    def __init__(self, host: Host) -> None:
        self.news: queue.SimpleQueue[tuple[RealProcess, str, str | None]] = queue.SimpleQueue()
        self._host = host

    def begin(self) -> None:
        """The first program is about to run."""
        self._host.pace.begin()
        self._look_later()

    def _look_later(self) -> None:
        sim = self._host.sim
        sim.schedule(sim.now_ns + LOOK_EVERY_NS, self._look)

    def _look(self) -> None:
        while self._host.real_programs:
            try:
                program, stream, text = self.news.get(timeout=self._host.pace.ahead_s())
            except queue.Empty:
                self._look_later()
                break
            program.take(stream, text)


class RealProcess:
    """A program of the operating system with the same face as a simulated one: `pid`, `returncode`, `send_signal`."""

    def __init__(self, host: Host, spec: ProcessSpec, on_output: OnOutput | None, on_exit: OnExit | None) -> None:
        self.host = host
        self.spec = spec
        self.returncode: int | None = None
        parent = host.program_here()
        self.group = None if parent is None else parent.group
        self.on_output = on_output
        self.on_exit = on_exit
        command = ' '.join(spec.argv) if spec.shell else list(spec.argv)
        environment = dict(spec.env) if spec.env is not None else host.env
        outputs = [_terminal() if spec.emulate_tty and hasattr(os, 'openpty') else os.pipe() for _ in range(2)]
        try:
            self._child = subprocess.Popen(
                command,
                shell=spec.shell,
                cwd=spec.cwd,
                env=environment,
                stdin=subprocess.PIPE if spec.has_pipe else subprocess.DEVNULL,
                stdout=outputs[0][1],
                stderr=outputs[1][1],
                start_new_session=True,
            )
        except BaseException:
            for reader, _ in outputs:
                os.close(reader)
            raise
        finally:
            for _, writer in outputs:
                os.close(writer)
        self.pid = self._child.pid
        self._news = host.real_look.news
        self._open = 3
        self._code: int | None = None
        for stream, (reader, _) in zip(('stdout', 'stderr'), outputs, strict=True):
            threading.Thread(target=self._read, args=(stream, reader), name=f'{READER_NAME}{stream}', daemon=True).start()
        self._waiter = threading.Thread(target=self._wait, name=f'{READER_NAME}the end', daemon=True)
        self._waiter.start()
        host.tracer.note(None, 'real program', f'{spec.name} is a real program: this run cannot repeat exactly')
        if not host.real_programs:
            host.real_look.begin()

    def _read(self, stream: str, reader: int) -> None:
        decoder = codecs.getincrementaldecoder('utf-8')('replace')  # a letter of two bytes may come in two pieces
        try:
            while chunk := _chunk(reader):
                self._news.put((self, stream, decoder.decode(chunk)))
            self._news.put((self, stream, decoder.decode(b'', final=True)))
        finally:
            os.close(reader)
            self._news.put((self, stream, None))

    def _wait(self) -> None:
        """Alone in asking the system for the program's end: in the main thread a signal handler could lose the answer."""
        self._code = self._child.wait()
        if self._child.stdin is not None:
            self._child.stdin.close()
        self._news.put((self, '', None))

    def take(self, stream: str, text: str | None) -> None:
        """What one of its threads has to say: a piece of output, or (None) that it has ended."""
        if text is not None:
            if text and self.on_output is not None:
                self.on_output(stream, text)
            return
        self._open -= 1
        if not self._open:
            assert self._code is not None
            self.returncode = self._code
            self.host.real_programs.remove(self)
            if self.on_exit is not None:
                self.on_exit(self.returncode)

    def send_signal(self, signum: int) -> None:
        """Send a signal to the program and everything it started."""
        if self._code is not None:
            return
        if hasattr(os, 'killpg'):
            with suppress(ProcessLookupError):
                os.killpg(self.pid, signum)
        else:
            self._child.terminate()  # all that Windows has

    def kill(self) -> None:
        """End it for good; nobody is told."""
        self.on_output = self.on_exit = None
        self.send_signal(Signals.SIGKILL)
        self._waiter.join()


def _terminal() -> tuple[int, int]:
    """Both ends of a new terminal, ours first, which leaves the ends of lines as they are."""
    import pty
    import termios

    ours, theirs = pty.openpty()
    settings = termios.tcgetattr(theirs)
    settings[1] &= ~termios.OPOST
    termios.tcsetattr(theirs, termios.TCSANOW, settings)
    return ours, theirs


def _chunk(reader: int) -> bytes:
    """What comes next; nothing at the end, which Linux makes an error of when it is a terminal's."""
    try:
        return os.read(reader, 65536)
    except OSError as error:
        if error.errno != errno.EIO:
            raise
        return b''

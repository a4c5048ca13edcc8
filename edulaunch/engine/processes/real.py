"""Real programs of this machine, such as the command of an ExecuteProcess action, and real files that a simulated program reads,
such as the terminal.

While a real program runs, simulated time keeps pace with real time, so that `sleep 2` takes two simulated seconds. Such runs
cannot repeat exactly, and their recordings state this.
"""

from __future__ import annotations

import codecs
import errno
import os
import queue
import select
import subprocess
import threading
from codecs import getincrementaldecoder
from contextlib import suppress
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.inputs import Input
from edulaunch.engine.processes.spec import ProcessSpec, Signals
from edulaunch.engine.sim.real_pace import LOOK_EVERY_NS
from edulaunch.engine.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.engine.processes.host_face import HostFace, OnExit, OnOutput
    from edulaunch.engine.processes.process import Process

CHUNK = 4096
MOST_WAITING = 16
"""The largest number of waiting pieces of a program's output. Then the program waits, too, as at a full pipe."""
MOST_AT_ONCE = 4
"""The number of pieces that are passed on before other programs and Ctrl-C have their turn."""
READER_NAME = 'edulaunch reads '
"""The prefix for names of threads that read the output of real programs."""


class RealLook:
    """The observer of all real programs of a simulation.

    The observer passes on the output of these programs. While any of the programs runs, simulated time is kept equal to real
    time.

    :ivar news: the queue to which the reading threads add (program, stream, string).
    """

    def __init__(self, host: HostFace) -> None:
        self.news: queue.SimpleQueue[tuple[RealProcess, str, str | None]] = queue.SimpleQueue()
        self._host = host

    def begin(self) -> None:
        """Start observing, because the first real program has started."""
        self._host.pace.begin()
        self._look_later()

    def _look_later(self) -> None:
        sim = self._host.sim
        sim.schedule(sim.now_ns + LOOK_EVERY_NS, self._look)

    def _look(self) -> None:
        pieces = 0
        while self._host.real_programs:
            try:
                program, stream, text = self.news.get(timeout=self._host.pace.ahead_s())
            except queue.Empty:
                pieces = MOST_AT_ONCE
            else:
                program.take(stream, text)
                pieces += 1
            if pieces >= MOST_AT_ONCE and self._host.real_programs:
                self._look_later()
                break


class RealProcess:
    """A program of the operating system with the interface of a simulated program: `pid`, `returncode`, `send_signal`.

    :param host: the simulated machine that starts the program.
    :param spec: the description of the program.
    :param on_output: called with the name of the stream and the string for each output, or None.
    :param on_exit: called with the return code, or None.
    """

    def __init__(self, host: HostFace, spec: ProcessSpec, on_output: OnOutput | None, on_exit: OnExit | None) -> None:
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
        self._room = threading.Semaphore(MOST_WAITING)
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
        decoder = codecs.getincrementaldecoder('utf-8')('replace')  # a character of two bytes may arrive in two parts
        try:
            while chunk := _chunk(reader):
                self._room.acquire()
                self._news.put((self, stream, decoder.decode(chunk)))
            self._news.put((self, stream, decoder.decode(b'', final=True)))
        finally:
            os.close(reader)
            self._news.put((self, stream, None))

    def _wait(self) -> None:
        """Wait in a separate thread until the program has ended, because in the main thread a signal handler could lose the
        result.
        """
        self._code = self._child.wait()
        if self._child.stdin is not None:
            self._child.stdin.close()
        self._news.put((self, '', None))

    def take(self, stream: str, text: str | None) -> None:
        """Handle a message of one of the program's threads: a piece of output, or None if the stream or the program has ended."""
        if text is not None:
            self._room.release()
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
        """Send a signal to the program and to all programs in its process group."""
        if self._code is not None:
            return
        if hasattr(os, 'killpg'):
            with suppress(ProcessLookupError):
                os.killpg(self.pid, signum)
        else:
            self._child.terminate()  # Windows has no other signal

    def kill(self) -> None:
        """Kill the program without reporting its end."""
        self.on_output = self.on_exit = None
        self._room.release(4 * MOST_WAITING)  # lets the reading threads end, because nothing reads more output
        self.send_signal(Signals.SIGKILL)
        self._waiter.join()


def _terminal() -> tuple[int, int]:
    """Return both ends of a new terminal: ours, and the program's. The terminal does not change line ends."""
    import pty
    import termios

    ours, theirs = pty.openpty()
    settings = termios.tcgetattr(theirs)
    settings[1] &= ~termios.OPOST
    termios.tcsetattr(theirs, termios.TCSANOW, settings)
    return ours, theirs


def _chunk(reader: int) -> bytes:
    """Return the next piece of output, or b'' at the end. On Linux, reading at the end of a terminal raises an error."""
    try:
        return os.read(reader, CHUNK)
    except OSError as error:
        if error.errno != errno.EIO:
            raise
        return b''


class RealInput(Input):
    """An open text file of this machine, such as the terminal.

    While a person types, simulated time follows real time and the other programs continue. Input that has already arrived is read
    immediately.

    :param file: a terminal, a pipe or a file. An object that is not a file of the operating system is read line by line.
    :param host: the simulated machine, whose watchdog allows long turns while such a file is read.
    """

    def __init__(self, file: Any, host: HostFace) -> None:
        super().__init__()
        self._file = file
        self._host = host
        self._ended = False
        self._number = _waitable(file)
        self._decoder = getincrementaldecoder('utf-8')('replace')

    def isatty(self) -> bool:
        """Return whether the file is a terminal."""
        return bool(self._file.isatty())

    def change_mode(self, process: Process, flags: int) -> None:
        """Make the real terminal send each key immediately, or whole lines again.

        The original mode of the terminal is restored when the program ends. The effect of Ctrl-C does not change.
        """
        import termios

        super().change_mode(process, flags)
        number = self._number
        if number is None or not self.isatty():
            return
        mode = termios.tcgetattr(number)
        if 'terminal' not in process.state:
            process.state['terminal'] = list(mode)
            process.lifecycle.at_exit.append(lambda: termios.tcsetattr(number, termios.TCSADRAIN, process.state['terminal']))
        letters = termios.ICANON | termios.ECHO
        mode[3] = mode[3] & ~letters if self.by_key else mode[3] | letters
        termios.tcsetattr(number, termios.TCSADRAIN, mode)

    def has_ended(self) -> bool:
        """Return whether the file has ended."""
        return self._ended

    def take_due(self) -> None:
        """Add the input that has already arrived to the unread input."""
        if self._number is not None:
            self._look(0.0)

    def take_more(self, deadline_ns: int | None) -> bool:
        """Wait for a short real time and the same simulated time, and return whether input has arrived.

        An object that is not a file of the operating system is read without a time limit.
        """
        if self._number is None:
            return self._read_patiently()
        if self._look(self._host.pace.ahead_s()):
            return True
        task = current_task()
        task.sleep_until(task.sim.now_ns + LOOK_EVERY_NS)
        return False

    def _look(self, seconds: float) -> bool:
        assert self._number is not None
        if self._ended or not select.select([self._number], [], [], seconds)[0]:
            return self._ended
        chunk = os.read(self._number, 65536)
        self._ended = not chunk
        self._text += self._decoder.decode(chunk, final=self._ended)
        return True

    def _read_patiently(self) -> bool:
        watchdog = self._host.watchdog
        if watchdog is not None:
            watchdog.asleep = True
        try:
            line = self._file.readline()
        finally:
            if watchdog is not None:
                watchdog.asleep = False
        self._text += line
        self._ended = not line
        return True


def _waitable(file: Any) -> int | None:
    """Return the file descriptor of a file if `select` supports it, otherwise None."""
    try:
        number: int = file.fileno()
        select.select([number], [], [], 0)
    except (AttributeError, OSError, ValueError):
        return None
    return number

"""Programs that a simulated program starts itself, with `subprocess.Popen` inside the simulation."""

from __future__ import annotations

import io
import subprocess
from collections import deque
from collections.abc import Callable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.inputs import Input, PipedInput
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec, Signals
from edulaunch.engine.sim.sync import wait_until

if TYPE_CHECKING:
    from edulaunch.engine.sim.task import Task


def spec_of(
    process: Process, args: Any, *, shell: bool = False, cwd: Any = None, env: Mapping[str, str] | None = None, **_: Any
) -> ProcessSpec:
    """Return the spec of the program that `subprocess.Popen` would start with these arguments."""
    words = [args] if isinstance(args, (str, bytes)) or not isinstance(args, Sequence) else list(args)
    return ProcessSpec(
        argv=tuple(word.decode() if isinstance(word, bytes) else str(word) for word in words),
        name=process.name,
        cwd=process.cwd if cwd is None else process.path(str(cwd)),
        env=dict(process.env if env is None else env),
        shell=shell,
        origin=process.spec.origin,
        has_pipe=process.spec.has_pipe,
    )


class Child:
    """The simulated `subprocess.Popen`. Simulated time passes while a program waits for its child.

    :param process: the program that starts the child.
    :param input: the whole input of a simulated child, as a string or bytes.
    :param stdin: with `PIPE`, a simulated child reads what is written to the attribute `stdin`.
    :raises FileNotFoundError: if there is no such command.
    """

    def __init__(
        self,
        process: Process,
        args: Any,
        *,
        stdout: Any = None,
        stderr: Any = None,
        text: bool | None = None,
        universal_newlines: bool | None = None,
        encoding: str | None = None,
        input: Any = None,
        stdin: Any = None,
        **options: Any,
    ) -> None:
        self.args = args
        self.text = bool(text or universal_newlines or encoding)
        self.returncode: int | None = None
        self.waiters: deque[Task] = deque()
        self.stdout = Pipe(self) if stdout == subprocess.PIPE else None
        self.stderr = Pipe(self) if stderr == subprocess.PIPE else None
        self._sinks = {'stdout': _sink(process, 'stdout', stdout, self.stdout)}
        self._sinks['stderr'] = (
            self._sinks['stdout'] if stderr == subprocess.STDOUT else _sink(process, 'stderr', stderr, self.stderr)
        )
        program: Any = process.host.start(spec_of(process, args, **options), self._on_output, self._on_exit)
        program.is_recorded = False  # the caller writes the output that no program captures, so it is recorded once
        self._program = program
        self.stdin: InputEnd | None = None
        if input is not None:
            _give_input(program, Input(input.decode() if isinstance(input, bytes) else input))
        elif stdin is None:
            inherit_terminal(process, program)
        elif stdin == subprocess.PIPE:
            pipe = PipedInput()
            _give_input(program, pipe)
            self.stdin = InputEnd(pipe)
        self.pid: int = program.pid

    def __enter__(self) -> Child:
        return self

    def __exit__(self, *_: object) -> None:
        self.wait()

    def __repr__(self) -> str:
        return f'<Popen: returncode: {self.returncode} args: {self.args!r}>'

    def _on_output(self, stream: str, text: str) -> None:
        self._sinks[stream](text)
        self._tell()

    def _on_exit(self, returncode: int) -> None:
        self.returncode = returncode
        self._tell()

    def _tell(self) -> None:
        for task in self.waiters:
            task.wake()

    def poll(self) -> int | None:
        """Return the return code of the child, or None while the child runs."""
        return self.returncode

    def wait(self, timeout: float | None = None) -> int:
        """Wait until the child has ended, and return its return code.

        :param timeout: simulated seconds, or None for no limit.
        :raises subprocess.TimeoutExpired: if the child still runs after `timeout` seconds.
        """
        if not wait_until(lambda: self.returncode is not None, self.waiters, timeout):
            assert timeout is not None
            raise subprocess.TimeoutExpired(self.args, timeout)
        assert self.returncode is not None
        return self.returncode

    def communicate(self, input: Any = None, timeout: float | None = None) -> tuple[Any, Any]:
        """Wait until the child has ended, and return (stdout, stderr). A stream that is not a pipe has the value None.

        :param input: the string or bytes to write to the pipe `stdin` first.
        :param timeout: simulated seconds, or None for no limit.
        :raises subprocess.TimeoutExpired: if the child still runs after `timeout` seconds.
        """
        if self.stdin is not None:
            if input is not None:
                self.stdin.write(input)
            self.stdin.close()
        self.wait(timeout)
        return tuple(None if pipe is None else pipe.read() for pipe in (self.stdout, self.stderr))  # type: ignore[return-value]

    @property
    def is_passed_on(self) -> bool:
        """Whether the parent passes a Ctrl-C that it receives on to the child."""
        return bool(self._program.is_passed_on)

    @is_passed_on.setter
    def is_passed_on(self, passed_on: bool) -> None:
        self._program.is_passed_on = passed_on

    def send_signal(self, signum: int) -> None:
        """Send a signal to the child. Do nothing if the child has ended."""
        if self.returncode is None:
            self._program.send_signal(signum)

    def terminate(self) -> None:
        """Send SIGTERM."""
        self.send_signal(Signals.SIGTERM)

    def kill(self) -> None:
        """Send SIGKILL."""
        self.send_signal(Signals.SIGKILL)


class InputEnd:
    """The end of a child's input pipe to which the parent writes."""

    closed = False

    def __init__(self, pipe: PipedInput) -> None:
        self._pipe = pipe

    def write(self, data: Any) -> int:
        """Write a string or bytes, which the child can read immediately, and return the length of `data`."""
        self._pipe.feed(data if isinstance(data, str) else bytes(data).decode('utf-8', 'replace'))
        return len(data)

    def flush(self) -> None:
        """Do nothing, because nothing is buffered."""

    def close(self) -> None:
        """Close the pipe, so that the input of the child ends."""
        self.closed = True
        self._pipe.feed('', last=True)


class Pipe:
    """The end of a child's output pipe from which the parent reads.

    Reading waits in simulated time until there is enough output, or until the child has ended.
    """

    def __init__(self, child: Child) -> None:
        self._child = child
        self._text = ''

    def feed(self, text: str) -> None:
        """Add output of the child to the pipe."""
        self._text += text

    def _cut(self, length: int) -> Any:
        text, self._text = self._text[:length], self._text[length:]
        return text if self._child.text else text.encode()

    def _wait(self, ready: Callable[[], bool]) -> None:
        child = self._child
        wait_until(lambda: child.returncode is not None or ready(), child.waiters, None)

    def read(self, size: int = -1) -> Any:
        """Return `size` characters, or, without `size`, all output until the child ends."""
        self._wait(lambda: 0 <= size <= len(self._text))
        return self._cut(len(self._text) if size < 0 else size)

    def readline(self) -> Any:
        """Return the next line, or an empty string at the end of the output."""
        self._wait(lambda: '\n' in self._text)
        end = self._text.find('\n')
        return self._cut(len(self._text) if end < 0 else end + 1)

    def readlines(self) -> list[Any]:
        """Return all lines until the end of the output."""
        return list(self)

    def __iter__(self) -> Iterator[Any]:
        return iter(self.readline, '' if self._child.text else b'')

    def close(self) -> None:
        """Do nothing, because a simulated pipe does not use a resource of the operating system."""


def inherit_terminal(process: Process, child: Any) -> None:
    """Make a child read from the keyboard of the program that started it, if that program reads from a keyboard."""
    if getattr(process.streams.stdin, 'is_inherited', False):
        _give_input(child, process.streams.stdin)


def _give_input(child: Any, stdin: Any) -> None:
    """Make a simulated child read from `stdin`. A real child has its own stream."""
    if isinstance(child, Process):
        child.streams.stdin = stdin


def _sink(process: Process, stream: str, where: Any, pipe: Pipe | None) -> Callable[[str], object]:
    """Return the function that receives the child's output and writes it to a pipe, a file, nowhere, or the parent's own
    stream.
    """
    if pipe is not None:
        return pipe.feed
    if where == subprocess.DEVNULL:
        return lambda text: None
    if where is None or isinstance(where, int):
        return lambda text: process.write(stream, text)
    return lambda text: where.write(text if isinstance(where, io.TextIOBase) or not hasattr(where, 'raw') else text.encode())

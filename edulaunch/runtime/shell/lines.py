"""Shell lines with commands of the simulation: `sleep 2; ros2 service call ... && ros2 topic list | grep turtle`.

A real shell cannot reach the simulated programs, so such a line runs here, in simulated time. `grammar` defines these lines and
the meaning of their words, and `filters` contains the programs after a `|`.
"""

from __future__ import annotations

import os
import signal
import subprocess
from collections.abc import Callable, Sequence
from contextlib import suppress
from typing import Any

from edulaunch.engine.processes.children import Child
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.sync import sleep
from edulaunch.runtime.shell.filters import Filter, RealFilter, Sink, is_filter
from edulaunch.runtime.shell.grammar import Command, Expansion, Job, Line, Pipeline, Redirection, commands, known_words, parsed
from edulaunch.runtime.shell.signs import SHELLS

_UNITS = {'s': 1, 'm': 60, 'h': 3600}
_NOT_FOUND = 127


def is_simulated(line: Line | None, arguments: Sequence[str], knows: Callable[[Sequence[str]], bool]) -> bool:
    """Return whether a line must run in the simulation: it can be parsed, and contains a command of the simulation."""
    return any(knows(words) for command in commands(line or ()) if (words := known_words(command, arguments)))


def run_line(process: Process, text: str) -> int:
    """Run a line, and return the status of its last command. Ctrl-C interrupts the current command, and ends the line."""
    shell = Shell(process, process.argv[3:])
    try:
        shell.run(parsed(text) or ())
    except KeyboardInterrupt:
        process.lifecycle.exit_now(-signal.SIGINT)
    except _Exit:
        pass
    return shell.status


class _Exit(Exception):  # noqa: N818  # not an error
    """The line contains `exit`."""


class Shell:
    """Runs lines in a process.

    :param arguments: `$0`, `$1` and so on.
    :ivar status: the status of the command that ended last.
    """

    def __init__(self, process: Process, arguments: Sequence[str] = (), out: Sink | None = None) -> None:
        self.process = process
        self.status = 0
        self._arguments = list(arguments)
        self._out: Sink = _Stream(process, 'stdout') if out is None else out

    def run(self, line: Line) -> None:
        """Run the jobs one after another.

        :raises KeyboardInterrupt: on Ctrl-C, after the running command has ended.
        """
        for job in line:
            if job.is_beside:
                self._start_beside(job)
                continue
            for joint, pipeline in job.parts:
                if not (joint == '&&' and self.status != 0 or joint == '||' and self.status == 0):
                    self.status = self._run(pipeline)

    def _start_beside(self, job: Job) -> None:
        """Start a job and continue. Skip a job that contains only shell commands, because it has no visible effect."""
        if is_simulated((job,), self._arguments, self._knows):
            streams: dict[str, Any] = {stream: _Inherited(self.process, stream) for stream in ('stdout', 'stderr')}
            Child(self.process, ['sh', '-c', job.text, *self._arguments], **streams)
        self.status = 0

    def _knows(self, words: Sequence[str]) -> bool:
        return self.process.host.knows(ProcessSpec(argv=tuple(words), name=''))

    def _run(self, pipeline: Pipeline) -> int:
        """Build the pipeline from its end, and wait for its commands. Return the status of the last command."""
        sink = self._out
        stages: list[_Ended | Child | Filter | RealFilter] = []
        running: list[tuple[Child, Sink]] = []
        for command in reversed(pipeline):
            is_first = command is pipeline[0]
            words, env = self._prepared(command)
            out, streams = self._streams(command.redirections, sink)
            if not words or words[0] in _OWN:
                stages.append(_Ended(_OWN[words[0]](self, words, out) if words else 0))
                out.close()
                sink = _NULL_SINK
            elif not is_first and not self._knows(words):
                sink = self._filter(words, out, env, running)
                stages.append(sink)
            else:
                child = self._started(words, env, streams if is_first else {'stdin': subprocess.PIPE, **streams})
                stages.append(child or _Ended(_NOT_FOUND))
                running[:0] = [(child, out)] if child else []
                sink = (child and child.stdin) or _NULL_SINK
        self._wait(running)
        return stages[0].returncode or 0

    def _prepared(self, command: Command) -> tuple[list[str], dict[str, str]]:
        """Return the words and the environment of a command. Variables without a command are set for the following commands."""
        expansion = self._expansion()
        settings = {name: expansion.one(value) for name, value in command.settings}
        words = expansion.words(command.words)
        words = words[words[:1] == ['exec'] :] if command.words else words
        if not words:
            self.process.env.update(settings)
        return words, {**self.process.env, **settings}

    def _expansion(self) -> Expansion:
        variables = {**self.process.env, '?': str(self.status)}
        return Expansion(variables, self._arguments, self.process.cwd, self._written)

    def _written(self, line: Line) -> str:
        """Return the output of a line in `$(...)`. Its changes, such as a new current folder, are discarded."""
        process, text = self.process, _Text()
        env, cwd = dict(process.env), process.cwd
        with suppress(_Exit):
            Shell(process, self._arguments, text).run(line)
        process.env.clear()
        process.env.update(env)
        process.cwd = cwd
        return ''.join(text.parts)

    def _streams(self, redirections: Sequence[Redirection], sink: Sink) -> tuple[Sink, dict[str, Any]]:
        """Return the destination of the output, and the options for :class:`Child`."""
        out = sink
        options: dict[str, Any] = {} if type(sink) is _Stream else {'stdout': sink}
        for stream, mode, place in redirections:
            path = os.path.join(self.process.cwd or os.getcwd(), self._expansion().one(place)) if place else ''
            if stream == 'stdin':
                with open(path, encoding='utf-8') as file:
                    options['input'] = file.read()
                continue
            where: Any = _File(path, mode) if place else subprocess.STDOUT
            options['stderr' if stream == 'stderr' else 'stdout'] = where
            if stream != 'stderr':
                out = where
            if stream == 'both':
                options['stderr'] = subprocess.STDOUT
        return out, options

    def _filter(self, words: list[str], out: Sink, env: dict[str, str], running: list[tuple[Child, Sink]]) -> Any:
        if not is_filter(words):
            return RealFilter(words, out, self.process.cwd, env)
        behind = len(running)
        return Filter(words, out, lambda: _kill(running[: len(running) - behind]))

    def _started(self, words: list[str], env: dict[str, str], streams: dict[str, Any]) -> Child | None:
        try:
            child = Child(self.process, words, env=env, **streams)
        except FileNotFoundError:
            self.process.write('stderr', f'sh: {words[0]}: not found\n')
            return None
        child.is_passed_on = True
        return child

    def _wait(self, running: list[tuple[Child, Sink]]) -> None:
        try:
            for child, out in running:
                child.wait()
                out.close()
        except KeyboardInterrupt:
            for child, _ in running:
                child.send_signal(signal.SIGINT)
            for child, out in running:
                child.wait()
                out.close()
            raise


def _kill(running: list[tuple[Child, Sink]]) -> None:
    for child, _ in running:
        child.kill()


class _Ended:
    """A command of the shell itself, which has already ended."""

    def __init__(self, returncode: int) -> None:
        self.returncode = returncode


class _Stream:
    """The output of the process that runs the line."""

    def __init__(self, process: Process, stream: str) -> None:
        self._process, self._stream = process, stream

    def write(self, text: str) -> None:
        """Write to the output of the process."""
        self._process.write(self._stream, text)

    def close(self) -> None:
        """Do nothing: the stream stays open."""


class _Text(_Stream):
    """Stores the output."""

    def __init__(self) -> None:
        self.parts: list[str] = []

    def write(self, text: str) -> None:
        """Store the text."""
        self.parts.append(text)


class _NullSink(_Text):
    """Discards output without a reader."""

    def write(self, text: str) -> None:
        """Discard the text."""


_NULL_SINK = _NullSink()


class _File:
    """A file that a command writes to. It is open only during each write, because the last write is not known."""

    def __init__(self, path: str, mode: str) -> None:
        self._path = path
        with open(self._path, mode):
            pass

    def write(self, text: str) -> None:
        """Append to the file."""
        with open(self._path, 'a', encoding='utf-8') as file:
            file.write(text)

    def close(self) -> None:
        """Do nothing: the file is already closed."""


class _Inherited(_Stream):
    """The output of a background command. The program that started the line receives this output, if that program reads
    output.
    """

    def write(self, text: str) -> None:
        """Pass the text on."""
        if self._process.on_output is not None and (not self._process.is_recorded or not self._process.lifecycle.is_dead):
            self._process.on_output(self._stream, text)


# the shell's own commands: their arguments are the words, and the destination of the output


def _nothing(shell: Shell, words: list[str], out: Sink) -> int:
    return 0


def _fail(shell: Shell, words: list[str], out: Sink) -> int:
    return 1


def _sleep(shell: Shell, words: list[str], out: Sink) -> int:
    sleep(sum(float(word.rstrip('smh')) * _UNITS.get(word[-1], 1) for word in words[1:]))
    return 0


def _echo(shell: Shell, words: list[str], out: Sink) -> int:
    options = [word for word in words[1:2] if word in ('-n', '-e', '-ne', '-en')]
    text = ' '.join(words[1 + len(options) :])
    if options and 'e' in options[0]:
        text = text.replace('\\n', '\n').replace('\\t', '\t')
    out.write(text if options and 'n' in options[0] else text + '\n')
    return 0


def _pwd(shell: Shell, words: list[str], out: Sink) -> int:
    out.write((shell.process.cwd or os.getcwd()) + '\n')
    return 0


def _cd(shell: Shell, words: list[str], out: Sink) -> int:
    process = shell.process
    path = os.path.normpath(os.path.join(process.cwd or os.getcwd(), *(words[1:] or [process.env.get('HOME', '/')])))
    if not os.path.isdir(path):
        process.write('stderr', f'sh: cd: {words[1]}: No such file or directory\n')
        return 1
    process.cwd = path
    return 0


def _export(shell: Shell, words: list[str], out: Sink) -> int:
    shell.process.env.update(word.split('=', 1) for word in words[1:] if '=' in word)  # type: ignore[misc]
    return 0


def _unset(shell: Shell, words: list[str], out: Sink) -> int:
    for word in words[1:]:
        shell.process.env.pop(word, None)
    return 0


def _exit(shell: Shell, words: list[str], out: Sink) -> int:
    shell.status = int(words[1]) if words[1:] else shell.status
    raise _Exit


def _shell(shell: Shell, words: list[str], out: Sink) -> int:
    """Run a shell with arguments. Without arguments, do nothing: `...; exec bash` keeps a window open that does not exist
    here.
    """
    if len(words) == 1:
        return 0
    child = Child(shell.process, words, stdout=out)
    child.is_passed_on = True
    return child.wait()


_OWN: dict[str, Callable[[Shell, list[str], Sink], int]] = {
    'sleep': _sleep,
    'echo': _echo,
    'pwd': _pwd,
    'cd': _cd,
    'export': _export,
    'unset': _unset,
    'true': _nothing,
    'false': _fail,
    ':': _nothing,
    'exit': _exit,
    'source': _nothing,
    '.': _nothing,
    **dict.fromkeys(SHELLS, _shell),
}
"""`source` reads setup files of ROS 2, which the simulation does not need."""

"""Shell lines that join commands of the simulation: `sleep 2; ros2 service call ... && ros2 run ...`.

A real shell could not reach the simulated programs, so such a line is followed here, in simulated time.
"""

from __future__ import annotations

import os
import re
import shlex
import signal
import subprocess
from collections.abc import Callable, Iterator
from typing import Any, NamedTuple

from edulaunch.processes.children import Child
from edulaunch.processes.host import SHELLS
from edulaunch.processes.process import Process
from edulaunch.sim.sync import sleep

_ARGUMENTS = re.compile(r'("?)\$([0@*])\1')
_UNITS = {'s': 1, 'm': 60, 'h': 3600}
_JOINTS = ('&&', '||', ';', '&')
_REDIRECTION = re.compile(r'((?<!\S)[12]|&|)(>>?)\s*(&1|[^\s&|;<>()$`*?]+)')
_OTHER_SIGNS = frozenset('|&<>()$`\\*?[]#~\n')
"""What a real shell must do: pipes, reading files, variables, patterns."""


class Part(NamedTuple):
    """One command of a line.

    :ivar joint: what stands before it: '', '&&', '||', ';' or '&'.
    :ivar outlets: where its output goes, if elsewhere: by stream a file and how to open it, or None for where stdout goes.
    :ivar is_beside: whether the line goes on without waiting for it, for the sake of a `&`.
    """

    joint: str
    words: list[str]
    outlets: dict[str, tuple[str, str] | None]
    is_beside: bool


def parts_of(line: str) -> list[Part] | None:
    """The commands of a line in order; None for one with signs that only a real shell understands."""
    parts: list[Part] = []
    joint, text, begin, chain, outlets = '', '', 0, 0, {}
    for position, sign in (*_signs(line), (len(line), '')):
        text, begin = text + line[begin:position], position + len(sign)
        redirection = _REDIRECTION.fullmatch(sign)
        if redirection is not None:
            outlets.update(_outlets_of(*redirection.groups()))
            continue
        if sign and sign not in _JOINTS:
            return None
        try:
            words = shlex.split(text)
        except ValueError:  # a quote is open
            return None
        if words:
            parts.append(Part(joint, words[words[0] == 'exec' :] or ['true'], outlets, sign == '&'))
        if sign == '&' and words and (joint in ('&&', '||') or _own(words) is not None):  # all of `a && b &` runs beside
            while parts[-1].joint in ('&&', '||'):
                parts.pop()
            parts[-1] = Part(parts[-1].joint, ['sh', '-c', line[chain:position]], {}, True)
        chain = chain if sign in ('&&', '||') else begin
        joint, text, outlets = sign, '', {}
    return parts or None


def _outlets_of(stream: str, sign: str, place: str) -> dict[str, tuple[str, str] | None]:
    """What `2> FILE`, `&>> FILE` or `2>&1` say about the output."""
    outlet = None if place == '&1' else (place, 'w' if sign == '>' else 'a')
    return {'stdout': outlet, 'stderr': None} if stream == '&' else {'stderr' if stream == '2' else 'stdout': outlet}


def with_arguments(line: str, words: list[str]) -> str:
    """The line of `bash -c LINE WORD...`: `$0` is the first of the words behind it, `$@` and `$*` are the others.

    A prefix that many launch files have to start a node later is `bash -c 'sleep 5; $0 $@'`.
    """
    if not words or "'" in line:
        return line
    values = {'0': shlex.quote(words[0]), '@': shlex.join(words[1:]), '*': shlex.join(words[1:])}
    return _ARGUMENTS.sub(lambda found: values[found[2]], line)


def _signs(line: str) -> Iterator[tuple[int, str]]:
    """Each sign that a shell does not take as a letter, with its place."""
    quote, position = '', 0
    while position < len(line):
        letter = line[position]
        sign = line[position : position + 2] if line[position : position + 2] in _JOINTS else letter
        redirection = None if quote else _REDIRECTION.match(line, position)
        if redirection is not None:
            yield position, redirection[0]
            position = redirection.end() - 1
        elif quote:
            quote = '' if letter == quote else quote
            if quote == '"' and letter in '$`\\':
                yield position, letter
        elif letter in '"\'':
            quote = letter
        elif sign in _JOINTS or letter in _OTHER_SIGNS:
            yield position, sign
            position += len(sign) - 1
        position += 1


def is_simulated(parts: list[Part], knows: Callable[[list[str]], bool]) -> bool:
    """Whether a line can be followed here: the simulation knows each command that is not the shell's own, and there is one."""
    others = [part.words for part in parts if _own(part.words) is None]
    plain = all(not part.outlets and not part.is_beside for part in parts if _own(part.words) is not None)
    return bool(others) and plain and all(map(knows, others))


def run_line(process: Process, line: str) -> int:
    """Follow a line; returns the status of its last command. Ctrl-C reaches the command that runs, and ends the line."""
    status = 0
    try:
        for joint, words, outlets, is_beside in parts_of(line) or ():
            if joint == '&&' and status != 0 or joint == '||' and status == 0:
                continue
            if words[0] == 'exit':
                return int(words[1]) if words[1:] else status
            own = _own(words)
            status = _run(process, words, outlets, is_beside) if own is None else own(process, words)
    except KeyboardInterrupt:
        process.end_by(signal.SIGINT)
    return status


def _run(process: Process, words: list[str], outlets: dict[str, tuple[str, str] | None], is_beside: bool) -> int:
    places: dict[str, Any] = {stream: _Inherited(process, stream) for stream in ('stdout', 'stderr') if is_beside}
    for stream, outlet in outlets.items():
        places[stream] = subprocess.STDOUT if outlet is None else _File(process, *outlet)
    child = Child(process, words, **places)
    if is_beside:
        return 0
    child.is_passed_on = True
    try:
        return child.wait()
    except KeyboardInterrupt:
        child.send_signal(signal.SIGINT)
        child.wait()
        raise


class _File:
    """A file that a command writes into. It is open only while something is written: nobody knows when the last comes."""

    def __init__(self, process: Process, path: str, mode: str) -> None:
        self._path = os.path.join(process.cwd or os.getcwd(), os.path.expanduser(path))
        with open(self._path, mode):
            pass

    def write(self, text: str) -> None:
        """Add to it."""
        with open(self._path, 'a', encoding='utf-8') as file:
            file.write(text)


class _Inherited:
    """Where a command writes that a line has left behind: to the program that started the line, if that hears it."""

    def __init__(self, process: Process, stream: str) -> None:
        self._process = process
        self._stream = stream

    def write(self, text: str) -> None:
        """Pass it on."""
        if self._process.on_output is not None and (not self._process.is_heard or not self._process.is_gone):
            self._process.on_output(self._stream, text)


# The shell's own commands


def _own(words: list[str]) -> Callable[[Process, list[str]], int] | None:
    if words[0] in SHELLS and len(words) == 1:  # `...; exec bash` keeps a window open that is not there
        return _nothing
    return _OWN.get(words[0])


def _nothing(process: Process, words: list[str]) -> int:
    return 0


def _sleep(process: Process, words: list[str]) -> int:
    sleep(sum(float(word.rstrip('smh')) * _UNITS.get(word[-1], 1) for word in words[1:]))
    return 0


def _echo(process: Process, words: list[str]) -> int:
    process.write('stdout', ' '.join(words[1:]) + '\n')
    return 0


def _cd(process: Process, words: list[str]) -> int:
    process.cwd = os.path.join(process.cwd or os.getcwd(), *words[1:])
    return 0


def _export(process: Process, words: list[str]) -> int:
    process.env.update(word.split('=', 1) for word in words[1:] if '=' in word)  # type: ignore[misc]
    return 0


_OWN: dict[str, Callable[[Process, list[str]], int]] = {
    'sleep': _sleep,
    'echo': _echo,
    'cd': _cd,
    'export': _export,
    'true': _nothing,
    'exit': _nothing,
    'source': _nothing,
    '.': _nothing,
}
"""`source` reads setup files of ROS 2, which the simulation does not need."""

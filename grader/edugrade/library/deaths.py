"""Finds the programs of a run that died, and the last lines that they printed."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from ..evidence import Evidence, Failure
from ..faults import advice_on_limits
from ..shortened import shortened
from ..source import Place, is_shipped
from .identity import processes_of
from .launched import launched

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import ProcessRecord

DIED = re.compile(r"\[ERROR\] \[([^\]\n]+)\]: process has died \[pid \d+, exit code (-?\d+), cmd '(.*)'\]")
ERROR = re.compile(r'\[(?:ERROR|FATAL)\]|^\w*(?:Error|Exception)\b')
WHAT = re.compile(r'^\s*what\(\):\s*')  # the message of an exception in C++
USAGE = re.compile(r'^\s|^usage:|^$')
BROKEN_FILE = re.compile(r"Couldn't parse params file: '--params-file ([^'\n]+)'\. Error: ([^\n]*)")
LINE = re.compile(r'\bline (\d{1,6})\b')
LONGEST_LINE = 300
ENDLESS = {
    'turtlesim': ('turtlesim_node', 'draw_square', 'mimic'),
    'demo_nodes_py': ('talker', 'listener'),
    'demo_nodes_cpp': ('talker', 'listener'),
    'turtle_tf2_py': ('turtle_tf2_broadcaster', 'turtle_tf2_listener', 'fixed_frame_tf2_broadcaster'),
    'tf2_ros': ('static_transform_publisher',),
}
"""Programs of edulaunch that never end by themselves, by package."""
ENDED_BY_LAUNCH = (-2, -15)  # SIGINT and SIGTERM, which launch sends at shutdown
INTERRUPTED = (2, 130)  # exit codes of programs that handle SIGINT themselves


class Death(NamedTuple):
    """A program that ended before the end of its run with an exit code other than 0.

    :ivar process: the record of the program, or None for a real program, which appears only in the output of launch.
    """

    name: str
    returncode: int
    process: ProcessRecord | None
    when_s: float


def refuse_dead(run: Evidence) -> None:
    """Fail if a program died before the end of its run. The program may be simulated or real, and a shell may have started it.

    :raises Failure: with the message and the place of the exception, or with the last line that the program printed.
    """
    for name, recording in run.items():
        for death in deaths(recording):
            raise _failure(recording, death, run.scenario(name).words)


def refuse_gone(run: Evidence) -> None:
    """Fail if a program ended before the end of its run although it never ends by itself.

    The program may have ended without an error. Without this check, a node that exists only for a moment could pass the
    checks of names, parameters and subscriptions.

    :raises Failure: with the program and the time of its end.
    """
    for name, recording in run.items():
        programs = ((package, executable) for package, known in ENDLESS.items() for executable in known)
        for position in sorted(position for program in programs for position in processes_of(recording, *program)):
            process = recording.processes[position]
            if process.ended_s is not None and process.ended_s < recording.duration_s:
                raise Failure(
                    f'{process.name} ends after {process.ended_s:.1f} s in the run with {run.scenario(name).words}',
                    expected=f'{process.name} runs until the end of the run',
                    seen=f'something ends it, since {process.executable} never ends by itself',
                    where=process.origin,
                    try_='remove what sends it a signal or shuts down the launch',
                )


def deaths(recording: Recording) -> Iterator[Death]:
    """Yield the programs that died: first the simulated programs in the order in which they started, then the real programs."""
    known = launched(recording)
    for process in known:
        if process.returncode and not _ends_with_launch(recording, process):
            yield Death(process.name, process.returncode, process, process.ended_s or 0.0)
    names = {process.name for process in known}
    for output in getattr(recording, 'output', ()):
        if output.process == 'launch':
            for name, code, _ in DIED.findall(output.text):
                if name not in names and int(code) not in ENDED_BY_LAUNCH:
                    yield Death(name, int(code), None, output.time_s)


def _ends_with_launch(recording: Recording, process: ProcessRecord) -> bool:
    """Return whether the shutdown of launch has interrupted a program. `ros2` commands then return the number of the signal."""
    launch = recording.processes[0]
    is_over = launch.name == 'launch' and launch.ended_s is not None and process.ended_s == launch.ended_s
    return is_over and process.exception is None and process.returncode in (*ENDED_BY_LAUNCH, *INTERRUPTED)


def words_on_deaths(run: Evidence) -> str:
    """Return a line about the first program that died, with its exception or the last line that it printed. Return '' if no
    program died.
    """
    for recording in run.values():
        for death in deaths(recording):
            error = death.process.exception if death.process else None
            line = f'{error["type"]}: {error["message"]}' if error is not None else last_line(recording, death.name)
            if not line:
                return f'{death.name} died with exit code {death.returncode}'
            return f'{death.name} died with exit code {death.returncode}: {shortened(line, LONGEST_LINE)}'
    return ''


def last_line(recording: Recording, name: str) -> str:
    """Return the line that best explains why a program died: its last error line, or its last line, or ''.

    :param name: the name of the program.
    """
    lines: list[str] = []
    for output in getattr(recording, 'output', ()):
        if output.process == name:
            lines += output.text.splitlines()
        elif output.process == 'launch':  # launch writes the lines of a real program
            prefix = f'[{name}] '
            lines += [line.removeprefix(prefix) for line in output.text.splitlines() if line.startswith(prefix)]
    spoken = [line for line in lines if not USAGE.match(line)]
    errors = [line for line in spoken if ERROR.search(line)]
    messages = [WHAT.sub('', line) for line in lines if WHAT.match(line)]
    return shortened((errors or messages or spoken or [''])[-1], LONGEST_LINE)


def _failure(recording: Recording, death: Death, words: str) -> Failure:
    rationale = f'{death.name} died after {death.when_s:.1f} s with exit code {death.returncode} in the run with {words}'
    expected = f'{death.name} runs without an error'
    origin = death.process.origin if death.process else None
    error = death.process.exception if death.process else None
    if error is not None:
        at = '' if origin is None else f' ({origin[0]}:{origin[1]})'
        broken = BROKEN_FILE.search(str(error['message']))
        if broken is not None:
            return _broken_file(death, broken, at, words)
        where = Place(error['file'], error['line']) if error.get('file') else origin
        seen = f'{error["type"]}: {error["message"]}'
        advice = advice_on_limits(seen) or _advice_on(death, where, at)
        return Failure(rationale, expected=expected, seen=seen, where=where, try_=advice)
    printed = last_line(recording, death.name)
    advice = (
        'correct the mistake that the line "seen" describes'
        if printed
        else 'start it in a terminal of its own to see why it ends'
    )
    return Failure(rationale, expected=expected, seen=printed or 'no output', where=origin, try_=advice)


def _advice_on(death: Death, where: tuple[str, int | None] | None, at: str) -> str:
    """Return what to do about an exception in the student's own program, or in the call of a program of edulaunch."""
    if where is not None and death.process is not None and where != death.process.origin and not is_shipped(where[0]):
        return 'correct this line of the program'
    return f'check the arguments and parameters that the launch file passes to {death.name}{at}'


def _broken_file(death: Death, broken: re.Match[str], at: str, words: str) -> Failure:
    """Return a failure that names the parameter file that a program could not read, with the line of the mistake if it is
    known.
    """
    file, error = broken.groups()
    line = LINE.search(error)
    return Failure(
        f'{death.name} died because it cannot read the parameter file {file} in the run with {words}',
        expected='a file of the form that ROS 2 reads',
        seen=error,
        where=Place(file, int(line[1]) if line else None),
        try_=f'correct this parameter file, which the launch file passes to the node{at}',
    )

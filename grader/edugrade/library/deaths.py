"""Which programs of a run died, and what they printed last."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, NamedTuple

from ..evidence import Evidence, Failure
from ..shortened import shortened
from ..source import Place
from .launched import launched

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import ProcessRecord

DIED = re.compile(r"\[ERROR\] \[([^\]\n]+)\]: process has died \[pid \d+, exit code (-?\d+), cmd '(.*)'\]")
ERROR = re.compile(r'\[(?:ERROR|FATAL)\]|^\w*(?:Error|Exception)\b')
USAGE = re.compile(r'^\s|^usage:|^$')
LONGEST_LINE = 300
ENDED_BY_LAUNCH = (-2, -15)  # SIGINT and SIGTERM, when launch shuts down


class Death(NamedTuple):
    """A program that ended with another exit code than 0 before its run was over.

    :ivar process: its record; None for a real program, of which only launch's own line tells.
    """

    name: str
    returncode: int
    process: ProcessRecord | None
    when_s: float


def refuse_dead(run: Evidence) -> None:
    """Fail when a program died before its run was over: a simulated one, a real one, or one that a shell line started.

    :raises Failure: with the exception's own text and place when one ended it, else with the last line that it printed.
    """
    for name, recording in run.items():
        for death in deaths(recording):
            raise _failure(recording, death, run.scenario(name).words)


def deaths(recording: Recording) -> Iterator[Death]:
    """Yield the programs that died: the simulated ones in the order of their start, then the real ones."""
    known = launched(recording)
    for process in known:
        if process.returncode:
            yield Death(process.name, process.returncode, process, process.ended_s or 0.0)
    names = {process.name for process in known}
    for output in getattr(recording, 'output', ()):
        if output.process == 'launch':
            for name, code, _ in DIED.findall(output.text):
                if name not in names and int(code) not in ENDED_BY_LAUNCH:
                    yield Death(name, int(code), None, output.time_s)


def last_line(recording: Recording, name: str) -> str:
    """Return the line that says best why a program died: the last error, else the last line; '' when it printed nothing."""
    lines: list[str] = []
    for output in getattr(recording, 'output', ()):
        if output.process == name:
            lines += output.text.splitlines()
        elif output.process == 'launch':  # a real program's lines are launch's only
            prefix = f'[{name}] '
            lines += [line.removeprefix(prefix) for line in output.text.splitlines() if line.startswith(prefix)]
    spoken = [line for line in lines if not USAGE.match(line)]
    errors = [line for line in spoken if ERROR.search(line)]
    return shortened((errors or spoken or [''])[-1], LONGEST_LINE)


def _failure(recording: Recording, death: Death, words: str) -> Failure:
    rationale = f'{death.name} died after {death.when_s:.1f} s, when launched with {words}'
    origin = death.process.origin if death.process else None
    error = death.process.exception if death.process else None
    if error is not None:
        at = '' if origin is None else f', at {origin[0]}:{origin[1]}'
        return Failure(
            rationale,
            expected='it runs until the end',
            seen=f'{error["type"]}: {error["message"]}',
            where=Place(error['file'], error['line']) if error.get('file') else origin,
            try_=f'look at what the launch file gives it{at}',
        )
    printed = last_line(recording, death.name)
    return Failure(
        rationale,
        expected='it runs until the end',
        seen='\n'.join(filter(None, (f'exit code {death.returncode}', printed))),
        where=origin,
        try_='repair what its last line says' if printed else 'start it in a terminal of its own to see why it ends',
    )

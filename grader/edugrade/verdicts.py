"""Says in words what a child process came to. Whatever it sends is data: it is measured and parsed, never run."""

from __future__ import annotations

import json
import signal
from typing import Any

from .child_run import HEADER_BYTES, ChildRun
from .outcome import Outcome
from .place import Place

REPORT_IT = 'please report this with the launch file and the --json report; it costs no marks'
_LOOP = 'look for a loop that never ends, or for a wait without a time limit'
_OWN_EXIT = 'take out calls of sys.exit(), os._exit() and os.kill(): a launch file only describes, and launch ends its processes'


def verdict(run: ChildRun) -> Outcome:
    """What an ended child came to."""
    if run.complete and run.cut is None:
        return _answered(
            run, chr(run.frame[0]), bytes(run.frame[HEADER_BYTES : HEADER_BYTES + run.announced])
        )
    if run.cut is not None:
        return _cut(run)
    return _ended(run)


def _answered(run: ChildRun, letter: str, content: bytes) -> Outcome:
    if letter == 'R':
        return _recorded(run, content)
    report = _report(content)
    if report is None:
        return _garbage(run)
    where = _place(report)
    if letter == 'U':
        return Outcome(
            run.scenario,
            'unusable',
            text=_text(report, 'text'),
            try_=_text(report, 'help') or None,
            where=where,
        )
    if letter == 'B':
        return Outcome(
            run.scenario,
            'broke',
            text=f'the simulation itself broke: {_text(report, "text")}',
            try_=REPORT_IT,
            detail=_text(report, 'trace'),
        )
    return _stopped(run, report, where)


def _recorded(run: ChildRun, content: bytes) -> Outcome:
    from edulaunch.recording import Recording

    try:
        recording = Recording.from_bytes(content)
        if recording.seed != run.scenario.seed or recording.launch.arguments != dict(run.scenario.arguments):
            return _garbage(run)
    except Exception:  # hostile bytes may upset the reader in any way; each of them means the same
        return _garbage(run)
    return Outcome(run.scenario, 'recorded', recording=recording)


def _stopped(run: ChildRun, report: dict[str, Any], where: Place | None) -> Outcome:
    reason = report.get('reason')
    if reason == 'timeout':
        return _timeout(run, where)
    if reason == 'memory':
        return _memory(run)
    if reason == 'exit':
        return Outcome(
            run.scenario,
            'stopped',
            text='the launch file ended the whole program itself',
            try_=_OWN_EXIT,
            where=where,
        )
    if reason == 'runaway':
        return Outcome(
            run.scenario,
            'stopped',
            text=_text(report, 'text'),
            try_=_text(report, 'help') or _LOOP,
            where=where,
        )
    return _garbage(run)


def _cut(run: ChildRun) -> Outcome:
    if run.cut == 'garbage':
        return _garbage(run)
    if run.cut == 'printed':
        return Outcome(
            run.scenario,
            'stopped',
            text=f'it printed more than {run.limits.output_mib} MiB and was stopped',
            try_='take the print out of the loop',
        )
    if run.cut == 'recording':
        return Outcome(
            run.scenario,
            'stopped',
            text=f'its recording grew larger than {run.limits.recording_mib} MiB',
            try_='look for a node that publishes or prints without pause',
        )
    return _timeout(run, None)


def _timeout(run: ChildRun, where: Place | None) -> Outcome:
    return Outcome(
        run.scenario,
        'stopped',
        text=f'it did not finish within {run.limits.wall_s:g} s of real time and was stopped',
        try_=f'{_LOOP}; a slow machine can be given more with --limit SECONDS',
        where=where,
    )


def _memory(run: ChildRun) -> Outcome:
    return Outcome(
        run.scenario,
        'stopped',
        text=f'it asked for more memory than {run.limits.memory_mib} MiB',
        try_='look for a list that grows without end',
    )


def _ended(run: ChildRun) -> Outcome:
    code = run.returncode
    if code is None or code >= 0:
        ending = '' if code is None else f' with exit code {code}'
        return Outcome(
            run.scenario,
            'stopped',
            text=f'the program ended itself{ending} before the run was over',
            try_=_OWN_EXIT,
        )
    if -code == signal.SIGXCPU:
        return _timeout(run, None)
    return Outcome(
        run.scenario,
        'stopped',
        text=f'the program was ended by {_signal_name(-code)} before the run was over',
        try_=_OWN_EXIT,
    )


def _garbage(run: ChildRun) -> Outcome:
    return Outcome(
        run.scenario,
        'stopped',
        text='what came back from the run is not a recording of it',
        try_='leave alone the file descriptors that the launch file did not open itself',
    )


def _signal_name(number: int) -> str:
    try:
        return signal.Signals(number).name
    except ValueError:
        return f'signal {number}'


def _report(content: bytes) -> dict[str, Any] | None:
    try:
        found = json.loads(content)
    except (ValueError, RecursionError):
        return None
    return found if isinstance(found, dict) else None


def _text(report: dict[str, Any], key: str) -> str:
    value = report.get(key)
    return value[:8000] if isinstance(value, str) else ''


def _place(report: dict[str, Any]) -> Place | None:
    file, line = report.get('file'), report.get('line')
    return Place(file, line) if isinstance(file, str) and isinstance(line, int) else None

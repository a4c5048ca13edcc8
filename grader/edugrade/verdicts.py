"""Turns the end of a child process into an outcome. Everything that the child sends is data, which are parsed and never
executed.
"""

from __future__ import annotations

import json
import os
import re
import signal
import sys
from collections.abc import Mapping, Sequence
from typing import TYPE_CHECKING, Any

from .child_run import HEADER_BYTES, ChildRun
from .evidence import Outcome, Scenario
from .faults import REPORT_IT, advice_on_limits, fault_in, missing_for, no_mark_for
from .sandbox.allowance import MOST_BYTES, MOST_FILES, VIEW
from .shortened import shortened
from .source import Place, is_engine

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import LaunchRecord

_LOOP = 'find a loop that never ends, or a wait without a timeout'
_NO_SANDBOX = 'grade on a Linux with Landlock 6 and seccomp (edugrade doctor checks this), or with --sandbox auto'
_CALL = 'find a huge power, a huge range, or a regular expression that tries too many combinations'
_OWN_EXIT = 'remove calls of sys.exit(), os._exit() and os.kill(): launch itself ends its processes'
_LONGEST_TEXT = 8000
_FRAME = re.compile(r'File "([^"\n]+)", line (\d{1,9})\b')


def unconfined(sandbox: Mapping[str, str] | None) -> dict[str, str]:
    """Return the layers of the sandbox that failed, with the reasons. The layer VIEW is optional and is left out."""
    return {layer: reason for layer, reason in (sandbox or {}).items() if reason != 'held' and layer != VIEW}


def verdict(run: ChildRun) -> Outcome:
    """Return the outcome of a child that has ended."""
    found = _verdict(run)
    text = found.text
    if run.refused and found.kind in ('stopped', 'unusable'):
        text = f'{text}\n{refusal_of(run.refused)}'
    return found._replace(sandbox=run.sandbox, refused=tuple(run.refused), text=text)


def refusal_of(calls: Sequence[str]) -> str:
    """Return a sentence about forbidden system calls that a run tried to make."""
    return f'The sandbox does not allow the system call {" or ".join(calls)}. It failed with "Operation not permitted".'


def _verdict(run: ChildRun) -> Outcome:
    if run.sandbox is None:
        return _not_begun(run)
    missing = unconfined(run.sandbox)
    if run.limits.sandbox == 'require' and missing:
        words = '; '.join(f'{layer} ({reason})' for layer, reason in missing.items())
        return Outcome(run.scenario, 'broke', text=f'this system has no complete sandbox: {words}', try_=_NO_SANDBOX)
    if run.cut is not None:
        return _cut(run)
    if run.complete:
        return _answered(run, chr(run.frame[0]), bytes(run.frame[HEADER_BYTES : HEADER_BYTES + run.announced]))
    return _ended(run)


def _not_begun(run: ChildRun) -> Outcome:
    """Return the outcome of a run that ended before the submission was read. So the student did not cause the end."""
    report = (
        _report(bytes(run.frame[HEADER_BYTES : HEADER_BYTES + run.announced])) if run.complete and run.frame[:1] == b'B' else None
    )
    words = _text(report or {}, 'text')
    text = f'the run could not start: {words}' if report else 'another program killed a process of the grader'
    outcome = Outcome(run.scenario, 'broke', text=text, try_='grade it again', detail=_text(report or {}, 'trace'))
    fault = fault_in(words)
    return outcome if fault is None else no_mark_for(outcome, fault)


def _answered(run: ChildRun, letter: str, content: bytes) -> Outcome:
    if letter == 'R':
        return recorded(run.scenario, content) or _garbage(run)
    report = _report(content)
    if report is None:
        return _garbage(run)
    text, where = _text(report, 'text'), _place(report)
    if letter == 'U':
        return Outcome(run.scenario, 'unusable', text=text, try_=_text(report, 'help') or None, where=where)
    if letter == 'B':
        return Outcome(
            run.scenario, 'broke', text=f'the simulation failed: {text}', try_=REPORT_IT, detail=_text(report, 'trace')
        )
    return _stopped_itself(run, report, where)


def _stopped_itself(run: ChildRun, report: dict[str, Any], where: Place | None) -> Outcome:
    reason = report.get('reason')
    if reason == 'timeout':
        return _timeout(run, where)
    if reason == 'memory':
        return _memory(run)
    if reason == 'recording':
        return _too_large(run)
    if reason == 'processes':
        return _too_many(run)
    if reason == 'broken':
        return _broken(run, report.get('said'))
    return _garbage(run)._replace(detail=_text(report, 'detail'))


def _broken(run: ChildRun, report: Any) -> Outcome:
    """Return the outcome for a failure of edulaunch in the process of the submission. The submission may have caused it."""
    words = report if isinstance(report, dict) else {}
    if advice_on_limits(_text(words, 'text')):
        return _too_much_written(run)._replace(detail=_text(words, 'trace'))  # faults.py reads the number in it
    text = f'edulaunch failed in the process that runs this file: {_text(words, "text") or "the reason is unknown"}'
    advice = "remove code that changes edulaunch's own objects; without such code, show this report to your teacher"
    return _stopped(run, text, advice)._replace(detail=_text(words, 'trace'))


def _memory(run: ChildRun) -> Outcome:
    return _stopped(run, f'the run needed more than {run.limits.memory_mib} MiB of memory', 'find a list that grows without end')


def _too_large(run: ChildRun) -> Outcome:
    return _stopped(
        run,
        f'the recording of the run is larger than {run.limits.recording_mib} MiB',
        'find a node that publishes or prints without pause',
    )


def _too_many(run: ChildRun) -> Outcome:
    advice = 'find a program that starts itself, a loop around Popen, or a Node with respawn that dies at once'
    return _stopped(run, 'the run started too many programs', advice)


def _too_much_written(run: ChildRun) -> Outcome:
    text = f'the run wrote more than {MOST_BYTES >> 20} MiB or {MOST_FILES} files'
    return _stopped(run, text, 'find a loop that writes without pause')


def _cut(run: ChildRun) -> Outcome:
    if run.cut == 'garbage':
        return _garbage(run)
    if run.cut == 'printed':
        return _stopped(run, f'the run printed more than {run.limits.output_mib} MiB', 'remove the print from the loop')
    if run.cut == 'recording':
        return _too_large(run)
    if run.cut == 'processes':
        return _too_many(run)
    if run.cut == 'memory':
        return _memory(run)
    if run.cut == 'disk':
        return _too_much_written(run)
    return _timeout(run, None)


def _ended(run: ChildRun) -> Outcome:
    code = run.returncode
    confined = bool(run.sandbox) and not unconfined(run.sandbox)
    if code is None and confined:  # a confined process cannot kill its guard, so no mark is fairer than zero points
        return Outcome(run.scenario, 'broke', text='another program killed a process of the grader', try_='grade it again')
    if code is not None and -code == signal.SIGXCPU:
        return _stopped(
            run,
            'a single call used the processor for seconds and did not return',
            _CALL,
            _faulted_at(run.printed.decode('utf-8', 'replace')),
        )
    if code is None or code >= 0:
        how = 'the program ended itself' + ('' if code is None else f' with exit code {code}')
    else:
        how = f'{_signal_name(-code)} ended the program'
    printed = run.printed.decode('utf-8', 'replace')
    return _stopped(run, f'{how} before the end of the run', _OWN_EXIT)._replace(detail=printed)


def _timeout(run: ChildRun, where: Place | None) -> Outcome:
    return _stopped(
        run,
        f'the run did not finish within {run.limits.wall_s:g} s of real time',
        f'{_LOOP}; on a slow machine, grade with --limit SECONDS',
        where,
    )


def _garbage(run: ChildRun) -> Outcome:
    return _stopped(
        run,
        'the run did not return a valid recording',
        'remove code that uses file descriptors that the launch file did not open itself',
    )


def _stopped(run: ChildRun, text: str, try_: str, where: Place | None = None) -> Outcome:
    return Outcome(run.scenario, 'stopped', text=text, try_=try_, where=where)


def _faulted_at(printed: str) -> Place | None:
    """Return the innermost place that `faulthandler` printed and that is neither in the engine nor in Python, or None."""
    for file, line in _FRAME.findall(printed):
        if os.path.isabs(file) and not is_engine(file) and not file.startswith(sys.prefix):
            return Place(file, int(line))
    return None


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
    return shortened(value, _LONGEST_TEXT) if isinstance(value, str) else ''


def _place(report: dict[str, Any]) -> Place | None:
    file, line = report.get('file'), report.get('line')
    return Place(file, line) if isinstance(file, str) and isinstance(line, int) else None


_LOOK = 'check this line and the line before it'
_ENDLESS = 'find a loop that does not end: a launch file only describes what to start'
_STARTS_NOTHING = 'return a LaunchDescription with a Node in it, and remove calls of os._exit() and sys.exit()'


def recorded(scenario: Scenario, content: bytes) -> Outcome | None:
    """Return the outcome of a serialized recording, or None if the bytes are not a recording of this scenario.

    :param content: a line of JSON with the provenance of the rows and the contents of each bag, then the recording.
    """
    from edulaunch.engine.recording import Recording as Known
    from edulaunch.ros.collector_pause import collector_paused
    from edulaunch.runtime.link.provenance import attach

    try:
        line, _, rest = content.partition(b'\n')
        owners, programs, *bags = json.loads(line)
        with collector_paused():
            recording = Known.from_bytes(rest, is_ours=True)  # the trusted peer wrote them
        attach(recording, [owners, programs])
        if recording.seed != scenario.seed or recording.launch.arguments != dict(scenario.arguments):
            return None
    except OSError as error:
        return Outcome(scenario, 'broke', text=f'the recording could not be read: {error}', try_=REPORT_IT)
    except Exception:  # hostile bytes can make the reader raise any exception, and all of them mean the same
        return None
    return come_to(scenario, recording)._replace(bags=bags)


def come_to(scenario: Scenario, recording: Recording) -> Outcome:
    """Return the outcome of a recorded run, which depends on whether launch ended normally."""
    launch, programs = recording.launch, recording.processes
    if missing := missing_for(recording):
        return no_mark_for(Outcome(scenario, 'recorded'), missing[0])._replace(try_=missing[1])
    if launch.error is not None:
        return _launch_error(scenario, launch)
    stuck = programs[0].exception if programs else None
    if stuck is not None and stuck['type'] == 'RunawayProgramError':
        place = Place(stuck['file'], stuck['line']) if stuck.get('file') else None
        return Outcome(scenario, 'stopped', text='the launch file did not finish and was stopped', try_=_ENDLESS, where=place)
    is_in_vain = bool(scenario.fails) and launch.returncode == 0  # everything waits for a program that cannot start
    if launch.returncode is not None and len(programs) <= 1 and not is_in_vain:
        text = f'launch ended with exit code {launch.returncode} before it started a program'
        return Outcome(scenario, 'stopped', text=text, try_=_STARTS_NOTHING)
    return Outcome(scenario, 'recorded', recording=recording)


def _launch_error(scenario: Scenario, launch: LaunchRecord) -> Outcome:
    """Return the outcome for an error of launch, with the message of launch and the problem below it.

    The last line of the message is left out, because it repeats the place.
    """
    text = (launch.error or '').removesuffix(f'\n  at {launch.error_file}:{launch.error_line}')
    where = None
    if launch.error_file is not None and not is_engine(launch.error_file):
        where = Place(launch.error_file, launch.error_line)
    what, do = launch.advice or ('', '')
    if what and what.removeprefix('the ') not in text:
        text += f'\n{what}'
    return Outcome(scenario, 'unusable', text=text, try_=advice_on_limits(text) or do or _LOOK, where=where)

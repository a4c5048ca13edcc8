"""Says in words what a child process came to. What it sends, a recording too, is data: measured and parsed, never run."""

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
from .faults import REPORT_IT, missing_for, no_mark_for
from .sandbox.allowance import MOST_BYTES, MOST_FILES, VIEW
from .source import Place, is_engine

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import LaunchRecord

_LOOP = 'look for a loop that never ends, or for a wait without a time limit'
_NO_SANDBOX = 'grade on a Linux with Landlock 6 and seccomp (edugrade doctor tells), or with --sandbox auto'
_CALL = 'look for a huge power, a huge range or a pattern that tries very many ways'
_OWN_EXIT = 'take out calls of sys.exit(), os._exit() and os.kill(): launch itself ends its processes'
_LONGEST_TEXT = 8000
_FRAME = re.compile(r'File "([^"\n]+)", line (\d{1,9})\b')


def unconfined(sandbox: Mapping[str, str] | None) -> dict[str, str]:
    """The layers of confinement that do not hold, and why; without VIEW, which is one more."""
    return {layer: reason for layer, reason in (sandbox or {}).items() if reason != 'held' and layer != VIEW}


def verdict(run: ChildRun) -> Outcome:
    """What an ended child came to."""
    found = _verdict(run)
    text = found.text
    if run.refused and found.kind in ('stopped', 'unusable'):
        text = f'{text}\n{refusal_of(run.refused)}'
    return found._replace(sandbox=run.sandbox or {}, refused=tuple(run.refused), text=text)


def refusal_of(calls: Sequence[str]) -> str:
    """A sentence on system calls that a run tried and may not make."""
    return f'A graded run may not make the system call {" or ".join(calls)}: the call failed with "Operation not permitted".'


def _verdict(run: ChildRun) -> Outcome:
    if run.sandbox is None:
        return _not_begun(run)
    missing = unconfined(run.sandbox)
    if run.limits.sandbox == 'require' and missing:
        words = '; '.join(f'{layer} ({reason})' for layer, reason in missing.items())
        return Outcome(run.scenario, 'broke', text=f'this system does not confine a run: {words}', try_=_NO_SANDBOX)
    if run.cut is not None:
        return _cut(run)
    if run.complete:
        return _answered(run, chr(run.frame[0]), bytes(run.frame[HEADER_BYTES : HEADER_BYTES + run.announced]))
    return _ended(run)


def _not_begun(run: ChildRun) -> Outcome:
    """Nothing of the submission had been read: whatever it was, the student did not do it."""
    report = (
        _report(bytes(run.frame[HEADER_BYTES : HEADER_BYTES + run.announced])) if run.complete and run.frame[:1] == b'B' else None
    )
    text = f'the run could not begin: {_text(report, "text")}' if report else 'a process of the grader was killed from outside'
    return Outcome(run.scenario, 'broke', text=text, try_='grade it again', detail=_text(report or {}, 'trace'))


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
            run.scenario, 'broke', text=f'the simulation itself broke: {text}', try_=REPORT_IT, detail=_text(report, 'trace')
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
    if reason == 'broken':
        return _broken(run, report.get('said'))
    return _garbage(run)._replace(detail=_text(report, 'detail'))


def _broken(run: ChildRun, report: Any) -> Outcome:
    """edulaunch broke in the process of the submission. It may have been made to: no mark for that."""
    words = report if isinstance(report, dict) else {}
    text = f'edulaunch broke in the process that runs this file: {_text(words, "text") or "it does not say how"}'
    advice = "leave edulaunch's own objects alone; if the file does, this is not your mistake: show this report to your teacher"
    return _stopped(run, text, advice)._replace(detail=_text(words, 'trace'))


def _memory(run: ChildRun) -> Outcome:
    return _stopped(run, f'it asked for more memory than {run.limits.memory_mib} MiB', 'look for a list that grows without end')


def _too_large(run: ChildRun) -> Outcome:
    return _stopped(
        run,
        f'its recording grew larger than {run.limits.recording_mib} MiB',
        'look for a node that publishes or prints without pause',
    )


def _cut(run: ChildRun) -> Outcome:
    if run.cut == 'garbage':
        return _garbage(run)
    if run.cut == 'printed':
        return _stopped(run, f'it printed more than {run.limits.output_mib} MiB', 'take the print out of the loop')
    if run.cut == 'recording':
        return _too_large(run)
    if run.cut == 'processes':
        return _stopped(run, 'it started too many programs', 'look for a program that starts itself, or for a loop around Popen')
    if run.cut == 'memory':
        return _memory(run)
    if run.cut == 'disk':
        return _stopped(
            run, f'it wrote more than {MOST_BYTES >> 20} MiB or {MOST_FILES} files', 'look for a loop that writes without pause'
        )
    return _timeout(run, None)


def _ended(run: ChildRun) -> Outcome:
    code = run.returncode
    confined = bool(run.sandbox) and not unconfined(run.sandbox)
    if code is None and confined:  # what is confined cannot kill its guard: no mark is better than a zero
        return Outcome(run.scenario, 'broke', text='a process of the grader was killed from outside', try_='grade it again')
    if code is not None and -code == signal.SIGXCPU:
        return _stopped(
            run,
            'a single call used the processor for seconds and did not come back',
            _CALL,
            _faulted_at(run.printed.decode('utf-8', 'replace')),
        )
    if code is None or code >= 0:
        how = 'the program ended itself' + ('' if code is None else f' with exit code {code}')
    else:
        how = f'the program was ended by {_signal_name(-code)}'
    printed = run.printed.decode('utf-8', 'replace')
    return _stopped(run, f'{how} before the run was over', _OWN_EXIT)._replace(detail=printed)


def _timeout(run: ChildRun, where: Place | None) -> Outcome:
    return _stopped(
        run,
        f'it did not finish within {run.limits.wall_s:g} s of real time',
        f'{_LOOP}; a slow machine can be given more time with --limit SECONDS',
        where,
    )


def _garbage(run: ChildRun) -> Outcome:
    return _stopped(
        run,
        'what came back from the run is not a recording of it',
        'leave alone the file descriptors that the launch file did not open itself',
    )


def _stopped(run: ChildRun, text: str, try_: str, where: Place | None = None) -> Outcome:
    return Outcome(run.scenario, 'stopped', text=text, try_=try_, where=where)


def _faulted_at(printed: str) -> Place | None:
    """The innermost place that `faulthandler` printed, in a file that is not the engine's."""
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
    return value[:_LONGEST_TEXT] if isinstance(value, str) else ''


def _place(report: dict[str, Any]) -> Place | None:
    file, line = report.get('file'), report.get('line')
    return Place(file, line) if isinstance(file, str) and isinstance(line, int) else None


_LOOK = 'check this line and the line before it'
_ENDLESS = 'look for a loop that does not end: a launch file only says what to start'
_STARTS_NOTHING = 'return a LaunchDescription with a Node in it; take out calls of os._exit() and sys.exit()'


def recorded(scenario: Scenario, content: bytes) -> Outcome | None:
    """The outcome that these bytes stand for; None when they are no recording of this scenario.

    :param content: a line of JSON, the provenance of the rows and what each bag holds; then the recording.
    """
    from edulaunch.engine.recording import Recording as Known
    from edulaunch.runtime.link.provenance import attach

    try:
        line, _, rest = content.partition(b'\n')
        owners, programs, *bags = json.loads(line)
        recording = Known.from_bytes(rest)
        attach(recording, [owners, programs])
        if recording.seed != scenario.seed or recording.launch.arguments != dict(scenario.arguments):
            return None
    except OSError as error:
        return Outcome(scenario, 'broke', text=f'the recording could not be read: {error}', try_=REPORT_IT)
    except Exception:  # hostile bytes may upset the reader in any way; each of them means the same
        return None
    return come_to(scenario, recording)._replace(bags=bags)


def come_to(scenario: Scenario, recording: Recording) -> Outcome:
    """The outcome of a run that was recorded: whether launch came to its end."""
    launch, programs = recording.launch, recording.processes
    if missing := missing_for(recording):
        return no_mark_for(Outcome(scenario, 'recorded'), missing[0])._replace(try_=missing[1])
    if launch.error is not None:
        return _launch_error(scenario, launch)
    stuck = programs[0].exception if programs else None
    if stuck is not None and stuck['type'] == 'RunawayProgramError':
        place = Place(stuck['file'], stuck['line']) if stuck.get('file') else None
        return Outcome(
            scenario, 'stopped', text='the launch file never came to its end and was stopped', try_=_ENDLESS, where=place
        )
    if launch.returncode is not None and len(programs) <= 1:
        text = f'launch ended with exit code {launch.returncode} and had started nothing'
        return Outcome(scenario, 'stopped', text=text, try_=_STARTS_NOTHING)
    return Outcome(scenario, 'recorded', recording=recording)


def _launch_error(scenario: Scenario, launch: LaunchRecord) -> Outcome:
    """Launch's own text, without its last line, which is the place again."""
    text = (launch.error or '').removesuffix(f'\n  at {launch.error_file}:{launch.error_line}')
    where = None
    if launch.error_file is not None and not is_engine(launch.error_file):
        where = Place(launch.error_file, launch.error_line)
    return Outcome(scenario, 'unusable', text=text, try_=launch.help or _LOOK, where=where)

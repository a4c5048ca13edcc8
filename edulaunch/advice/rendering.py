"""Convert findings to sentences. No other module does this.

The sentences appear below an error, at the end of a run, in the doctor, and as marks in the live view.
"""

from __future__ import annotations

import os
from collections.abc import Container, Iterable, Iterator, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.advice.judging import DIED, judge, judge_failure
from edulaunch.advice.reader import Reader, fields_of, reader_here, reader_of
from edulaunch.advice.rule import Failure, Finding, rule_named
from edulaunch.engine.recording import views

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import LaunchRecord

MOST_NAMES = 12
MOST_SHOWN = 5
"""The maximum number of findings that are shown at the end of a run."""


class Rendered(NamedTuple):
    """The sentences of a finding. `why` is empty if the rule gives no reason, and `where` is empty if the place is unknown."""

    what: str
    where: str
    why: str
    do: str
    lesson: str | None
    sign: str = 'warning'

    def __str__(self) -> str:
        """Return the mistake, its place and what to do, in the format of error messages."""
        return f'{self.what}{self.where and f" ({self.where})"}\n  help: {self.do}'


def rendered(finding: Finding, reader: Reader | None = None) -> Rendered:
    """Return a finding as sentences: the mistake, its place, the reason, and what to do."""
    rule = rule_named(finding.rule)
    reader = reader_here() if reader is None else reader
    facts = {**finding.facts, finding.kind: finding.name}
    what, why, do = (_worded(templates, facts, reader) for templates in (rule.what, rule.why, rule.do))
    who = (finding.process,) if finding.process and finding.process not in what else ()
    where = ', '.join((*who, *place(finding, reader)))
    return Rendered(what, where, why, do, rule.lesson, _sign(rule.level, reader))


def warning_lines(
    findings: Sequence[Finding], reader: Reader | None = None, shown_by: str = '', most: int = MOST_SHOWN
) -> list[str]:
    """Return the lines that a run prints at its end: the most serious findings with what to do, and the number of the other
    findings.

    :param findings: the findings, with the most serious one first.
    :param reader: determines the language and the form of paths (default: the user of this program).
    :param shown_by: the command or expression that shows all findings.
    :param most: the largest number of findings to print.
    """
    reader = reader_here() if reader is None else reader
    lines = [f'{words.sign}: {words}' for words in (rendered(finding, reader) for finding in findings[:most])]
    if len(findings) > most:
        count = len(findings) - most
        more = reader.says('and {count} more; show all of them with {command}') if shown_by else reader.says('and {count} more')
        lines.append(more.format(count=count, command=shown_by))
    return lines


def end_of_run_lines(
    recording: Recording,
    reader: Reader | None = None,
    helped: Container[str] = (),
    typed: str = '',
    shown_by: str = 'for warning in recording.warnings: print(warning)',
) -> list[str]:
    """Return the lines to print at the end of a run.

    :param recording: the recording of a run, or of one command of a machine (`Session.of_command`).
    :param reader: determines the language and the form of paths (default: the user of this program).
    :param helped: the programs whose error messages already contained an explanation.
    :param typed: the program that the user has started. The user has just seen its failure and its last output.
    :param shown_by: the command or expression that shows all findings, printed if there are too many to list.
    """
    findings = [one for one in recording.advice if one.process not in helped and (one.rule, one.name) != (DIED, typed)]
    return warning_lines(findings, reader, shown_by) if findings else []


def place(finding: Finding, reader: Reader) -> Iterator[str]:
    """Yield the place of a finding: the file and line, and the simulated time, such as 'follow.launch.py:12' and 'at 0.50 s'."""
    if finding.file is not None:
        yield reader.place(finding.file, finding.line)
    if finding.time_s is not None:
        yield reader.says('at {time:.2f} s').format(time=finding.time_s)


def _sign(level: str, reader: Reader) -> str:
    """Return the first word of a line, 'note' or 'warning'.

    The word 'error' stands for errors of the command that reports them.
    """
    return reader.says('note') if level == 'info' else reader.says('warning')


def _worded(templates: Iterable[str], facts: dict[str, Any], reader: Reader) -> str:
    """Return the first template whose facts are all known, with the facts filled in, or an empty string."""
    for template in templates:
        if all(facts.get(name) not in (None, [], ()) for name in fields_of(template)):
            return reader.says(template).format_map({name: _listed(value, reader) for name, value in facts.items()})
    return ''


def _listed(value: Any, reader: Reader) -> Any:
    """Return the printed form of a fact. A long list of names is shortened, and a path is shown as the reader sees it."""
    if isinstance(value, str):
        return reader.short(value)
    if not isinstance(value, (list, tuple)):
        return value
    return ', '.join([*map(str, value[:MOST_NAMES]), *(['...'] if len(value) > MOST_NAMES else [])])


def help_below(error: dict[str, Any], env: Mapping[str, str]) -> str | None:
    """Return one line of help for an error, or None if no rule explains it.

    :param error: a dictionary with `type`, `message`, `facts` and `place`. If the error ended a program, `process` is its name.
        Otherwise, the error is in a launch file, and the help includes its place.
    :param env: the environment variables of the reader's terminal.
    """
    file, line = error.get('place') or (None, None)
    failure = Failure(error['type'], error['message'], file, line, None, error.get('process'), error['facts'])
    words = help_text(failure, reader_of(env, ''))
    if failure.process is not None or file is None:
        return words
    action = failure.facts.get('action')
    where = f'{file}:{line}{f" ({action})" if action else ""}'
    return where if words is None else f'{where}: {words}'


def help_of(error: dict[str, Any]) -> str | None:
    """Return one line of help for an error: the mistake and what to do, in the language of the program's user. Return None if
    no rule explains the error.

    :param error: a dictionary with `type`, `message`, `facts` and `place`.
    """
    file, line = error.get('place') or (None, None)
    return help_text(Failure(error['type'], error['message'], file, line, facts=error['facts']))


def advice_of(launch: LaunchRecord) -> tuple[str, str] | None:
    """Return the mistake in a failed launch, and what to do. Return None if no rule explains the error."""
    cause = launch.error_type or '', launch.error_cause or ''
    return _advice(Failure(*cause, launch.error_file, launch.error_line, facts=launch.error_facts))


def help_of_facts(facts: dict[str, Any]) -> str:
    """Return one line of help that is determined by facts alone, or an empty string if no rule explains the facts."""
    return help_text(Failure('', '', facts=facts)) or ''


def help_text(failure: Failure, reader: Reader | None = None) -> str | None:
    """Return one line of help with the mistake and what to do. Return None if no rule explains the error."""
    words = _advice(failure, reader)
    return None if words is None else '; '.join(filter(None, words))


def _advice(failure: Failure, reader: Reader | None = None) -> tuple[str, str] | None:
    found = judge_failure(failure)
    if not found:
        return None
    words = rendered(found[0], reader)
    return words.what, words.do


FORMAT = 1


def is_note(finding: Finding) -> bool:
    """Return whether a finding is only a note, not a mistake. An example is a package that edulaunch does not have."""
    return rule_named(finding.rule).level == 'info'


def diagnosis(findings: Sequence[Finding], reader: Reader) -> Iterator[str]:
    """Yield the lines of a diagnosis for users, with the most serious finding first."""
    if not findings:
        yield reader.says('no problems found')
    for number, finding in enumerate(findings, 1):
        words = rendered(finding, reader)
        margin = ' ' * len(f'{number}. ')
        yield f'{number}. {f"{words.sign}: " if is_note(finding) else ""}{words.what}'
        lesson = f'lessons/{words.lesson}.ipynb' if words.lesson else ''
        parts = ((reader.says('where'), words.where), (reader.says('why'), words.why), (reader.says('do'), words.do))
        width = max(len(label) for label, _ in parts) + 2
        for label, text in (*parts, (reader.says('see'), lesson)):
            if text:
                yield margin + f'{label}:'.ljust(width) + text


def diagnosis_data(findings: Sequence[Finding], reader: Reader) -> dict[str, Any]:
    """Return the diagnosis as plain data, including the facts of each finding."""
    return {'format': FORMAT, 'findings': [_data(finding, reader) for finding in findings]}


def _data(finding: Finding, reader: Reader) -> dict[str, Any]:
    words, rule = rendered(finding, reader), rule_named(finding.rule)
    place = {'file': finding.file, 'line': finding.line, 'time_s': finding.time_s, 'process': finding.process}
    sentences = {'what': words.what, 'why': words.why or None, 'do': words.do, 'lesson': words.lesson}
    about = {'kind': finding.kind, 'name': finding.name, 'facts': finding.facts}
    return {'rule': rule.name, 'level': rule.level, 'confidence': rule.confidence, **about, **place, **sentences}


DRAWN = ('node', 'topic', 'frame')


class Mark(NamedTuple):
    """A sentence that the live view shows at a node, topic or frame.

    :ivar time_s: the time from which the sentence is true, in seconds since the start.
    :ivar subject: ('node', 'topic' or 'frame'; full name), or ('', '') for the whole run.
    :ivar rule: the name of the rule.
    """

    time_s: float
    subject: tuple[str, str]
    text: str
    rule: str


def marks(recording: Recording) -> list[Mark]:
    """Return a mark for each finding, with the most serious finding first.

    The marks contain file names without folders, because pages are stored and shared.
    """
    nodes = {node.process: node.name for node in reversed(recording.nodes)}
    return [_mark(finding, nodes) for finding in recording.advice]


def _mark(finding: Finding, nodes: dict[str, str]) -> Mark:
    """Return the mark of a finding. For a finding about a program, the mark is at the program's first node."""
    subject = (finding.kind, finding.name)
    if finding.kind not in DRAWN:
        node = nodes.get(finding.process or finding.name)
        subject = ('node', node) if node else ('', '')
    file = None if finding.file is None else os.path.basename(finding.file)
    words = rendered(finding._replace(file=file), reader_here())
    return Mark(finding.time_s or 0.0, subject, str(words), finding.rule)


views.register(
    judge=judge,
    sentences=rendered,
    closing_lines=end_of_run_lines,
    help_below=help_below,
    advice_of=advice_of,
    help_of=help_of,
    help_of_facts=help_of_facts,
)

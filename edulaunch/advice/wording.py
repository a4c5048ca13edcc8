"""A finding in words: the only place of the house where facts become sentences of advice."""

from __future__ import annotations

from collections.abc import Container, Iterable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.advice.finding import Finding
from edulaunch.advice.reader import Reader, reader_here
from edulaunch.advice.registry import rule_named
from edulaunch.advice.retelling import fields_of

if TYPE_CHECKING:
    from edulaunch.recording import Recording

MOST_NAMES = 12
MOST_TOLD = 5
"""Findings that are told where nobody asked for them."""


class Told(NamedTuple):
    """The sentences of a finding; `why` is '' where the rule gives no reason, `where` where no place is known."""

    what: str
    where: str
    why: str
    do: str
    lesson: str | None
    sign: str = 'warning'

    def __str__(self) -> str:
        """What is wrong, where, and what to do, as errors tell it."""
        return f'{self.what}{self.where and f" ({self.where})"}\n  help: {self.do}'


def told(finding: Finding, reader: Reader | None = None) -> Told:
    """What is wrong, where, why that matters, and what to do."""
    rule = rule_named(finding.rule)
    reader = reader_here() if reader is None else reader
    facts = {**finding.facts, finding.kind: finding.name}
    what, why, do = (_worded(templates, facts, reader) for templates in (rule.what, rule.why, rule.do))
    who = (finding.process,) if finding.process and finding.process not in what else ()
    where = ', '.join((*who, *place(finding, reader)))
    return Told(what, where, why, do, rule.lesson, _sign(rule.level, reader))


def warning_lines(findings: Sequence[Finding], reader: Reader | None = None, most: int = MOST_TOLD) -> list[str]:
    """What is said at the end of a run, each with what to do; the worst, and how many more there are."""
    reader = reader_here() if reader is None else reader
    lines = [f'{words.sign}: {words}' for words in (told(finding, reader) for finding in findings[:most])]
    if len(findings) > most:
        lines.append(reader.says('and {count} more').format(count=len(findings) - most))
    return lines


def said_at_the_end(
    recording: Recording, reader: Reader | None = None, since_s: float = 0.0, helped: Container[str] = ()
) -> list[str]:
    """What is said where a run has ended; of a machine that went on from before, what came since.

    :param helped: programs below whose error it was said already.
    """
    findings = [one for one in recording.advice if (one.time_s is None or one.time_s >= since_s) and one.process not in helped]
    return warning_lines(findings, reader) if findings else []


def place(finding: Finding, reader: Reader) -> Iterator[str]:
    """File and line, and the simulated time: 'follow.launch.py:12', 'at 0.50 s'."""
    if finding.file is not None:
        yield reader.place(finding.file, finding.line)
    if finding.time_s is not None:
        yield reader.says('at {time:.2f} s').format(time=finding.time_s)


def _sign(level: str, reader: Reader) -> str:
    """How a line begins: an error is one of the reader's program, not of the command that tells it."""
    return reader.says('note') if level == 'info' else reader.says('warning')


def _worded(templates: Iterable[str], facts: dict[str, Any], reader: Reader) -> str:
    """The first of the templates whose facts are all known, with the facts in it; '' when there is none."""
    for template in templates:
        if all(facts.get(name) not in (None, [], ()) for name in fields_of(template)):
            return reader.says(template).format_map({name: _listed(value) for name, value in facts.items()})
    return ''


def _listed(value: Any) -> Any:
    """A list of names as words; of a long one the beginning."""
    if not isinstance(value, (list, tuple)):
        return value
    return ', '.join([*map(str, value[:MOST_NAMES]), *(['...'] if len(value) > MOST_NAMES else [])])

"""What the doctor says: every finding in full, as text or as plain data."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from edulaunch.advice.finding import Finding
from edulaunch.advice.reader import Reader
from edulaunch.advice.registry import rule_named
from edulaunch.advice.wording import told

FORMAT = 1


def diagnosis(findings: Sequence[Finding], reader: Reader) -> Iterator[str]:
    """The lines for people, the worst first."""
    if not findings:
        yield reader.says('nothing wrong was found')
    for number, finding in enumerate(findings, 1):
        words = told(finding, reader)
        margin = ' ' * len(f'{number}. ')
        yield f'{number}. {words.what}'
        lesson = f'lessons/{words.lesson}.ipynb' if words.lesson else ''
        parts = ((reader.says('where'), words.where), (reader.says('why'), words.why), (reader.says('do'), words.do))
        width = max(len(label) for label, _ in parts) + 2
        for label, text in (*parts, (reader.says('see'), lesson)):
            if text:
                yield margin + f'{label}:'.ljust(width) + text


def diagnosis_data(findings: Sequence[Finding], reader: Reader) -> dict[str, Any]:
    """The same as plain data, with the facts."""
    return {'format': FORMAT, 'findings': [_data(finding, reader) for finding in findings]}


def _data(finding: Finding, reader: Reader) -> dict[str, Any]:
    words, rule = told(finding, reader), rule_named(finding.rule)
    place = {'file': finding.file, 'line': finding.line, 'time_s': finding.time_s, 'process': finding.process}
    said = {'what': words.what, 'why': words.why or None, 'do': words.do, 'lesson': words.lesson}
    about = {'kind': finding.kind, 'name': finding.name, 'facts': finding.facts}
    return {'rule': rule.name, 'level': rule.level, 'confidence': rule.confidence, **about, **place, **said}

"""Reports in the reader's language. They are made in English; what people see is retold (`edulaunch.advice.retelling`)."""

from __future__ import annotations

from dataclasses import replace
from typing import TYPE_CHECKING

from .results import CheckResult
from .short_paths import ShortPaths
from .steps import ALL

if TYPE_CHECKING:
    from edulaunch.advice import Reader

WORDS = (
    'ok',
    'FAILED',
    'not run',
    'BROKE',
    'expected',
    'seen',
    'where',
    'try',
    'cause',
    'no mark',
    '{earned} of {points}',
    '{first} m and {second} m',
    'failed',
    'broke',
)
"""Marks and labels: single words, which no search for sentences finds."""


def retold(result: CheckResult, reader: Reader) -> CheckResult:
    """A result with its sentences in the reader's language."""
    return replace(
        result,
        sentence=reader.retells(result.sentence),
        reason=reader.retells(result.reason),
        expected=_maybe(result.expected, reader),
        seen=_maybe(result.seen, reader),
        try_=_maybe(result.try_, reader),
    )


def _maybe(text: str | None, reader: Reader) -> str | None:
    return None if text is None else reader.retells(text)


def points_of(result: CheckResult, reader: Reader) -> str:
    """What a check earned, in brackets; '' where there is nothing to earn."""
    return f'  [{reader.retells(f"{result.earned} of {result.points}")}]' if result.points else ''


def explained(result: CheckResult, paths: ShortPaths, reader: Reader, level: int = ALL) -> dict[str, str]:
    """What stands below the reason of a failed check: label -> text, of what there is and is told at this level."""
    place, fields = result.where, {}
    fields['expected'], fields['seen'] = result.expected, result.seen
    fields['where'] = None if place is None else place.file + (f':{place.line}' if place.line else '')
    fields['try'] = result.try_
    if result.cause is not None:
        from edulaunch.advice import told

        words = told(result.cause, reader._replace(folder=''))
        where = f' ({words.where})' if words.where else ''
        fields['cause'] = paths.text(f'{words.what}{where}' + (f'\n{words.do}' if level >= ALL else ''))
    return {reader.says(label): text for label, text in fields.items() if text}

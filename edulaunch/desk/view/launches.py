"""Validate the launches in a recording, because a recording from an unknown source may contain any data."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from edulaunch.engine.recording.schema import anything, each, maybe, number, record, row, table, text

STATES = ('waiting', 'visiting', 'taken', 'left out', 'failed')
MOST_DEPTH = 30


def _chain(value: Any, depth: int = 0) -> bool:
    """Return whether a value is a list of valid steps of an origin.

    A step may contain the steps of the launch argument that determines its value.
    """
    below = {'argument': lambda inner: depth < MOST_DEPTH and _chain(inner, depth + 1)}
    step = record({'value': anything, 'origin': text, 'file': maybe(text), 'line': maybe(number), 'counts': anything, **below})
    return each(step)(value)


_value = record({'kind': text, 'name': text, 'value': anything, 'chain': _chain})
_step = record(
    {
        'number': number,
        'parent': number,
        'order': number,
        'time': maybe(number),
        'state': lambda value: value in STATES,
        'kind': text,
        'text': text,
        'details': each(row(text, text, maybe(text), maybe(number))),
    },
    {
        'file': maybe(text),
        'line': maybe(number),
        'event': text,
        'about': number,
        'changes': table(table(anything)),
        'error': text,
        'condition': text,
        'runs': each(row(number, number, maybe(number), maybe(number))),
        'fired': each(number),
        'fired_at': each(number),
        'due': number,
        'process': text,
        'handlers': each(text),
        'values': each(_value),
    },
)
_launch = record({'pid': number, 'at': maybe(number), 'count': number, 'rows': each(_step)})


def launches_of(trace: Any) -> Iterator[dict[str, Any]]:
    """Yield the valid launches. Leave out steps whose parent does not come before them."""
    for launch in trace if isinstance(trace, Sequence) else ():
        if _launch(launch):
            yield {**launch, 'rows': [row for row in launch['rows'] if -1 <= row['parent'] < row['number']]}


def in_microseconds(trace: dict[str, Any]) -> dict[str, Any]:
    """Return a launch with the times of its steps in microseconds, as the page needs them."""
    return {**trace, 'rows': [_row_in_microseconds(row) for row in trace['rows']]}


def _row_in_microseconds(row: dict[str, Any]) -> dict[str, Any]:
    times = {name: row[name] // 1000 for name in ('time', 'due') if row.get(name) is not None}
    if row.get('fired_at'):
        times['fired_at'] = [time // 1000 for time in row['fired_at']]
    if row.get('runs'):
        times['runs'] = [
            [pid, start // 1000, None if end is None else end // 1000, code] for pid, start, end, code in row['runs']
        ]
    return {**row, **times}

"""A launch file that cannot be visited to its end."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule

if TYPE_CHECKING:
    from edulaunch.plan import Rehearsal


@rule(
    'launch.fails',
    what='this launch file cannot be launched: {text}',
    do=('{help}', 'look at this line, and at the one before it'),
    level='error',
)
def fails(rehearsal: Rehearsal) -> Iterator[Finding]:
    """In the words of ROS 2; not told beside a rule that knows more."""
    error = rehearsal.plan['error']
    if error is not None:
        file, _, line = (error.get('origin') or '').rpartition(':')
        yield found(
            'file',
            rehearsal.plan['file'],
            file=file or rehearsal.plan['file'],
            line=int(line) if line.isdigit() else None,
            text=_telling_line(error['text']),
            help=error.get('help'),
        )


def _telling_line(text: str) -> str:
    """ROS 2 puts what went wrong under a heading."""
    lines = [line.strip(' -') for line in text.splitlines() if line.strip()]
    return next((line for line in lines if not line.endswith(':')), text)

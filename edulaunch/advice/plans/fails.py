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
            text=error['text'].partition('\n')[0],
            help=error.get('help'),
        )

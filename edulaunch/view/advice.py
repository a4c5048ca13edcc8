"""Marks on nodes, topics and frames: what the rules of the house say of a run, as the page wants it.

The rules themselves are another room's; this one only knows what a mark looks like.
"""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.attached import PLACES, attached

if TYPE_CHECKING:
    from edulaunch.recording import Recording

SUBJECTS = ('node', 'topic', 'frame')


class Mark(NamedTuple):
    """A sentence about something on the page.

    :ivar time_s: from when on it is true, in seconds since the start.
    :ivar subject: 'node', 'topic' or 'frame', and its full name; ('', '') for the run as a whole.
    :ivar rule: the name of the rule.
    """

    time_s: float
    subject: tuple[str, str]
    text: str
    rule: str


def marks_of(recording: Recording) -> list[Mark] | None:
    """What the function that is attached as `advice_marks` says of a run; None where no rules are there.

    It is given a Recording and gives Marks, in texts without paths of this machine: notebooks store them.
    """
    return list(attached('advice_marks')(recording)) if 'advice_marks' in PLACES else None


def told(marks: Iterable[Mark]) -> list[dict[str, Any]]:
    """Marks as plain data: `[{time (us), subject: {node | topic | frame: name}, text, rule}]`."""
    return [
        {
            'time': round(mark.time_s * 1e6),
            'subject': {mark.subject[0]: mark.subject[1]} if mark.subject[0] in SUBJECTS else {},
            'text': mark.text,
            'rule': mark.rule,
        }
        for mark in marks
    ]

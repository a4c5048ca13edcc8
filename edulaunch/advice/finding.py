"""What a rule found: facts as plain data, without a word. The words are put on where it is told (`wording.py`)."""

from __future__ import annotations

from typing import Any, NamedTuple


class Finding(NamedTuple):
    """One mistake at one place.

    :ivar kind: what it is about: 'node', 'topic', 'service', 'frame', 'process', 'parameter', 'file', 'package', 'turtle'.
    :ivar name: the name of that: '/listener', '/turtle1/cmd_vel', 'carrot1', 'listener-2'.
    :ivar facts: what the sentences of the rule need beside `kind` and `name`: texts, numbers, lists of texts; None: not known.
    :ivar file: the student's file, where one is to be looked at, and its line.
    :ivar time_s: simulated seconds since the start, when it happened at a time.
    :ivar rule: which rule found it: 'tf.unknown-frame'. Set by the judge.
    :ivar process: launch name of the program whose error it explains. Set by the judge.
    """

    kind: str
    name: str
    facts: dict[str, Any]
    file: str | None = None
    line: int | None = None
    time_s: float | None = None
    rule: str = ''
    process: str | None = None


def found(
    kind: str, name: str, *, file: str | None = None, line: int | None = None, time_s: float | None = None, **facts: Any
) -> Finding:
    """A finding of the rule that yields it; see :class:`Finding`."""
    return Finding(kind, name, facts, file, line, time_s)

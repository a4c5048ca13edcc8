"""The one form of a rule."""

from __future__ import annotations

from collections.abc import Callable, Iterable
from typing import Any, NamedTuple

from edulaunch.advice.finding import Finding

GROUPS = ('launch', 'programs', 'messages', 'packages', 'tf', 'time', 'turtlesim', 'grader')
LEVELS = ('error', 'warning', 'info')
"""Worst first: it does not work; it works by luck or not as written; worth knowing."""
CONFIDENCES = ('stated', 'asked')
"""A rule that states is sure. One that asks may be wrong about what was meant: its sentence is a question or says 'if'."""

Sentence = str | tuple[str, ...]
"""A template with the facts in braces, as `str.format` has them; of several the first counts whose facts are all known."""


class Rule(NamedTuple):
    """What is looked at, when it speaks, and the sentences: what is wrong, why that matters, what to do."""

    name: str
    look: Callable[[Any], Iterable[Finding]]
    what: tuple[str, ...]
    why: tuple[str, ...]
    do: tuple[str, ...]
    lesson: str | None
    level: str
    confidence: str
    hides: tuple[str, ...]

    @property
    def group(self) -> str:
        """The part of ROS 2 that it is about."""
        return self.name.partition('.')[0]


def rule(
    name: str,
    *,
    what: Sentence,
    do: Sentence,
    why: Sentence = (),
    lesson: str | None = None,
    level: str = 'warning',
    confidence: str = 'stated',
    hides: tuple[str, ...] = (),
) -> Callable[[Callable[[Any], Iterable[Finding]]], Rule]:
    """Make a rule of a pure function that yields findings of what it is given. Which kind of thing that is, its folder says.

    :param name: 'group.what-is-wrong'; the group is one of :data:`GROUPS`.
    :param lesson: the page of the course that explains it: '09_broadcaster_and_listener'.
    :param hides: rules whose findings only follow from this one: they are not told beside it.
    """
    assert name.partition('.')[0] in GROUPS and level in LEVELS and confidence in CONFIDENCES, name

    def made(look: Callable[[Any], Iterable[Finding]]) -> Rule:
        return Rule(name, look, _several(what), _several(why), _several(do), lesson, level, confidence, hides)

    return made


def _several(sentence: Sentence) -> tuple[str, ...]:
    return (sentence,) if isinstance(sentence, str) else sentence

"""Rules, the findings that they report, and how rules are loaded.

Each folder beside this file has the rules for one kind of thing. They are loaded when they are first used. A finding is plain
data; `rendering.py` turns it into sentences. A failure may come from a file, so no code in it is ever executed.
"""

from __future__ import annotations

import os
from collections.abc import Callable, Iterable
from functools import cache
from importlib import import_module
from typing import Any, NamedTuple

from edulaunch.runtime.plugins import modules_with_rules


class Finding(NamedTuple):
    """One mistake at one place.

    :ivar kind: the kind of thing that has the mistake: 'node', 'topic', 'service', 'frame', 'process', 'parameter', 'file',
        'package', 'turtle'.
    :ivar name: the name of that thing: '/listener', '/turtle1/cmd_vel', 'carrot1', 'listener-2'.
    :ivar facts: the other facts that the sentences of the rule need: strings, numbers or lists of strings, or None if unknown.
    :ivar file: the student's file with the mistake, if there is one, and the line.
    :ivar time_s: the time of the mistake in simulated seconds since the start, if it has one.
    :ivar rule: the rule that found it, such as 'tf.unknown-frame'. The judge sets it.
    :ivar process: the launch name of the program whose error it explains. The judge sets it.
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
    """Return a finding of the rule that calls this function; see :class:`Finding`."""
    return Finding(kind, name, facts, file, line, time_s)


GROUPS = ('launch', 'programs', 'messages', 'packages', 'tf', 'time', 'turtlesim', 'grader')
LEVELS = ('error', 'warning', 'info')
"""The levels, worst first: it does not work, it works only by chance or not as written, or it is worth knowing."""
CONFIDENCES = ('stated', 'asked')
"""A rule that states is certain. A rule that asks may be wrong about the intention, so its sentence is a question or contains
'if'.
"""

Sentence = str | tuple[str, ...]
"""A template with facts in braces, as for `str.format`. Among several, the first one whose facts are all known counts."""


EditForm = tuple[str, str, str]
"""Templates of the wrong and the correct text, and the place of the edit: 'word', or 'import' for a line among the imports."""


class Rule(NamedTuple):
    """A function that finds a mistake, and its sentences: the mistake, the reason, and what to do."""

    name: str
    look: Callable[[Any], Iterable[Finding]]
    what: tuple[str, ...]
    why: tuple[str, ...]
    do: tuple[str, ...]
    lesson: str | None
    level: str
    confidence: str
    hides: tuple[str, ...]
    edits: tuple[EditForm, ...] = ()

    @property
    def group(self) -> str:
        """The part of ROS 2 to which the rule belongs."""
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
    edits: tuple[tuple[str, str] | EditForm, ...] = (),
) -> Callable[[Callable[[Any], Iterable[Finding]]], Rule]:
    """Make a rule from a pure function that yields findings. The folder of the file decides what the function receives.

    :param name: 'group.what-is-wrong'; the group is one of :data:`GROUPS`.
    :param lesson: the lesson that explains it: '09_broadcaster_and_listener'.
    :param hides: rules whose findings are consequences of this one, and are left out if it has a finding.
    :param edits: the edits that certainly correct the mistake, each as (old, new) or (old, new, place), with facts in braces. The
        first edit whose facts are all known counts. If `old` occurs more than once in the line, there is no edit.
    """
    assert name.partition('.')[0] in GROUPS and level in LEVELS and confidence in CONFIDENCES, name

    def made(look: Callable[[Any], Iterable[Finding]]) -> Rule:
        forms = tuple((*edit, 'word')[:3] for edit in edits)
        return Rule(name, look, _several(what), _several(why), _several(do), lesson, level, confidence, hides, forms)

    return made


def _several(sentence: Sentence) -> tuple[str, ...]:
    return (sentence,) if isinstance(sentence, str) else sentence


class Failure(NamedTuple):
    """An exception that ended a program, a launch or a command.

    :ivar type: the name of its class.
    :ivar message: its message from ROS 2 or Python.
    :ivar facts: facts that the message lacks, such as known names and the nearest one.
    :ivar process: the launch name of the program that it ended.
    """

    type: str
    message: str
    file: str | None = None
    line: int | None = None
    time_s: float | None = None
    process: str | None = None
    facts: dict[str, Any] = {}


def failure_of(error: BaseException) -> Failure:
    """Return the failure for an exception, with the facts of its attribute `edulaunch_facts`."""
    file, line = getattr(error, 'edulaunch_place', None) or (None, None)
    return Failure(type(error).__name__, str(error), file, line, facts=getattr(error, 'edulaunch_facts', {}))


KINDS = ('errors', 'plans', 'recordings', 'scripts', 'sources', 'workspaces')
"""The kinds of subjects of rules, each with a folder: a Failure, a Rehearsal, a Recording, launch files as syntax trees, a
Source, a Workspace.
"""


_loaded: dict[str, Rule] = {}


@cache
def rules_over(kind: str) -> tuple[Rule, ...]:
    """Return the rules that look at one kind of thing, in the order of their files, and the rules of plug-ins last."""
    folder = os.path.join(os.path.dirname(__file__), kind)
    modules = sorted(name.removesuffix('.py') for name in os.listdir(folder) if name.endswith('.py') and name[0] != '_')
    loaded = [import_module(f'edulaunch.advice.{kind}.{name}') for name in modules]
    loaded += modules_with_rules(kind)
    rules = tuple(value for module in loaded for value in vars(module).values() if isinstance(value, Rule))
    _loaded.update((rule.name, rule) for rule in rules)
    return rules


@cache
def all_rules() -> dict[str, Rule]:
    """Return every rule by its name, in alphabetical order."""
    rules = {rule.name: rule for kind in KINDS for rule in rules_over(kind)}
    return dict(sorted(rules.items()))


def rule_named(name: str) -> Rule:
    """Return the rule with that name. Only the files up to that rule are loaded. Raise KeyError if it does not exist."""
    return _loaded[name] if name in _loaded else all_rules()[name]

"""Rules, the findings that they report, and the functions that load rules.

Each folder beside this file contains the rules for one kind of thing. Rules are loaded when they are first used. A finding is
plain data, and `rendering.py` converts it to sentences. A failure may come from a file, so no code in it is ever executed.
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
    :ivar facts: the other facts that the sentences of the rule need. They are strings, numbers, lists of strings, or None.
    :ivar file: the student's file with the mistake, or None.
    :ivar line: the line of the mistake in this file, or None.
    :ivar time_s: the time of the mistake in simulated seconds since the start, or None.
    :ivar rule: the name of the rule, such as 'tf.unknown-frame'. The judge sets it.
    :ivar process: the launch name of the program whose error the finding explains. The judge sets it.
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
    """Return a finding for the rule that calls this function. The parameters are those of :class:`Finding`."""
    return Finding(kind, name, facts, file, line, time_s)


GROUPS = ('launch', 'programs', 'messages', 'packages', 'tf', 'time', 'turtlesim', 'grader')
LEVELS = ('error', 'warning', 'info')
"""The levels, worst first: it does not work, it works only by chance or not as written, or it is worth knowing."""
CONFIDENCES = ('stated', 'asked')
"""A 'stated' finding is certain. An 'asked' finding may be wrong about the intention, so its sentence asks or contains 'if'."""

Sentence = str | tuple[str, ...]
"""A template with facts in braces, as for `str.format`, or several. The first one whose facts are all known is used."""


EditForm = tuple[str, str, str]
"""Templates of the wrong and the correct text, and the place of the edit: 'word', or 'import' for a line among the imports."""


class Rule(NamedTuple):
    """A function that finds a mistake, and the sentences about the mistake, the reason and what to do."""

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
    """Return a decorator that makes a rule from a pure function that yields findings.

    The folder of the module determines what the function receives.

    :param name: 'group.what-is-wrong'. The group is one of :data:`GROUPS`.
    :param what: the sentence about the mistake, or several templates. The first template whose facts are all known is used.
    :param do: the sentence about what to do, or several templates.
    :param why: the sentence about the reason, or several templates.
    :param lesson: the lesson that explains the mistake, such as '09_broadcaster_and_listener'.
    :param level: how serious the mistake is, one of :data:`LEVELS`.
    :param confidence: how certain the finding is, one of :data:`CONFIDENCES`.
    :param hides: the rules whose findings are consequences of this rule's findings, and are therefore left out.
    :param edits: the edits that certainly correct the mistake, each as (old, new) or (old, new, place), with facts in braces. The
        first edit whose facts are all known is used. If `old` occurs more than once in the line, there is no edit.
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

    :ivar type: the name of the exception's class.
    :ivar message: the message of the exception from ROS 2 or Python.
    :ivar facts: facts that the message does not contain, such as known names and the most similar name.
    :ivar process: the launch name of the program that the exception ended, or None.
    """

    type: str
    message: str
    file: str | None = None
    line: int | None = None
    time_s: float | None = None
    process: str | None = None
    facts: dict[str, Any] = {}


def failure_of(error: BaseException) -> Failure:
    """Return the failure for an exception, with the facts and the place that the exception carries."""
    file, line = getattr(error, 'edulaunch_place', None) or (None, None)
    return Failure(type(error).__name__, str(error), file, line, facts=getattr(error, 'edulaunch_facts', {}))


KINDS = ('errors', 'plans', 'recordings', 'scripts', 'sources', 'workspaces')
"""The kinds of things that rules check, each with a folder of rules.
They are a Failure, a Rehearsal, a Recording, launch files as syntax trees, a PackageInWorkspace, and a Workspace.
"""


_loaded: dict[str, Rule] = {}


@cache
def rules_over(kind: str) -> tuple[Rule, ...]:
    """Return the rules for one kind of thing, in the order of their files. The rules of plug-ins come last."""
    folder = os.path.join(os.path.dirname(__file__), kind)
    modules = sorted(name.removesuffix('.py') for name in os.listdir(folder) if name.endswith('.py') and name[0] != '_')
    loaded = [import_module(f'edulaunch.advice.{kind}.{name}') for name in modules]
    loaded += modules_with_rules(kind)
    rules = tuple(value for module in loaded for value in vars(module).values() if isinstance(value, Rule))
    _loaded.update((rule.name, rule) for rule in rules)
    return rules


@cache
def all_rules() -> dict[str, Rule]:
    """Return all rules by name, in alphabetical order."""
    rules = {rule.name: rule for kind in KINDS for rule in rules_over(kind)}
    return dict(sorted(rules.items()))


def rule_named(name: str) -> Rule:
    """Return the rule with this name. All rules are loaded only if the rule is not loaded yet.

    :raises KeyError: when there is no such rule.
    """
    return _loaded[name] if name in _loaded else all_rules()[name]

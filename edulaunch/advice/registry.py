"""Where the rules are: each file of a folder beside this one has rules for one kind of thing. Loaded when they are asked."""

from __future__ import annotations

import os
import pkgutil
from functools import cache
from importlib import import_module

from edulaunch.advice.rule import Rule

KINDS = ('errors', 'plans', 'recordings', 'sources', 'workspaces')
"""What rules look at, each a folder: a Failure, a Rehearsal, a Recording, a Source, a Workspace."""


@cache
def rules_over(kind: str) -> tuple[Rule, ...]:
    """The rules that look at one kind of thing, in the order of their files."""
    folder = os.path.join(os.path.dirname(__file__), kind)
    modules = sorted(module.name for module in pkgutil.iter_modules([folder]))
    loaded = [import_module(f'edulaunch.advice.{kind}.{name}') for name in modules]
    return tuple(value for module in loaded for value in vars(module).values() if isinstance(value, Rule))


@cache
def all_rules() -> dict[str, Rule]:
    """Every rule by its name, in the order of the alphabet."""
    rules = {rule.name: rule for kind in KINDS for rule in rules_over(kind)}
    return dict(sorted(rules.items()))


@cache
def rule_named(name: str) -> Rule:
    """The rule of that name; only as many files are loaded as it takes to find it. Raises KeyError when there is none."""
    for kind in KINDS:
        for rule in rules_over(kind):
            if rule.name == name:
                return rule
    raise KeyError(name)

"""Where the rules are: each file of a folder beside this one has rules for one kind of thing. Loaded when they are asked."""

from __future__ import annotations

import os
from functools import cache
from importlib import import_module

from edulaunch.advice.rule import Rule

KINDS = ('errors', 'plans', 'recordings', 'sources', 'workspaces')
"""What rules look at, each a folder: a Failure, a Rehearsal, a Recording, a Source, a Workspace."""


_loaded: dict[str, Rule] = {}


@cache
def rules_over(kind: str) -> tuple[Rule, ...]:
    """The rules that look at one kind of thing, in the order of their files."""
    folder = os.path.join(os.path.dirname(__file__), kind)
    modules = sorted(name.removesuffix('.py') for name in os.listdir(folder) if name.endswith('.py') and name[0] != '_')
    loaded = [import_module(f'edulaunch.advice.{kind}.{name}') for name in modules]
    rules = tuple(value for module in loaded for value in vars(module).values() if isinstance(value, Rule))
    _loaded.update((rule.name, rule) for rule in rules)
    return rules


@cache
def all_rules() -> dict[str, Rule]:
    """Every rule by its name, in the order of the alphabet."""
    rules = {rule.name: rule for kind in KINDS for rule in rules_over(kind)}
    return dict(sorted(rules.items()))


def rule_named(name: str) -> Rule:
    """The rule of that name; only as many files are loaded as it takes to find it. Raises KeyError when there is none."""
    return _loaded[name] if name in _loaded else all_rules()[name]

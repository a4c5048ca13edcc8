"""Converts remapping rules to tuples of substitutions."""

from __future__ import annotations

from collections.abc import Iterable

from launch.utilities.texts import normalize_to_list_of_substitutions
from launch.utilities.type_utils import ensure_argument_type

from ..remap_rule_type import RemapRule, SomeRemapRule, SomeRemapRules


def normalize_remap_rule(remap_rule: SomeRemapRule) -> RemapRule:
    """Return one rule as a pair of tuples of substitutions.

    :raises TypeError: for anything but a tuple with two items.
    """
    ensure_argument_type(remap_rule, (tuple,), 'remap_rule')
    if len(remap_rule) != 2:
        raise TypeError(f'remap_rule must be a tuple of length 2, got length {len(remap_rule)}')
    source, target = remap_rule
    return tuple(normalize_to_list_of_substitutions(source)), tuple(normalize_to_list_of_substitutions(target))


def normalize_remap_rules(remap_rules: SomeRemapRules) -> Iterable[RemapRule]:
    """Normalize each rule with :func:`normalize_remap_rule`."""
    return (normalize_remap_rule(rule) for rule in remap_rules)

"""`if` and `unless`, which every action element may have."""

from __future__ import annotations

from typing import Any

from launch.conditions.if_condition import IfCondition
from launch.conditions.unless_condition import UnlessCondition

from ..entity import Entity
from ..parser import Parser

_CONDITIONS = {'if': IfCondition, 'unless': UnlessCondition}


def condition_of(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Keyword argument `condition`, when the element has one.

    :raises RuntimeError: when it has both.
    """
    given = entity.given(_CONDITIONS)
    if not given:
        return {}
    if len(given) > 1:
        raise RuntimeError("if and unless conditions can't be used simultaneously")
    (name,) = given
    predicate = parser.parse_substitution(entity.get_attr(name))
    return {'condition': _CONDITIONS[name](predicate_expression=predicate)}

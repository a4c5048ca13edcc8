"""`if` and `unless`, which every action element may have."""
from __future__ import annotations

from typing import Any

from launch.conditions.if_condition import IfCondition
from launch.conditions.unless_condition import UnlessCondition

from ..entity import Entity
from ..parser import Parser


def condition_of(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Keyword argument `condition`, when the element has one.

    :raises RuntimeError: when it has both.
    """
    if_text = entity.get_attr('if', optional=True)
    unless_text = entity.get_attr('unless', optional=True)
    if if_text is None and unless_text is None:
        return {}
    if if_text is None:
        return {'condition': UnlessCondition(predicate_expression=parser.parse_substitution(unless_text))}
    if unless_text is not None:
        raise RuntimeError("if and unless conditions can't be used simultaneously")
    return {'condition': IfCondition(predicate_expression=parser.parse_substitution(if_text))}

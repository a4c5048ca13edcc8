"""Parse `if` and `unless`, which every element of a launch file may have."""

from __future__ import annotations

from typing import Any

from ..conditions.if_condition import IfCondition
from ..conditions.unless_condition import UnlessCondition
from .entity import Entity
from .parser_protocol import ParserProtocol


def condition_of(entity: Entity, parser: ParserProtocol) -> dict[str, Any]:
    """Return the keyword argument `condition` if the element has `if` or `unless`, and otherwise an empty dictionary.

    :raises RuntimeError: when the element has both `if` and `unless`.
    """
    given = entity.given(('if', 'unless'))
    if not given:
        return {}
    if len(given) > 1:
        raise RuntimeError("if and unless conditions can't be used simultaneously")
    (name,) = given
    condition = IfCondition if name == 'if' else UnlessCondition
    return {'condition': condition(predicate_expression=parser.parse_substitution(entity.get_attr(name)))}

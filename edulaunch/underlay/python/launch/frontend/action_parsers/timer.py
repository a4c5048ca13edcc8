"""`<timer period= cancel_on_shutdown=>...</timer>`: actions after some time."""
from __future__ import annotations

from typing import Any

from launch.actions.timer_action import TimerAction

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import add_typed
from .condition import condition_of


def parse_timer(entity: Entity, parser: Parser) -> Parsed:
    """A timer; the period is in seconds."""
    return TimerAction, timer_attributes(entity, parser)


def timer_attributes(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Keyword arguments of every kind of timer."""
    kwargs = condition_of(entity, parser)
    kwargs['period'] = parser.parse_if_substitutions(entity.get_attr('period', data_type=float))
    add_typed(kwargs, entity, parser, bool, 'cancel_on_shutdown')
    kwargs['actions'] = [parser.parse_action(child) for child in entity.children]
    return kwargs

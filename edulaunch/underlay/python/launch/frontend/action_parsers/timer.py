"""`<timer period= cancel_on_shutdown=>...</timer>`: actions after some time."""

from __future__ import annotations

from typing import Any

from launch.actions.timer_action import TimerAction

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import Optionals, add_optionals, typed
from .condition import condition_of

_seconds = typed(float)
_OPTIONALS: Optionals = {'cancel_on_shutdown': ('cancel_on_shutdown', typed(bool))}


def parse_timer(entity: Entity, parser: Parser) -> Parsed:
    """A timer; the period is in seconds."""
    return TimerAction, timer_attributes(entity, parser)


def timer_attributes(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Keyword arguments of every kind of timer."""
    kwargs = condition_of(entity, parser)
    kwargs['period'] = _seconds(entity, parser, 'period')
    add_optionals(kwargs, entity, parser, _OPTIONALS)
    kwargs['actions'] = [parser.parse_action(child) for child in entity.children]
    return kwargs

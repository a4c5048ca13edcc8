"""`<shutdown reason=/>`: end the launch."""

from __future__ import annotations

from launch.actions.shutdown_action import Shutdown

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import Optionals, add_optionals, text
from .condition import condition_of

_OPTIONALS: Optionals = {'reason': ('reason', text)}


def parse_shutdown(entity: Entity, parser: Parser) -> Parsed:
    """A shutdown of the launched system."""
    kwargs = condition_of(entity, parser)
    add_optionals(kwargs, entity, parser, _OPTIONALS)
    return Shutdown, kwargs

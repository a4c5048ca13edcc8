"""`<shutdown reason=/>`: end the launch."""
from __future__ import annotations

from launch.actions.shutdown_action import Shutdown

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import add_texts
from .condition import condition_of


def parse_shutdown(entity: Entity, parser: Parser) -> Parsed:
    """A shutdown of the launched system."""
    kwargs = condition_of(entity, parser)
    add_texts(kwargs, entity, parser, reason='reason')
    return Shutdown, kwargs

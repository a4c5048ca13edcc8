"""`<log message=/>`: a line in the log."""

from __future__ import annotations

from launch.actions.log_info import LogInfo

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .condition import condition_of


def parse_log(entity: Entity, parser: Parser) -> Parsed:
    """A message at level INFO."""
    kwargs = condition_of(entity, parser)
    kwargs['msg'] = parser.parse_substitution(entity.get_attr('message'))
    return LogInfo, kwargs

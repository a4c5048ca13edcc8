"""`<let name= value=/>`: set a launch configuration."""

from __future__ import annotations

from launch.actions.set_launch_configuration import SetLaunchConfiguration

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .condition import condition_of


def parse_let(entity: Entity, parser: Parser) -> Parsed:
    """A launch configuration that is set."""
    kwargs = condition_of(entity, parser)
    kwargs['name'] = parser.parse_substitution(entity.get_attr('name'))
    kwargs['value'] = parser.parse_substitution(entity.get_attr('value'))
    return SetLaunchConfiguration, kwargs

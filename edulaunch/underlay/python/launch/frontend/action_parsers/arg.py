"""`<arg name= default= description=><choice value=/></arg>`: a launch argument."""
from __future__ import annotations

from launch.actions.declare_launch_argument import DeclareLaunchArgument

from ..entity import Entities, Entity
from ..late_parse import Parsed
from ..parser import Parser
from .condition import condition_of


def parse_arg(entity: Entity, parser: Parser) -> Parsed:
    """A declared launch argument."""
    kwargs = condition_of(entity, parser)
    kwargs['name'] = parser.escape_characters(entity.get_attr('name'))
    default = entity.get_attr('default', optional=True)
    if default is not None:
        kwargs['default_value'] = parser.parse_substitution(default)
    description = entity.get_attr('description', optional=True)
    if description is not None:
        kwargs['description'] = parser.escape_characters(description)
    choices = entity.get_attr('choice', data_type=Entities, optional=True)
    if choices is not None:
        kwargs['choices'] = [_choice(choice, parser) for choice in choices]
    return DeclareLaunchArgument, kwargs


def _choice(entity: Entity, parser: Parser) -> str:
    value = parser.escape_characters(entity.get_attr('value'))
    entity.assert_entity_completely_parsed()
    return value

"""`<arg name= default= description=><choice value=/></arg>`: a launch argument."""

from __future__ import annotations

from launch.actions.declare_launch_argument import DeclareLaunchArgument

from ..entity import Entities, Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import Optionals, add_optionals, text
from .condition import condition_of


def parse_arg(entity: Entity, parser: Parser) -> Parsed:
    """A declared launch argument."""
    kwargs = condition_of(entity, parser)
    kwargs['name'] = parser.escape_characters(entity.get_attr('name'))
    add_optionals(kwargs, entity, parser, _OPTIONALS, _CHILDREN)
    return DeclareLaunchArgument, kwargs


def _literal(entity: Entity, parser: Parser, name: str) -> str:
    return parser.escape_characters(entity.get_attr(name))


def _choices(entity: Entity, parser: Parser, name: str) -> list[str]:
    choices = []
    for child in entity.get_attr(name, data_type=Entities):
        choices.append(_literal(child, parser, 'value'))
        child.assert_entity_completely_parsed()
    return choices


_OPTIONALS: Optionals = {'default': ('default_value', text), 'description': ('description', _literal)}
_CHILDREN: Optionals = {'choice': ('choices', _choices)}

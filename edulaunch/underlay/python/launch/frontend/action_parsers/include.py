"""`<include file=><arg name= value=/></include>`: another launch file."""

from __future__ import annotations

from launch.actions.include_launch_description import IncludeLaunchDescription

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import NOTHING, Optionals, add_optionals, pairs
from .condition import condition_of

_CHILDREN: Optionals = {'arg': ('launch_arguments', pairs)}


def parse_include(entity: Entity, parser: Parser) -> Parsed:
    """A launch file of any format, with launch arguments."""
    kwargs = condition_of(entity, parser)
    kwargs['launch_description_source'] = parser.parse_substitution(entity.get_attr('file'))
    add_optionals(kwargs, entity, parser, NOTHING, _CHILDREN)
    return IncludeLaunchDescription, kwargs

"""`<node pkg= exec= ...>` with `<param>`, `<remap>` and `<env>` inside: a ROS node."""
from __future__ import annotations

from typing import Any

from launch_ros.actions.node import Node

from ..entity import Entities, Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import add_texts, pairs
from .command_line import words_of
from .executable import process_attributes
from .param import parameters_of

_READ_HERE = frozenset(('cmd', 'name'))
_TEXTS = {'package': 'pkg', 'name': 'name', 'namespace': 'namespace', 'exec_name': 'exec_name'}


def parse_node(entity: Entity, parser: Parser) -> Parsed:
    """A ROS node."""
    return Node, node_attributes(entity, parser)


def node_attributes(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Keyword arguments of every action that starts a ROS node."""
    kwargs = process_attributes(entity, parser, _READ_HERE)
    for keyword, attribute in (('arguments', 'args'), ('ros_arguments', 'ros_args')):
        text = entity.get_attr(attribute, optional=True)
        if text is not None:
            kwargs[keyword] = words_of(text, parser)
    kwargs['executable'] = parser.parse_substitution(entity.get_attr('exec'))
    add_texts(kwargs, entity, parser, **_TEXTS)
    add_names_and_parameters(kwargs, entity, parser)
    return kwargs


def add_names_and_parameters(kwargs: dict[str, Any], entity: Entity, parser: Parser) -> None:
    """The children `<remap from= to=/>` and `<param .../>`, which composable nodes have too."""
    remappings = pairs(entity, parser, 'remap', 'from', 'to')
    if remappings is not None:
        kwargs['remappings'] = remappings
    parameters = entity.get_attr('param', data_type=Entities, optional=True)
    if parameters is not None:
        kwargs['parameters'] = parameters_of(parameters, parser)

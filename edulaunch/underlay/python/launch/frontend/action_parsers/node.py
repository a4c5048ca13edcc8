"""`<node pkg= exec= ...>` with `<param>`, `<remap>` and `<env>` inside: a ROS node."""

from __future__ import annotations

from typing import Any

from launch_ros.actions.node import Node

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import Optionals, Substitutions, add_optionals, pairs, text
from .command_line import words_of
from .condition import condition_of
from .executable import PROCESS_CHILDREN, PROCESS_OPTIONALS
from .param import parameters_in


def _words(entity: Entity, parser: Parser, name: str) -> list[Substitutions]:
    return words_of(entity.get_attr(name), parser)


def _remappings(entity: Entity, parser: Parser, name: str) -> list[tuple[Substitutions, Substitutions]]:
    return pairs(entity, parser, name, 'from', 'to')


NODE_CHILDREN: Optionals = {'remap': ('remappings', _remappings), 'param': ('parameters', parameters_in)}
"""What composable nodes have too."""
_OPTIONALS: Optionals = {
    **PROCESS_OPTIONALS,
    'pkg': ('package', text),
    'namespace': ('namespace', text),
    'exec_name': ('exec_name', text),
    'args': ('arguments', _words),
    'ros_args': ('ros_arguments', _words),
}
_CHILDREN: Optionals = {**PROCESS_CHILDREN, **NODE_CHILDREN}


def parse_node(entity: Entity, parser: Parser) -> Parsed:
    """A ROS node."""
    return Node, node_attributes(entity, parser)


def node_attributes(entity: Entity, parser: Parser) -> dict[str, Any]:
    """Keyword arguments of every action that starts a ROS node."""
    kwargs = condition_of(entity, parser)
    kwargs['executable'] = text(entity, parser, 'exec')
    add_optionals(kwargs, entity, parser, _OPTIONALS, _CHILDREN)
    return kwargs

"""`<node_container>`, `<load_composable_node>` and the `<composable_node>` elements inside them."""

from __future__ import annotations

from typing import Any

from launch_ros.actions.composable_node_container import ComposableNodeContainer
from launch_ros.actions.load_composable_nodes import LoadComposableNodes
from launch_ros.descriptions import ComposableNode

from ..entity import Entities, Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import NOTHING, Optionals, add_optionals, pairs, text
from .condition import condition_of
from .node import NODE_CHILDREN, node_attributes


def parse_node_container(entity: Entity, parser: Parser) -> Parsed:
    """`<node_container>`: a container with the nodes it loads."""
    kwargs = node_attributes(entity, parser)
    add_optionals(kwargs, entity, parser, NOTHING, _CHILDREN_OF_CONTAINER)
    return ComposableNodeContainer, kwargs


def parse_load_composable_node(entity: Entity, parser: Parser) -> Parsed:
    """`<load_composable_node target=>`: nodes for a container that runs already."""
    kwargs = condition_of(entity, parser)
    kwargs['target_container'] = text(entity, parser, 'target')
    kwargs['composable_node_descriptions'] = _descriptions(entity, parser, 'composable_node')
    return LoadComposableNodes, kwargs


def parse_composable_node(entity: Entity, parser: Parser) -> Parsed:
    """`<composable_node pkg= plugin= name= namespace=>` with `<param>`, `<remap>` and `<extra_arg>`."""
    kwargs = condition_of(entity, parser)
    for keyword, name in (('package', 'pkg'), ('plugin', 'plugin'), ('name', 'name')):
        kwargs[keyword] = text(entity, parser, name)
    add_optionals(kwargs, entity, parser, _OPTIONALS, _CHILDREN)
    entity.assert_entity_completely_parsed()
    return ComposableNode, kwargs


def _descriptions(entity: Entity, parser: Parser, name: str) -> list[ComposableNode]:
    descriptions = []
    for child in entity.get_attr(name, data_type=Entities):
        made_by, kwargs = parse_composable_node(child, parser)
        descriptions.append(made_by(**kwargs))
    return descriptions


def _extra_arguments(entity: Entity, parser: Parser, name: str) -> list[Any]:
    return [{tuple(key): value} for key, value in pairs(entity, parser, name)]


_CHILDREN_OF_CONTAINER: Optionals = {'composable_node': ('composable_node_descriptions', _descriptions)}
_OPTIONALS: Optionals = {'namespace': ('namespace', text)}
_CHILDREN: Optionals = {**NODE_CHILDREN, 'extra_arg': ('extra_arguments', _extra_arguments)}

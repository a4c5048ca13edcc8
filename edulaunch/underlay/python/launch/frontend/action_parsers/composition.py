"""`<node_container>`, `<load_composable_node>` and the `<composable_node>` elements inside them."""
from __future__ import annotations

from typing import Any

from launch_ros.actions.composable_node_container import ComposableNodeContainer
from launch_ros.actions.load_composable_nodes import LoadComposableNodes
from launch_ros.descriptions import ComposableNode

from ..entity import Entities, Entity
from ..late_parse import Parsed
from ..parser import Parser
from .attributes import add_texts, pairs
from .condition import condition_of
from .node import add_names_and_parameters, node_attributes


def parse_node_container(entity: Entity, parser: Parser) -> Parsed:
    """`<node_container>`: a container with the nodes it loads."""
    kwargs = node_attributes(entity, parser)
    entities = entity.get_attr('composable_node', data_type=Entities, optional=True)
    if entities is not None:
        kwargs['composable_node_descriptions'] = _descriptions(entities, parser)
    return ComposableNodeContainer, kwargs


def parse_load_composable_node(entity: Entity, parser: Parser) -> Parsed:
    """`<load_composable_node target=>`: nodes for a container that runs already."""
    kwargs = condition_of(entity, parser)
    kwargs['target_container'] = parser.parse_substitution(entity.get_attr('target'))
    entities = entity.get_attr('composable_node', data_type=Entities)
    kwargs['composable_node_descriptions'] = _descriptions(entities, parser)
    return LoadComposableNodes, kwargs


def parse_composable_node(entity: Entity, parser: Parser) -> Parsed:
    """`<composable_node pkg= plugin= name= namespace=>` with `<param>`, `<remap>` and `<extra_arg>`."""
    kwargs: dict[str, Any] = condition_of(entity, parser)
    kwargs['package'] = parser.parse_substitution(entity.get_attr('pkg'))
    kwargs['plugin'] = parser.parse_substitution(entity.get_attr('plugin'))
    kwargs['name'] = parser.parse_substitution(entity.get_attr('name'))
    add_texts(kwargs, entity, parser, namespace='namespace')
    add_names_and_parameters(kwargs, entity, parser)
    extra_arguments = pairs(entity, parser, 'extra_arg')
    if extra_arguments is not None:
        kwargs['extra_arguments'] = [{tuple(name): value} for name, value in extra_arguments]
    entity.assert_entity_completely_parsed()
    return ComposableNode, kwargs


def _descriptions(entities: list[Entity], parser: Parser) -> list[ComposableNode]:
    descriptions = []
    for entity in entities:
        made_by, kwargs = parse_composable_node(entity, parser)
        descriptions.append(made_by(**kwargs))
    return descriptions

"""`<push_ros_namespace namespace=/>`: a namespace for the nodes that follow in the scope."""

from __future__ import annotations

from launch_ros.actions.push_ros_namespace import PushROSNamespace

from ..entity import Entity
from ..late_parse import Parsed
from ..parser import Parser
from .condition import condition_of


def parse_push_ros_namespace(entity: Entity, parser: Parser) -> Parsed:
    """A pushed ROS namespace."""
    kwargs = condition_of(entity, parser)
    kwargs['namespace'] = parser.parse_substitution(entity.get_attr('namespace'))
    return PushROSNamespace, kwargs

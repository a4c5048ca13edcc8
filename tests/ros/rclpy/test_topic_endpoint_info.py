"""TopicEndpointInfo and TypeHash as values."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from rclpy.node import Node
from rclpy.qos import QoSProfile
from rclpy.topic_endpoint_info import TopicEndpointInfo, TopicEndpointTypeEnum
from rclpy.type_hash import TypeHash
from std_msgs.msg import String

from .conftest import World

EMPTY = """Node name: \nNode namespace: \nTopic type: \nTopic type hash: INVALID\nEndpoint type: INVALID\nGID: \nQoS profile:
  Reliability: UNKNOWN\n  History (Depth): UNKNOWN\n  Durability: UNKNOWN\n  Lifespan: 0 nanoseconds\n  Deadline: 0 nanoseconds
  Liveliness: UNKNOWN\n  Liveliness lease duration: 0 nanoseconds"""


@pytest.mark.parametrize(
    ('given', 'text'),
    [
        ({}, 'INVALID'),
        ({'version': 1}, 'RIHS01_' + '00' * 32),
        ({'version': 2, 'value': bytes(range(32))}, 'RIHS02_' + bytes(range(32)).hex()),
        ({'version': 0, 'value': bytes(32)}, 'INVALID'),
        ({'version': 1, 'value': b'12'}, 'INVALID'),
    ],
)
def test_a_type_hash_needs_a_version_and_32_bytes(given: dict[str, Any], text: str) -> None:
    assert str(TypeHash(**given)) == text
    assert TypeHash(**given) == TypeHash(**given)


def test_an_info_without_arguments_is_empty() -> None:
    assert TopicEndpointInfo() == TopicEndpointInfo()
    assert str(TopicEndpointInfo()) == EMPTY


@pytest.mark.parametrize(
    ('name', 'value', 'stored'),
    [
        ('node_name', 'n', 'n'),
        ('endpoint_type', 2, TopicEndpointTypeEnum.SUBSCRIPTION),
        ('endpoint_gid', [1, 2], [1, 2]),
        ('topic_type_hash', {'version': 1}, TypeHash(1)),
        ('qos_profile', {'depth': 3}, QoSProfile(depth=3)),
    ],
)
def test_fields_can_be_given_and_set(name: str, value: Any, stored: Any) -> None:
    info = TopicEndpointInfo()
    setattr(info, name, value)
    assert getattr(info, name) == stored
    assert info == TopicEndpointInfo(**{name: value}) != TopicEndpointInfo()


@pytest.mark.parametrize(
    ('name', 'value', 'error'),
    [
        ('topic_type', 3, AssertionError),
        ('endpoint_type', 9, ValueError),
        ('endpoint_gid', 3, TypeError),
        ('qos_profile', 3, AssertionError),
        ('colour', 'red', AssertionError),
    ],
)
def test_wrong_fields_are_refused(name: str, value: Any, error: type[Exception]) -> None:
    with pytest.raises(error):
        TopicEndpointInfo(**{name: value})


def test_what_a_query_gives_is_a_copy(ros: Callable[..., list[Any]], world: World) -> None:
    def body() -> None:
        node = Node('n')
        publisher = node.create_publisher(String, 't', 1)
        (info,) = node.get_publishers_info_by_topic('t')
        info.node_name = 'm'
        world.say((info == node.get_publishers_info_by_topic('t')[0], str(info.topic_type_hash)[:15]))
        publisher.endpoint.type_name = 'other_msgs/msg/Unknown'
        world.say(str(node.get_publishers_info_by_topic('t')[0].topic_type_hash))

    assert ros(body) == [(False, 'RIHS01_df668c74'), 'INVALID']

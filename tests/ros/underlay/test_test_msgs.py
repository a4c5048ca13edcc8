"""test_msgs.message_fixtures: messages with telling values."""

from __future__ import annotations

import pytest
from rclpy.serialization import deserialize_message, serialize_message
from test_msgs import message_fixtures
from test_msgs.msg import BasicTypes


@pytest.mark.parametrize('name', message_fixtures._NAMES)
def test_all_messages_survive_the_wire(name: str) -> None:
    messages = message_fixtures.get_test_msg(name)
    assert messages
    for message in messages:
        assert deserialize_message(serialize_message(message), type(message)) == message


def test_basic_types_reach_the_ends_of_their_ranges() -> None:
    nothing, small, most, least = message_fixtures.get_msg_basic_types()
    assert (nothing, small.int8_value, most.uint64_value, least.int64_value) == (BasicTypes(), 1, 2**64 - 1, -(2**63))
    with pytest.raises(NotImplementedError):
        message_fixtures.get_test_msg('Twist')

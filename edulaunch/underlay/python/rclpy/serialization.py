"""Messages as bytes."""
from __future__ import annotations

from typing import Any

from edulaunch.interfaces.cdr import deserialize, serialize
from rclpy.impl.passed_on import passed_on
from rclpy.type_support import check_is_valid_msg_type


def serialize_message(message: Any) -> bytes:
    """The CDR bytes of a message."""
    check_is_valid_msg_type(type(message))
    return serialize(message)


def deserialize_message(serialized_message: bytes, message_type: Any) -> Any:
    """The message of type `message_type` that CDR bytes hold."""
    check_is_valid_msg_type(message_type)
    return deserialize(serialized_message, message_type)


__getattr__ = passed_on(__name__, {
    'rclpy.type_support': 'check_for_type_support',
})

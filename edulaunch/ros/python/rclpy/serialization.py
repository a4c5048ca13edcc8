"""Functions that convert messages to bytes and bytes to messages."""

from __future__ import annotations

from typing import Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.interfaces.message import rules_of
from edulaunch.errors import InterfaceError
from edulaunch.ros.passed_on import passed_on
from edulaunch.ros.serialization.cdr import deserialize, serialize
from rclpy._rclpy_pybind11 import RMWError
from rclpy.type_support import check_is_valid_msg_type


def serialize_message(message: Any) -> bytes:
    """Return the CDR bytes of a message. As in Fast DDS, the bytes of a type with a fixed size are padded to a multiple of
    four.
    """
    check_is_valid_msg_type(type(message))
    data = serialize(message)
    return data + bytes(-len(data) % 4) if _has_one_size(type(message)) else data


def deserialize_message(serialized_message: bytes, message_type: Any) -> Any:
    """Return the message of type `message_type` that the CDR bytes contain.

    :raises RMWError: when the bytes are not a message of that type.
    :raises TypeError: if `serialized_message` is not of type bytes.
    """
    check_is_valid_msg_type(message_type)
    if not isinstance(serialized_message, bytes):
        raise TypeError(
            f'incompatible function arguments: a serialized message must be bytes, not {type(serialized_message).__name__}'
        )
    try:
        return deserialize(serialized_message, message_type)
    except InterfaceError as error:
        package, kind, name = message_type.TYPE.split('/')
        raise with_facts(
            RMWError(
                'failed to deserialize ROS message: Fast CDR exception deserializing message of type '
                f'{package}::{kind}::dds_::{name}_.'
            ),
            'messages.other-bytes',
            wanted=message_type.TYPE,
            reason=error.message,
        ) from None


def _has_one_size(message_type: Any) -> bool:
    """Return whether a type has neither strings nor sequences."""
    return all(
        rule.type.array in ('', 'fixed') and (_has_one_size(rule.message) if rule.message else rule.kind.python is not str)
        for rule in rules_of(message_type).values()
    )


__getattr__ = passed_on(__name__)

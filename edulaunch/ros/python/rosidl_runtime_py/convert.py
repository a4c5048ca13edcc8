"""Converts messages to plain data, YAML and CSV."""

from __future__ import annotations

from collections import OrderedDict
from typing import Any

from edulaunch.ros.serialization.message_text import Shortening, message_csv, message_dict, message_yaml


def message_to_ordereddict(
    msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False
) -> OrderedDict[str, Any]:
    """Return the message as dictionaries, lists, numbers and strings, with its fields in order.

    :param truncate_length: the maximum number of items of an array and characters of a string. The rest becomes `...`.
    :param no_arr: whether to replace arrays with their type and length.
    :param no_str: whether to replace strings with their type and length.
    """
    ordered: OrderedDict[str, Any] = _ordered(message_dict(msg, Shortening(truncate_length, no_arr, no_str)))
    return ordered


def message_to_yaml(
    msg: Any, *, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False, flow_style: bool = False
) -> str:
    """Return the message as YAML, as `ros2 topic echo` prints it. For the other parameters, see
    :func:`message_to_ordereddict`.

    :param flow_style: whether to write the message on one line in braces.
    """
    return message_yaml(msg, Shortening(truncate_length, no_arr, no_str), flow_style=flow_style)


def message_to_csv(msg: Any, truncate_length: int | None = None, no_arr: bool = False, no_str: bool = False) -> str:
    """Return all values of the message, separated by commas. For the other parameters, see :func:`message_to_ordereddict`."""
    return message_csv(msg, Shortening(truncate_length, no_arr, no_str))


def get_message_slot_types(msg: Any) -> OrderedDict[str, Any]:
    """Return the type of each field in `SLOT_TYPES`, by field name."""
    return OrderedDict(zip(msg.get_fields_and_field_types(), msg.SLOT_TYPES, strict=True))


def _ordered(value: Any) -> Any:
    if isinstance(value, dict):
        return OrderedDict((name, _ordered(item)) for name, item in value.items())
    return [_ordered(item) for item in value] if isinstance(value, list) else value

"""Finds interface classes by the type in a definition."""

from __future__ import annotations

from typing import Any

from rosidl_parser.definition import NamespacedType

from rosidl_runtime_py.utilities import get_interface


def import_message_from_namespaced_type(message_type: NamespacedType) -> Any:
    """Return the class for an entry of `SLOT_TYPES`.

    :raises ModuleNotFoundError: when there is no such package, as in `rosidl_runtime_py.utilities.get_interface`.
    :raises AttributeError: when the package has no such message.
    """
    return get_interface('/'.join((*message_type.namespaces, message_type.name)))

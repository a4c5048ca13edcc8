"""Finds interface classes by their full names."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.interfaces import current_registry
from edulaunch.errors import InterfaceError

if TYPE_CHECKING:
    from rosidl_parser.definition import NamespacedType


def get_interface(identifier: str) -> Any:
    """Return the class of 'pkg/msg/Name', 'pkg/srv/Name' or 'pkg/action/Name'.

    :raises ValueError: when the name has another form.
    :raises ModuleNotFoundError: when there is no such package, or the package has no interfaces of this kind.
    :raises AttributeError: when the package has no interface of that name.
    """
    parts = identifier.split('/')
    if len(parts) != 3 or not all(parts):
        raise ValueError(
            f"Expected the full name of a message, service or action, got '{identifier}'"
            "\n  help: write package, kind and type, such as 'std_msgs/msg/String'"
        )
    package, kind, name = parts
    registry = current_registry()
    if not registry.has(package, kind):
        missing = f'{package}.{kind}' if registry.has(package) else package
        raise ModuleNotFoundError(f"No module named '{missing}'", name=missing)
    try:
        return registry.get(identifier)
    except InterfaceError as error:
        if name in registry.names(package, kind):
            raise
        words = f'\n  help: {error.help}' if error.help else ''
        raise AttributeError(f"module '{package}.{kind}' has no attribute '{name}'{words}") from None


def get_namespaced_type(identifier: str) -> NamespacedType:
    """Return the field type for a name such as 'pkg/msg/Name'. The type need not exist.

    :raises ValueError: when the name has another form.
    """
    from rosidl_parser.definition import NamespacedType

    parts = identifier.split('/')
    if len(parts) != 3 or not all(parts):
        raise ValueError(
            f"Expected the full name of an interface, got '{identifier}'"
            "\n  help: write package, kind and type, such as 'std_msgs/msg/String'"
        )
    return NamespacedType((parts[0], parts[1]), parts[2])


def is_message(interface: Any) -> bool:
    """Return whether a class is a message class. Classes of requests, responses, goals and similar messages also count."""
    return hasattr(interface, 'get_fields_and_field_types')


def is_service(interface: Any) -> bool:
    """Return whether a class is a service class."""
    return hasattr(interface, 'Request') and hasattr(interface, 'Response')


def is_action(interface: Any) -> bool:
    """Return whether a class is an action class."""
    return hasattr(interface, 'Goal') and hasattr(interface, 'Result') and hasattr(interface, 'Feedback')


def get_message(identifier: str) -> Any:
    """Return the class of a message. The short form 'pkg/Name' is also allowed.

    :raises ValueError: when the name is not the name of a message. :func:`get_interface` lists the other errors.
    """
    return _of_kind(identifier, 'msg', 'message', is_message)


def get_service(identifier: str) -> Any:
    """Return the class of a service. The short form 'pkg/Name' is also allowed.

    :raises ValueError: when the name is not the name of a service. :func:`get_interface` lists the other errors.
    """
    return _of_kind(identifier, 'srv', 'service', is_service)


def get_action(identifier: str) -> Any:
    """Return the class of an action. The short form 'pkg/Name' is also allowed.

    :raises ValueError: when the name is not the name of an action. :func:`get_interface` lists the other errors.
    """
    return _of_kind(identifier, 'action', 'action', is_action)


def _of_kind(identifier: str, kind: str, word: str, fits: Callable[[Any], bool]) -> Any:
    parts = identifier.split('/')
    found = get_interface(f'{parts[0]}/{kind}/{parts[1]}' if len(parts) == 2 else identifier)
    if not fits(found):
        raise ValueError(f"Expected the full name of a {word}, got '{identifier}'")
    return found

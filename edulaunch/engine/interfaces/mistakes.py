"""Facts about mistakes with messages, as plain data: a rejected value, a misspelt field, or an unknown type.

`twist.linaer = 1` must raise Python's own AttributeError, as with the real rclpy. A hook that extends the message of this error
(`__setattr__`) would make each correct assignment three times slower. So the code that reports an error to the user gets more
facts from this module.
"""

from __future__ import annotations

import re
from collections.abc import Iterable
from typing import Any, Protocol

from edulaunch.engine.interfaces.message import Message
from edulaunch.engine.interfaces.spec import FieldType
from edulaunch.engine.nearest import did_you_mean, nearest
from edulaunch.errors import InterfaceError

Facts = dict[str, Any]


class KnownTypes(Protocol):
    """The part of a registry that is needed to suggest a type for a wrong type name."""

    def has(self, package: str, /) -> bool:
        """Return whether a package has interfaces."""

    def homes(self, name: str, kind: str | None, /) -> list[str]:
        """Return the modules that have an interface with this name."""

    def packages(self) -> list[str]:
        """Return the names of all packages that have interfaces."""

    def types(self) -> list[str]:
        """Return all full type names."""

    def classes(self) -> list[type[Any]]:
        """Return all classes that have been created so far."""


def value_facts(field_type: FieldType, message: type[Message] | None, name: str, value: Any) -> Facts:
    """Return the facts about a rejected value, for the rule `messages.field-value`.

    The facts are `field`, `wanted` and `given`. Depending on the value, `write`, `fields`, `value`, `convert`, `commas`, or
    `count` and `size` are added.
    """
    kind = field_type.kind
    wanted = message.__name__ if message is not None else kind.python.__name__ if kind is not None else 'str'
    facts = {'about': 'messages.field-value', 'field': name, 'wanted': wanted, 'given': given_kind(value)}
    if not field_type.array:
        return facts | _one(field_type, message, name, value)
    facts['wanted'] = f'{wanted}[]'
    if type(value).__module__ == 'numpy':
        return facts | _numpy(field_type, value)
    if not isinstance(value, Iterable):
        return facts | {'write': f'[{_brief(value)}]'}
    return facts if isinstance(value, (str, bytes)) else facts | _several(field_type, message, name, list(value))


def _numpy(field_type: FieldType, value: Any) -> Facts:
    kind = field_type.kind
    if getattr(value, 'ndim', 0) > 1:
        return {'write': 'value.ravel()'}
    if kind is not None and kind.is_number and getattr(value, 'ndim', 0) == 1:
        return {'given': f'{given_kind(value)}({value.dtype})', 'write': f"value.astype('{kind.name}')"}
    return {'write': 'value.tolist()'}


def _several(field_type: FieldType, message: type[Message] | None, name: str, values: list[Any]) -> Facts:
    kind = field_type.kind
    wanted = message or (kind.python if kind else object)
    for index, value in enumerate(values):
        if not isinstance(value, wanted):
            return value_facts(field_type.element, message, f'{name}[{index}]', value)
    if field_type.array != 'unbounded' and len(values) != field_type.size:
        return {'count': len(values), 'size': field_type.size}
    return {'value': _brief(values)}


def _one(field_type: FieldType, message: type[Message] | None, name: str, value: Any) -> Facts:
    kind = field_type.kind
    if message is not None and hasattr(value, 'to_msg'):
        return {'convert': 'to_msg'}
    if message is not None:
        return {'fields': [f'{name}.{field}' for field in message._FIELDS]}
    if kind is None or isinstance(value, kind.python):
        return {'value': _brief(value)}
    if kind.python is float and type(value) is int:
        return {'write': f'{value}.0' if abs(value) < 10**15 else 'float(value)'}
    if kind.python is float and type(value) is tuple:
        return {'commas': len(value)}
    if kind.python is bytes:
        return {'write': f'bytes([{value}])'} if type(value) is int and 0 <= value < 256 else {}
    return {'write': f'{kind.python.__name__}(value)'} if _converts(kind.python, value) else {}


def _converts(python: type, value: Any) -> bool:
    try:
        python(value)
    except (TypeError, ValueError, OverflowError):
        return False
    return python is not bool or type(value).__module__ == 'numpy' or isinstance(value, int)


def given_kind(value: Any) -> str:
    """Return the kind of a value, such as 'int', 'numpy.float32', 'geometry_msgs.msg.Point' or 'None'."""
    cls = type(value)
    if value is None:
        return 'None'
    if isinstance(value, Message):
        return str(cls.TYPE).replace('/', '.')
    return cls.__name__ if cls.__module__ == 'builtins' else f'{cls.__module__}.{cls.__name__}'


def _brief(value: Any) -> str:
    text = repr(value)
    return text if len(text) <= 60 else f'{text[:57]}...'


_TEXT = re.compile(r"'(?P<type>\w+)' object has no attribute '(?P<name>\w+)'", re.ASCII)


def field_facts(error: BaseException, registry: KnownTypes) -> dict[str, Any]:
    """Return the facts of an AttributeError about a message: the message's type, its fields, and the field with the nearest
    name. Return {} for other errors.

    :param registry: the registry whose existing classes are searched by name, because before Python 3.13 the error may not
        contain the object.
    """
    match = _TEXT.match(str(error)) if isinstance(error, AttributeError) else None
    if match is None:
        return {}
    classes = _candidates(error, match['type'], registry)
    if not classes:
        return {}
    name = match['name']
    near = next(filter(None, (nearest(name, cls._FIELDS) for cls in classes)), None)
    type_name = classes[0].__name__
    return {'about': 'messages.field', 'type': type_name, 'field': name, 'near': near, 'fields': list(classes[0]._FIELDS)}


def _candidates(error: BaseException, name: str, registry: KnownTypes) -> list[type[Message]]:
    owner = getattr(error, 'obj', None)
    if owner is not None:
        return [type(owner)] if isinstance(owner, Message) else []
    return [cls for cls in registry.classes() if issubclass(cls, Message) and cls.__name__ == name]


def unknown_type(registry: KnownTypes, type_name: str) -> InterfaceError:
    """Return the error for an unknown type name, with a suggestion if there is one."""
    return InterfaceError(f"unknown interface '{type_name}'", help=type_help(registry, type_name))


def type_help(registry: KnownTypes, type_name: str) -> str | None:
    """Return a line that suggests the intended type for a wrong type name, or None if no type has a similar name."""
    package, _, name = type_name.partition('/')
    kind, _, name = name.rpartition('/')
    elsewhere = registry.homes(name, kind or None)
    if elsewhere:
        return f'{name} is in {" and ".join(elsewhere)}'
    if not registry.has(package):
        return (
            did_you_mean(package, registry.packages())
            or 'no package with interfaces has this name: is its workspace built and sourced?'
        )
    return did_you_mean(type_name, registry.types())

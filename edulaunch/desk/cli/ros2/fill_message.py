"""Find the class of a type that the user names, and fill a message with values in YAML."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.interfaces import current_registry
from edulaunch.engine.interfaces.message import rules_of, spec_of
from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import InterfaceError

if TYPE_CHECKING:
    from edulaunch.engine.interfaces.message import Message
    from edulaunch.engine.interfaces.spec import Field, FieldType

Stamp = Callable[[Any], None]
"""Sets one time field of a message."""

HEADER, TIME = 'std_msgs/msg/Header', 'builtin_interfaces/msg/Time'
_YAML_HELP = 'write the fields in braces, with a space after each colon: "{x: 2.0, name: \'turtle2\'}"'
EXAMPLES = {'msg': 'geometry_msgs/msg/Twist', 'srv': 'turtlesim/srv/Spawn', 'action': 'turtlesim/action/RotateAbsolute'}


class FillError(Exception):
    """A value does not fit its field. The message begins as in ROS 2, and a line of help may follow."""

    def __init__(self, text: str, help: str | None = None) -> None:
        super().__init__(f'Failed to populate field: {text}' + ('' if help is None else f'\n  help: {help}'))


def parse_values(text: str) -> dict[str, Any]:
    """Return the field values that a YAML string contains, by name.

    :raises ValuesError: when the string is not valid YAML or not a dictionary, with the message of ROS 2.
    """
    import yaml

    try:
        values = yaml.safe_load(text)
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        raise ValuesError(f'The passed value is not valid YAML: {str(error).splitlines()[0]}\n  help: {_YAML_HELP}') from None
    if values is None:
        return {}
    if isinstance(values, str) and isinstance(parse_or_none(values), dict):
        inside = f'leave out the quotes inside the string, which only a shell removes: "{values}"'
        raise ValuesError(f'The passed value needs to be a dictionary in YAML format\n  help: {inside}')
    if not isinstance(values, dict):
        raise ValuesError(f'The passed value needs to be a dictionary in YAML format\n  help: {_YAML_HELP}')
    return values


def parse_or_none(text: str) -> Any:
    """Return the value of a YAML string, or None if it is not valid YAML."""
    import yaml

    try:
        return yaml.safe_load(text)
    except (yaml.YAMLError, ValueError, RecursionError):
        return None


class ValuesError(FillError):
    """The values are not valid YAML, or they are not a dictionary."""

    def __init__(self, text: str) -> None:
        Exception.__init__(self, text)


def fill_message(message: Message, values: dict[str, Any], *, stamps: bool = False) -> list[Stamp]:
    """Set the fields of a message that `values` names. As in ROS 2, convert numbers to the type of the field.

    :param stamps: whether `header: auto`, and `now` in a time field, mean the time of sending.
    :returns: functions that set these times. Call each function with a Time before each sending.
    :raises FillError: for an unknown field, or a value that does not fit.
    """
    found: list[Stamp] = []
    fields = {field.name: field for field in spec_of(message).fields}
    for name, value in values.items():
        field = fields.get(name)
        if field is None:
            listed = f'the fields of {message.TYPE} are: {", ".join(fields) or "(none)"}'
            blank = f'put a space after the colon: {str(name).replace(":", ": ", 1)}' if ':' in str(name) else None
            raise FillError(
                f'{type(message).__name__!r} object has no attribute {name!r}', blank or did_you_mean(str(name), fields) or listed
            )
        if stamps and _is_stamp(field, value):
            found.append(_stamp(message, field))
        else:
            found += _fill_field(message, field, value, stamps)
    return found


def _is_stamp(field: Field, value: Any) -> bool:
    return not field.type.array and (field.type.base, value) in ((HEADER, 'auto'), (TIME, 'now'))


def _stamp(message: Message, field: Field) -> Stamp:
    if field.type.base == HEADER:
        header = getattr(message, field.name)
        return lambda now: setattr(header, 'stamp', now)
    return lambda now: setattr(message, field.name, now)


def _fill_field(message: Message, field: Field, value: Any, stamps: bool) -> list[Stamp]:
    kind, found = field.type.kind, []
    try:
        if kind is None and not field.type.array:
            return fill_message(getattr(message, field.name), _dictionary(value), stamps=stamps)
        if kind is None:
            new = []
            for item in _list(field, value):
                new.append(rules_of(message)[field.name].message())
                found += fill_message(new[-1], _dictionary(item), stamps=stamps)
        else:
            new = [_plain(field.type, item) for item in _list(field, value)] if field.type.array else _plain(field.type, value)
        setattr(message, field.name, new)
    except (AssertionError, TypeError, ValueError, OverflowError) as error:
        raise FillError(str(error), None if 'help:' in str(error) else f"'{field.name}' is {field.type.text}") from None
    return found


def _dictionary(value: Any) -> dict[str, Any]:
    if not isinstance(value, dict):
        raise TypeError(f"Value '{value}' is expected to be a dictionary but is a {type(value).__name__}")
    return value


def _list(field: Field, value: Any) -> Any:
    if not isinstance(value, (list, tuple)):
        raise TypeError(f"Value '{value}' of '{field.name}' is expected to be a list but is a {type(value).__name__}")
    return value


def _plain(field_type: FieldType, value: Any) -> Any:
    """Return a number, string or boolean in the type of the field. For example, 2 becomes 2.0 in a float field."""
    kind = field_type.kind
    assert kind is not None
    if type(value) is kind.python:
        return value
    if isinstance(value, (dict, list)):
        raise TypeError(f"Value '{value}' is expected to be a {kind.name} but is a {type(value).__name__}")
    return bytes([value]) if kind.python is bytes else kind.python(value)


def interface_class(text: str, kind: str) -> Any:
    """Return the class of a type that the user names.

    :param text: the name, such as 'std_msgs/msg/String' or the short form 'std_msgs/String'.
    :param kind: 'msg', 'srv' or 'action'.
    :raises InterfaceError: when there is no such type. The help suggests the most similar name.
    """
    parts = text.split('/')
    if len(parts) == 2:
        parts.insert(1, kind)
    name = '/'.join(parts)
    if len(parts) != 3 or parts[1] != kind:
        raise InterfaceError(f'{text!r} is no {kind} type', help=f'write it as in {EXAMPLES[kind]}')
    return current_registry().get(name)

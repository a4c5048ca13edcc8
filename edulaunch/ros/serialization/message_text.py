"""Converts messages to YAML and CSV, as `ros2 topic echo` prints them."""

from __future__ import annotations

from typing import Any, NamedTuple

from edulaunch.engine.interfaces.message import Message, spec_of


class Shortening(NamedTuple):
    """The parts of a message that are left out.

    :ivar length: the maximum number of array items and characters of a string; None means no limit.
    :ivar no_arr: whether arrays are replaced by their type and length.
    :ivar no_str: whether strings are replaced by their type and length.
    """

    length: int | None = None
    no_arr: bool = False
    no_str: bool = False


EVERYTHING = Shortening()
WIDEST = 2**31 - 1


def message_yaml(message: Message, short: Shortening = EVERYTHING, *, flow_style: bool = False) -> str:
    """Return the message as a YAML string with its fields in order and a final line break."""
    import yaml

    content = message_dict(message, short)
    plain = repr(content)
    simple = plain.isascii() and '\\' not in plain
    # The C writer is faster, but it writes non-ASCII letters differently from ROS 2.
    dumper = getattr(yaml, 'CSafeDumper', yaml.SafeDumper) if simple else yaml.SafeDumper
    text: str = yaml.dump(
        content, Dumper=dumper, sort_keys=False, width=WIDEST, allow_unicode=True, default_flow_style=flow_style
    )
    return text


def message_csv(message: Message, short: Shortening = EVERYTHING) -> str:
    """Return all single values of the message, separated by commas."""
    return ','.join(_flat(message_dict(message, short)))


def message_dict(message: Message, short: Shortening = EVERYTHING) -> dict[str, Any]:
    """Return the message as plain dicts, lists, numbers and strings."""
    found: dict[str, Any] = {}
    for field in spec_of(message).fields:
        value = getattr(message, field.name)
        if field.type.array and short.no_arr:
            found[field.name] = f'<{field.type.ros_text}, length: {len(value)}>'
        elif field.type.array:
            found[field.name] = _list(value, short)
        else:
            found[field.name] = plain_value(value, short)
    return found


def _list(values: Any, short: Shortening) -> list[Any]:
    items = values.tolist() if hasattr(values, 'tolist') else list(values)
    cut = short.length is not None and len(items) > short.length
    shown = [plain_value(item, short) for item in (items[: short.length] if cut else items)]
    return [*shown, '...'] if cut else shown


def plain_value(value: Any, short: Shortening) -> Any:
    """Return the value of one field as plain data."""
    if isinstance(value, Message):
        return message_dict(value, short)
    if isinstance(value, bytes):
        return value[0] if len(value) == 1 else list(value)
    if isinstance(value, str):
        if short.no_str:
            return f'<string, length: <{len(value)}>>'
        return value if short.length is None or len(value) <= short.length else value[: short.length] + '...'
    return _list(value, short) if hasattr(value, 'tolist') else value


def _flat(value: Any) -> list[str]:
    if isinstance(value, dict):
        return [text for item in value.values() for text in _flat(item)]
    return [text for item in value for text in _flat(item)] if isinstance(value, list) else [str(value)]

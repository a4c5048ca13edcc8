"""The messages that a client of the Foxglove WebSocket protocol may send.

This module checks every message, and replies to an invalid message with an error message. A client may be hostile, so the size of
messages, the length of lists and the range of numbers are limited.
"""

from __future__ import annotations

import json
import math
import struct
from collections.abc import Callable
from typing import Any, NamedTuple, NoReturn

SDK, OLD = 'foxglove.sdk.v1', 'foxglove.websocket.v1'
SUBPROTOCOLS = (SDK, OLD)
LONGEST_MESSAGE = (1 << 20) - 64
"""The maximum number of bytes of one message of a client."""
MOST_ITEMS = 1000
"""The maximum number of entries of one list."""
LONGEST_TEXT = 512
"""The maximum number of characters of one name."""
FASTEST = 100.0
"""The highest speed of a recording, relative to real time."""
Value = bool | int | float | str | list[Any]


class ProtocolError(ValueError):
    """A client sent a message that it may not send. Users of the client read the error message."""


class Subscribe(NamedTuple):
    """A request for the messages of channels, as pairs (subscription, channel)."""

    pairs: tuple[tuple[int, int], ...]


class Unsubscribe(NamedTuple):
    """A request to end subscriptions."""

    ids: tuple[int, ...]


class ClientChannel(NamedTuple):
    """A topic on which a client publishes."""

    id: int
    topic: str
    encoding: str
    type: str


class Advertise(NamedTuple):
    """An announcement that the client will publish on these channels."""

    channels: tuple[ClientChannel, ...]


class Unadvertise(NamedTuple):
    """An announcement that the client stops publishing on these channels."""

    ids: tuple[int, ...]


class Publish(NamedTuple):
    """A message on a channel of the client."""

    channel: int
    data: bytes


class Call(NamedTuple):
    """A request to a service."""

    service: int
    number: int
    encoding: str
    data: bytes


class GetParameters(NamedTuple):
    """A request for the named parameters, or for all parameters if it has no names."""

    names: tuple[str, ...]
    request: str | None


class SetParameters(NamedTuple):
    """A request to set parameters, as (name, value, type). The type is 'float64', 'float64_array', 'byte_array' or None."""

    values: tuple[tuple[str, Value, str | None], ...]
    request: str | None


class WatchParameters(NamedTuple):
    """A request to start or stop sending the named parameters when they change. Without names, the request concerns all
    parameters.
    """

    names: tuple[str, ...]
    on: bool


class WatchGraph(NamedTuple):
    """A request to start or stop sending the graph of nodes, topics and services."""

    on: bool


class Playback(NamedTuple):
    """A request to play or pause a recording at a speed. If it contains a time, the recording first moves to this time."""

    plays: bool
    speed: float
    seek_ns: int | None
    request: str


class FetchAsset(NamedTuple):
    """A request for a file."""

    uri: str
    request: int


Request = (
    Subscribe
    | Unsubscribe
    | Advertise
    | Unadvertise
    | Publish
    | Call
    | GetParameters
    | SetParameters
    | WatchParameters
    | WatchGraph
    | Playback
    | FetchAsset
)


def parse(message: str | bytes) -> Request:
    """Return the parsed message of a client.

    :raises ProtocolError: when the client may not send the message.
    """
    if len(message) > LONGEST_MESSAGE:
        raise ProtocolError(f'a message may have at most {LONGEST_MESSAGE} bytes')
    return _words(message) if isinstance(message, str) else _binary(message)


# -- JSON


def _words(text: str) -> Request:
    try:
        fields = json.loads(text, parse_constant=_no_number)
    except (ValueError, RecursionError):
        raise ProtocolError('this message is not JSON') from None
    op = fields.get('op') if isinstance(fields, dict) else None
    read = _READERS.get(op) if isinstance(op, str) else None
    if read is None:
        raise ProtocolError(f'edulaunch does not know the operation {str(op)[:40]!r}')
    return read(fields)


def _no_number(word: str) -> NoReturn:
    raise ValueError(word)


def _several(fields: dict[str, Any], name: str) -> list[Any]:
    found = fields.get(name)
    if not isinstance(found, list) or len(found) > MOST_ITEMS:
        raise ProtocolError(f'{fields["op"]}: {name!r} has to be a list of at most {MOST_ITEMS} entries')
    return found


def _objects(fields: dict[str, Any], name: str) -> list[dict[str, Any]]:
    found = _several(fields, name)
    if not all(isinstance(one, dict) for one in found):
        raise ProtocolError(f'{fields["op"]}: each entry of {name!r} has to be an object')
    return [{**one, 'op': fields['op']} for one in found]


def _number(fields: dict[str, Any], name: str) -> int:
    return _checked_number(fields['op'], name, fields.get(name))


def _checked_number(op: str, name: str, value: Any) -> int:
    if isinstance(value, bool) or not isinstance(value, int) or not 0 <= value < 1 << 32:
        raise ProtocolError(f'{op}: {name!r} has to be a whole number of 32 bits')
    return value


def _numbers(fields: dict[str, Any], name: str) -> tuple[int, ...]:
    return tuple(_checked_number(fields['op'], name, one) for one in _several(fields, name))


def _text(fields: dict[str, Any], name: str) -> str:
    return _checked_text(fields['op'], name, fields.get(name))


def _checked_text(op: str, name: str, value: Any) -> str:
    if not isinstance(value, str) or len(value) > LONGEST_TEXT:
        raise ProtocolError(f'{op}: {name!r} has to be a string of at most {LONGEST_TEXT} characters')
    return _unicode(op, value)


def _unicode(op: str, value: str) -> str:
    """Return a string that UTF-8 can represent. Strings in JSON may contain lone surrogates, which UTF-8 cannot represent."""
    try:
        value.encode()
    except UnicodeEncodeError:
        raise ProtocolError(f'{op}: a string has half of a surrogate pair') from None
    return value


def _texts(fields: dict[str, Any], name: str) -> tuple[str, ...]:
    return tuple(_checked_text(fields['op'], name, one) for one in _several(fields, name))


def _optional_text(fields: dict[str, Any], name: str) -> str | None:
    return None if fields.get(name) is None else _text(fields, name)


def _subscribe(fields: dict[str, Any]) -> Subscribe:
    return Subscribe(tuple((_number(one, 'id'), _number(one, 'channelId')) for one in _objects(fields, 'subscriptions')))


def _advertise(fields: dict[str, Any]) -> Advertise:
    channels = [
        ClientChannel(_number(one, 'id'), *(_text(one, name) for name in ('topic', 'encoding', 'schemaName')))
        for one in _objects(fields, 'channels')
    ]
    return Advertise(tuple(channels))


def _set_parameters(fields: dict[str, Any]) -> SetParameters:
    values = [
        (_text(one, 'name'), _value(one.get('value')), _optional_text(one, 'type')) for one in _objects(fields, 'parameters')
    ]
    return SetParameters(tuple(values), _optional_text(fields, 'id'))


def _value(value: Any) -> Value:
    """Return the value if a parameter can have it."""
    if isinstance(value, list):
        if any(isinstance(one, list) for one in value):
            raise ProtocolError('setParameters: a parameter of ROS 2 has no lists inside lists')
        return [_value(one) for one in value]
    if isinstance(value, float) and not math.isfinite(value):
        raise ProtocolError('setParameters: a number is too large')
    if isinstance(value, str):
        return _unicode('setParameters', value)
    if isinstance(value, (bool, int, float)):
        return value
    raise ProtocolError('setParameters: a value has to be a bool, a number, a string, or a list of those')


_READERS: dict[str, Callable[[dict[str, Any]], Request]] = {
    'subscribe': _subscribe,
    'unsubscribe': lambda fields: Unsubscribe(_numbers(fields, 'subscriptionIds')),
    'advertise': _advertise,
    'unadvertise': lambda fields: Unadvertise(_numbers(fields, 'channelIds')),
    'getParameters': lambda fields: GetParameters(_texts(fields, 'parameterNames'), _optional_text(fields, 'id')),
    'setParameters': _set_parameters,
    'subscribeParameterUpdates': lambda fields: WatchParameters(_texts(fields, 'parameterNames'), True),
    'unsubscribeParameterUpdates': lambda fields: WatchParameters(_texts(fields, 'parameterNames'), False),
    'subscribeConnectionGraph': lambda fields: WatchGraph(True),
    'unsubscribeConnectionGraph': lambda fields: WatchGraph(False),
    'fetchAsset': lambda fields: FetchAsset(_text(fields, 'uri'), _number(fields, 'requestId')),
}


# -- bytes


def _binary(data: bytes) -> Request:
    try:
        return _BINARY[data[0]](data)
    except (struct.error, UnicodeDecodeError, ValueError) as error:
        if isinstance(error, ProtocolError):
            raise
        raise ProtocolError(
            'a binary message is shorter than its length field says, or contains a string that is not UTF-8'
        ) from None
    except (IndexError, KeyError):
        raise ProtocolError(f'edulaunch does not know binary messages of the kind {data[:1].hex() or "(nothing)"}') from None


def _publish(data: bytes) -> Publish:
    (channel,) = struct.unpack_from('<I', data, 1)
    return Publish(channel, data[5:])


def _call(data: bytes) -> Call:
    service, number, length = struct.unpack_from('<III', data, 1)
    return Call(service, number, _counted(data, 13, length), data[13 + length :])


def _playback(data: bytes) -> Playback:
    command, speed, has_seek, seek_ns, length = struct.unpack_from('<BfBQI', data, 1)
    if command not in (0, 1):
        raise ProtocolError('a recording can play (0) or pause (1)')
    if not 0 < speed <= FASTEST:
        raise ProtocolError(f'the speed of a recording has to be above 0 and at most {FASTEST:g}')
    return Playback(command == 0, speed, seek_ns if has_seek else None, _counted(data, 19, length))


def _counted(data: bytes, begin: int, length: int) -> str:
    if begin + length > len(data):
        raise ProtocolError('a binary message is shorter than its length field says')
    return _checked_text('a binary message', 'text', data[begin : begin + length].decode())


_BINARY: dict[int, Callable[[bytes], Request]] = {1: _publish, 2: _call, 3: _playback}

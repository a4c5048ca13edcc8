"""The messages that a server of the Foxglove WebSocket protocol sends. Strings are JSON, and bytes are little-endian."""

from __future__ import annotations

import json
import math
import struct
from base64 import b64encode
from collections.abc import Mapping, Sequence
from typing import Any

Message = str | bytes
Graph = Mapping[str, Mapping[str, Sequence[str]]]
INFO, WARNING, ERROR = range(3)
"""The levels of a status."""
PLAYING, PAUSED, ENDED = 0, 1, 3
"""The states of a recording."""


def op(operation: str, /, **fields: Any) -> str:
    """Return a message of the protocol as a JSON string."""
    return json.dumps({'op': operation, **fields}, separators=(',', ':'))


def status(level: int, text: str, number: str | None = None) -> str:
    """Return the message that shows a sentence to the user.

    :param number: the number of the sentence. A new sentence replaces an older sentence with the same number.
    """
    return op('status', level=level, message=text, **({} if number is None else {'id': number}))


def data(subscription: int, time_ns: int, cdr: bytes) -> bytes:
    """Return the frame for a message of a topic."""
    return struct.pack('<BIQ', 1, subscription, time_ns) + cdr


def time(now_ns: int) -> bytes:
    """Return the frame with the time of the machine."""
    return struct.pack('<BQ', 2, now_ns)


def response(service: int, number: int, cdr: bytes) -> bytes:
    """Return the frame for the reply of a service."""
    return struct.pack('<BIII', 3, service, number, 3) + b'cdr' + cdr


def no_asset(request: int, why: str) -> bytes:
    """Return the reply to a request for a file that is not available."""
    text = why.encode()
    return struct.pack('<BIBI', 4, request, 1, len(text)) + text


def playback(state: int, now_ns: int, speed: float, did_seek: bool = False, request: str = '') -> bytes:
    """Return the message with the state of a played recording.

    :param request: the identifier of the request that caused the message.
    """
    text = request.encode()
    return struct.pack('<BBQfBI', 5, state, now_ns, speed, did_seek, len(text)) + text


def parameters(values: Mapping[str, Any], request: str | None = None) -> str:
    """Return the message with the values of parameters by name."""
    rows = [_parameter(name, value) for name, value in values.items()]
    return op('parameterValues', parameters=rows, **({} if request is None else {'id': request}))


def _parameter(name: str, value: Any) -> dict[str, Any]:
    if isinstance(value, (list, tuple)) and value and all(isinstance(one, bytes) for one in value):
        return {'name': name, 'value': b64encode(b''.join(value)).decode(), 'type': 'byte_array'}
    if isinstance(value, bytes):
        return {'name': name, 'value': b64encode(value).decode(), 'type': 'byte_array'}
    plain = list(value) if isinstance(value, (list, tuple)) else value
    several = plain if isinstance(plain, list) else [plain]
    if not several or not all(isinstance(one, float) for one in several):
        return {'name': name, 'value': plain}
    if not all(map(math.isfinite, several)):
        return {'name': name, 'value': str(plain)}  # JSON has neither NaN nor infinity
    return {'name': name, 'value': plain, 'type': 'float64' if plain is not several else 'float64_array'}


def graph_update(now: Graph, before: Graph | None) -> str | None:
    """Return the message with the differences between two graphs: 'published', 'subscribed' and 'served', each with nodes by
    name. Return None if the graphs are equal.

    :param before: the graph that the client has, or None.
    """
    is_first, before = before is None, before or {}
    parts = (
        ('published', 'publishedTopics', 'publisherIds'),
        ('subscribed', 'subscribedTopics', 'subscriberIds'),
        ('served', 'advertisedServices', 'providerIds'),
    )
    fields: dict[str, Any] = {}
    for part, field, ids in parts:
        old = before.get(part, {})
        fields[field] = [{'name': name, ids: list(who)} for name, who in now[part].items() if old.get(name) != who]
    topics_before = {**before.get('published', {}), **before.get('subscribed', {})}
    gone = [name for name in topics_before if name not in now['published'] and name not in now['subscribed']]
    for part, field, ids in parts[:2]:  # these topics lost all publishers or all subscribers, but not both
        lost = [name for name in before.get(part, {}) if name not in now[part] and name not in gone]
        fields[field] += [{'name': name, ids: []} for name in lost]
    fields['removedTopics'] = gone
    fields['removedServices'] = [name for name in before.get('served', {}) if name not in now['served']]
    return op('connectionGraphUpdate', **fields) if is_first or any(fields.values()) else None

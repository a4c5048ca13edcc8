"""Bytes and JSON of the messages that a server sends."""

from __future__ import annotations

import json
import math
from typing import Any

import pytest

from edulaunch.extras.foxglove import server_messages as sent


@pytest.mark.parametrize(
    ('message', 'data'),
    [
        (sent.data(3, 258, b'xy'), '0103000000 0201000000000000 7879'),
        (sent.time(258), '02 0201000000000000'),
        (sent.response(1, 2, b'x'), '03 01000000 02000000 03000000 636472 78'),
        (sent.no_asset(5, 'no'), '04 05000000 01 02000000 6e6f'),
        (sent.playback(1, 2, 0.5), '05 01 0200000000000000 0000003f 00 00000000'),
        (sent.playback(sent.ENDED, 2, 1.0, True, 'r'), '05 03 0200000000000000 0000803f 01 01000000 72'),
    ],
)
def test_binary_messages(message: bytes, data: str) -> None:
    assert message == bytes.fromhex(data)


def test_a_status_may_have_a_number() -> None:
    assert json.loads(sent.status(sent.WARNING, 'x')) == {'op': 'status', 'level': 1, 'message': 'x'}
    assert json.loads(sent.status(sent.ERROR, 'x', 'n')) == {'op': 'status', 'level': 2, 'message': 'x', 'id': 'n'}
    assert (sent.INFO, sent.PLAYING, sent.PAUSED) == (0, 0, 1)


@pytest.mark.parametrize(
    ('value', 'row'),
    [
        (1, {'value': 1}),
        (True, {'value': True}),
        ('a', {'value': 'a'}),
        (1.5, {'value': 1.5, 'type': 'float64'}),
        (math.nan, {'value': 'nan'}),
        ([1.0, 2.5], {'value': [1.0, 2.5], 'type': 'float64_array'}),
        ((1.0,), {'value': [1.0], 'type': 'float64_array'}),
        ([1.0, math.inf], {'value': '[1.0, inf]'}),
        ([1, 2.5], {'value': [1, 2.5]}),
        ([], {'value': []}),
        (['a'], {'value': ['a']}),
        (b'ab', {'value': 'YWI=', 'type': 'byte_array'}),
        ([b'a', b'b'], {'value': 'YWI=', 'type': 'byte_array'}),
        (None, {'value': None}),
    ],
)
def test_parameters_have_a_type_where_json_has_none(value: Any, row: dict[str, Any]) -> None:
    assert json.loads(sent.parameters({'p': value})) == {'op': 'parameterValues', 'parameters': [{'name': 'p', **row}]}
    assert json.loads(sent.parameters({}, 'r'))['id'] == 'r'


def graph(published: Any = (), subscribed: Any = (), served: Any = ()) -> Any:
    return {'published': dict(published), 'subscribed': dict(subscribed), 'served': dict(served)}


NOTHING = {'publishedTopics': [], 'subscribedTopics': [], 'advertisedServices': [], 'removedTopics': [], 'removedServices': []}
A = {'/a': ['/n']}


@pytest.mark.parametrize(
    ('before', 'now', 'update'),
    [
        (None, graph(), {}),
        (graph(), graph(), None),
        (graph(A), graph(A), None),
        (None, graph(A), {'publishedTopics': [{'name': '/a', 'publisherIds': ['/n']}]}),
        (graph(A), graph({'/a': ['/n', '/m']}), {'publishedTopics': [{'name': '/a', 'publisherIds': ['/n', '/m']}]}),
        (graph(A), graph(), {'removedTopics': ['/a']}),
        (graph(A, A), graph(subscribed=A), {'publishedTopics': [{'name': '/a', 'publisherIds': []}]}),
        (graph(A, A), graph(A), {'subscribedTopics': [{'name': '/a', 'subscriberIds': []}]}),
        (graph(A, A), graph(), {'removedTopics': ['/a']}),
        (graph(), graph(served=A), {'advertisedServices': [{'name': '/a', 'providerIds': ['/n']}]}),
        (graph(served=A), graph(), {'removedServices': ['/a']}),
    ],
)
def test_an_update_of_the_graph_has_what_changed(before: Any, now: Any, update: dict[str, Any] | None) -> None:
    found = sent.graph_update(now, before)
    expected = None if update is None else {'op': 'connectionGraphUpdate', **NOTHING, **update}
    assert (None if found is None else json.loads(found)) == expected

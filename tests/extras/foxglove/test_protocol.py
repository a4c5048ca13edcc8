"""What clients may say: the parser reads each message, or refuses it with an error message. Nothing else ever happens."""

from __future__ import annotations

import json
import struct
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.extras.foxglove import protocol
from edulaunch.extras.foxglove.protocol import LONGEST_MESSAGE, MOST_ITEMS, ProtocolError, parse

PLAY = struct.pack('<BBfBQI', 3, 0, 2.0, 1, 5, 1) + b'x'
CALL = struct.pack('<BIII', 2, 7, 8, 3) + b'cdr' + b'\x00\x01\x00\x00'
GOOD: list[tuple[str | bytes, Any]] = [
    ('{"op":"subscribe","subscriptions":[{"id":1,"channelId":2}]}', protocol.Subscribe(((1, 2),))),
    ('{"op":"unsubscribe","subscriptionIds":[1]}', protocol.Unsubscribe((1,))),
    (
        '{"op":"advertise","channels":[{"id":1,"topic":"/t","encoding":"cdr","schemaName":"a/msg/B"}]}',
        protocol.Advertise((protocol.ClientChannel(1, '/t', 'cdr', 'a/msg/B'),)),
    ),
    ('{"op":"unadvertise","channelIds":[1]}', protocol.Unadvertise((1,))),
    ('{"op":"getParameters","parameterNames":["/a.b"],"id":"q"}', protocol.GetParameters(('/a.b',), 'q')),
    (
        '{"op":"setParameters","parameters":[{"name":"/a.b","value":[1.5],"type":"float64_array"}]}',
        protocol.SetParameters((('/a.b', [1.5], 'float64_array'),), None),
    ),
    ('{"op":"subscribeParameterUpdates","parameterNames":[]}', protocol.WatchParameters((), True)),
    ('{"op":"unsubscribeParameterUpdates","parameterNames":["x"]}', protocol.WatchParameters(('x',), False)),
    ('{"op":"subscribeConnectionGraph"}', protocol.WatchGraph(True)),
    ('{"op":"unsubscribeConnectionGraph"}', protocol.WatchGraph(False)),
    ('{"op":"fetchAsset","uri":"package://a/b","requestId":3}', protocol.FetchAsset('package://a/b', 3)),
    (b'\x01\x05\x00\x00\x00abc', protocol.Publish(5, b'abc')),
    (CALL, protocol.Call(7, 8, 'cdr', b'\x00\x01\x00\x00')),
    (PLAY, protocol.Playback(True, 2.0, 5, 'x')),
]
BAD: list[tuple[str | bytes, str]] = [
    ('', 'this message is not JSON'),
    ('[' * 100_000, 'this message is not JSON'),
    ('[]', "edulaunch does not know the operation 'None'"),
    ('{"op":["subscribe"]}', 'edulaunch does not know the operation "[\'subscribe\']"'),
    ('{"op":"reboot"}', "edulaunch does not know the operation 'reboot'"),
    ('{"op":"subscribe"}', "subscribe: 'subscriptions' has to be a list of at most 1000 entries"),
    ('{"op":"subscribe","subscriptions":[1]}', "subscribe: each entry of 'subscriptions' has to be an object"),
    ('{"op":"unsubscribe","subscriptionIds":[-1]}', "unsubscribe: 'subscriptionIds' has to be a whole number of 32 bits"),
    ('{"op":"unsubscribe","subscriptionIds":[true]}', "unsubscribe: 'subscriptionIds' has to be a whole number of 32 bits"),
    ('{"op":"fetchAsset","uri":5,"requestId":3}', "fetchAsset: 'uri' has to be a string of at most 512 characters"),
    ('{"op":"setParameters","parameters":[{"name":"a","value":NaN}]}', 'this message is not JSON'),
    ('{"op":"setParameters","parameters":[{"name":"a","value":1e999}]}', 'setParameters: a number is too large'),
    (r'{"op":"getParameters","parameterNames":["\ud800"]}', 'getParameters: a string has half of a surrogate pair'),
    (
        r'{"op":"setParameters","parameters":[{"name":"a","value":["\ud800"]}]}',
        'setParameters: a string has half of a surrogate pair',
    ),
    (
        '{"op":"setParameters","parameters":[{"name":"a","value":[[1]]}]}',
        'setParameters: a parameter of ROS 2 has no lists inside lists',
    ),
    (
        '{"op":"setParameters","parameters":[{"name":"a","value":{}}]}',
        'setParameters: a value has to be a bool, a number, a string, or a list of those',
    ),
    (b'', 'edulaunch does not know binary messages of the kind (nothing)'),
    (b'\x09', 'edulaunch does not know binary messages of the kind 09'),
    (b'\x01\x05', 'a binary message is shorter than its length field says, or contains a string that is not UTF-8'),
    (struct.pack('<BIII', 2, 7, 8, 4_000_000_000), 'a binary message is shorter than its length field says'),
    (
        struct.pack('<BIII', 2, 7, 8, 1) + b'\xff',
        'a binary message is shorter than its length field says, or contains a string that is not UTF-8',
    ),
    (struct.pack('<BBfBQI', 3, 7, 1.0, 0, 0, 0), 'a recording can play (0) or pause (1)'),
    (struct.pack('<BBfBQI', 3, 0, float('nan'), 0, 0, 0), 'the speed of a recording has to be above 0 and at most 100'),
]


@pytest.mark.parametrize(('message', 'request_'), GOOD, ids=[type(good[1]).__name__ for good in GOOD])
def test_what_clients_may_say_is_read(message: str | bytes, request_: Any) -> None:
    assert parse(message) == request_


@pytest.mark.parametrize(('message', 'sentence'), BAD, ids=range(len(BAD)))
def test_what_they_may_not_say_is_refused_with_a_sentence(message: str | bytes, sentence: str) -> None:
    with pytest.raises(ProtocolError) as refused:
        parse(message)
    assert str(refused.value) == sentence


def test_sizes_are_limited() -> None:
    many = json.dumps({'op': 'unsubscribe', 'subscriptionIds': list(range(MOST_ITEMS + 1))})
    for message in (many, b'\x01' * (LONGEST_MESSAGE + 1), ' ' * (LONGEST_MESSAGE + 1)):
        with pytest.raises(ProtocolError):
            parse(message)
    assert parse(b'\x01' * LONGEST_MESSAGE) == protocol.Publish(0x01010101, b'\x01' * (LONGEST_MESSAGE - 5))


def read_or_refused(message: str | bytes) -> bool:
    """Whether a message was read. Any exception but the one that has a sentence fails the test."""
    try:
        parse(message)
    except ProtocolError as error:
        assert str(error)
        return False
    return True


plain = st.recursive(
    st.none() | st.booleans() | st.integers() | st.floats() | st.text(max_size=8),
    lambda inner: st.lists(inner, max_size=4) | st.dictionaries(st.text(max_size=8), inner, max_size=4),
    max_leaves=8,
)


@given(st.binary(max_size=80))
def test_any_bytes_are_read_or_refused(data: bytes) -> None:
    read_or_refused(data)


@given(st.text(max_size=80))
def test_any_text_is_read_or_refused(text: str) -> None:
    read_or_refused(text)


@given(st.sampled_from([good[0] for good in GOOD if isinstance(good[0], str)]), st.data())
def test_any_operation_with_anything_in_its_fields_is_read_or_refused(message: str, data: st.DataObject) -> None:
    said = json.loads(message)
    name = data.draw(st.sampled_from(sorted(said)))
    inner = said[name][0] if isinstance(said[name], list) and said[name] and isinstance(said[name][0], dict) else said
    inner[data.draw(st.sampled_from(sorted(inner)))] = data.draw(plain)
    read_or_refused(json.dumps(said))


@given(st.sampled_from([good[0] for good in GOOD if isinstance(good[0], bytes)]), st.data())
def test_good_bytes_with_one_changed_or_cut_off_are_read_or_refused(message: bytes, data: st.DataObject) -> None:
    place = data.draw(st.integers(0, len(message) - 1))
    read_or_refused(message[:place] + bytes([data.draw(st.integers(0, 255))]) + message[place + 1 :])
    read_or_refused(message[:place])

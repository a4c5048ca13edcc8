"""What one client of the Foxglove protocol is told, and what its requests do, with a feed of the test."""

from __future__ import annotations

import json
import struct
from collections.abc import Iterator
from typing import Any

import pytest
from std_msgs.msg import String
from std_srvs.srv import SetBool

from edulaunch.engine.interfaces import current_registry
from edulaunch.extras.foxglove import conversation, protocol, server_messages
from edulaunch.extras.foxglove.conversation import MOST_BYTES, MOST_WAITING, Conversation, TooMuch
from edulaunch.extras.foxglove.feed import Refused, Topic
from edulaunch.ros.serialization.cdr import decode, encode

TEXT = 'std_msgs/msg/String'


def topic(name: str, kind: str = TEXT, cls: Any = String) -> Topic:
    return Topic(name, kind, cls, current_registry())


class Fed:
    """A feed whose answers the test sets."""

    name, capabilities = 'test', ('time',)

    def __init__(self) -> None:
        self.at, self.state, self.here, self.served = 5, 'one', [topic('/a')], list[Topic]()
        self.count, self.log, self.new, self.last, self.values = 0, list[Any](), list[Any](), list[Any](), dict[str, Any]()
        self.shown: Any = {'published': {}, 'subscribed': {}, 'served': {}}
        self.lost = 0

    def __getattr__(self, name: str) -> Any:
        answers = {
            'session': self.__dict__['state'],
            'details': {},
            'now_ns': self.__dict__['at'],
            'version': self.__dict__['count'],
            'topics': self.__dict__['here'],
            'services': self.__dict__['served'],
            'advance': [],
            'graph': self.__dict__['shown'],
            'parameters': self.__dict__['values'],
            'parameter_version': self.__dict__['count'],
            'kept': self.__dict__['last'],
            'end': 7,
        }
        return lambda *given: answers[name]

    def rows(self, key: Any, cursor: int, most: int) -> Any:
        assert (key, most) == (('/a', TEXT), conversation.MOST_ROWS)
        found, self.new = self.new, []
        return found, cursor + len(found), self.lost

    def advertise(self, *given: Any) -> Any:
        self.log.append(given)
        return self.log.append

    def retire(self, publish: Any) -> None:
        self.log.append('retired')

    def call(self, service: Topic, data: bytes, answer: Any) -> None:
        if data == b'no':
            raise Refused('not now')
        answer(data * 2)

    def set(self, values: Any, answer: Any) -> None:
        self.values = {name: value for name, value, _ in values}
        answer('one is wrong' if 'wrong' in self.values else '')

    def play(self, request: Any) -> Any:
        return b'state', request.seek_ns is not None

    def close(self) -> None:
        self.log.append('closed')


@pytest.fixture
def requests(monkeypatch: pytest.MonkeyPatch) -> Iterator[None]:
    """A message is its request here: reading bytes is tested elsewhere."""
    monkeypatch.setattr(protocol, 'parse', lambda message: message)
    yield


def begun() -> tuple[Fed, Conversation, list[Any]]:
    feed = Fed()
    one = Conversation(feed)  # type: ignore[arg-type]
    return feed, one, seen(one.turn())


def seen(messages: Any) -> list[Any]:
    return [json.loads(message) if isinstance(message, str) else message for message in messages]


def test_a_client_is_told_what_there_is() -> None:
    _, one, told = begun()
    assert [message['op'] for message in told[:2]] == ['serverInfo', 'advertise']
    assert (told[0]['name'], told[0]['capabilities'], told[0]['sessionId']) == ('test', ['time'], 'one')
    (channel,) = told[1]['channels']
    assert {**channel, 'schema': ''} == {
        'id': 1,
        'topic': '/a',
        'encoding': 'cdr',
        'schemaName': TEXT,
        'schema': '',
        'schemaEncoding': 'ros2msg',
    }
    assert 'string data' in channel['schema']
    assert told[2:] == [server_messages.time(5)]
    assert one.turn() == []


def test_changes_are_told_once(requests: None) -> None:
    feed, one, _ = begun()
    one.take(protocol.Subscribe(((3, 1),)))
    feed.count, feed.here, feed.served = (
        1,
        [topic('/b'), topic('/c', 'no_such/msg/X')],
        [topic('/s', 'std_srvs/srv/SetBool', SetBool)],
    )
    told = seen(one.turn())
    assert [message['op'] for message in told] == ['unadvertise', 'advertise', 'advertiseServices']
    assert told[0]['channelIds'] == [1]
    assert [channel['topic'] for channel in told[1]['channels']] == ['/b']
    (service,) = told[2]['services']
    assert (service['name'], service['request']['schemaName'], service['response']['encoding']) == (
        '/s',
        'std_srvs/srv/SetBool_Request',
        'cdr',
    )
    feed.new = [(1, ('x',))]
    assert one.turn() == []  # the topic is gone, and with it what was subscribed
    feed.at, feed.state = 6, 'two'
    assert [message['op'] for message in seen(one.turn())[:-1]] == ['serverInfo', 'advertise', 'advertiseServices']


def frames(messages: Any) -> list[Any]:
    return [(*struct.unpack('<BIQ', message[:13]), decode(String, message[13:])) for message in messages if message[:1] == b'\1']


def test_messages_come_by_subscription_in_their_order(requests: None) -> None:
    feed, one, _ = begun()
    feed.last = [(2, ('kept',))]
    one.take(protocol.Subscribe(((3, 1),)))
    feed.new = [(4, ('x',)), (5, ('y',))]
    assert frames(one.turn()) == [(1, 3, 2, ('kept',)), (1, 3, 4, ('x',)), (1, 3, 5, ('y',))]
    one.take(protocol.Unsubscribe((3, 9)))
    feed.new = [(6, ('z',))]
    assert frames(one.turn()) == []


def test_what_does_not_fit_is_left_out_and_counted(requests: None) -> None:
    feed, one, _ = begun()
    one.take(protocol.Subscribe(((3, 1),)))
    half = 'x' * (MOST_BYTES // 2 - 20)
    feed.new, feed.lost = [(1, ('old',)), (2, (half,)), (3, (half,)), (4, ('new',))], 2
    heard = one.turn()
    assert [time for _, _, time, _ in frames(heard)] == [2, 3, 4]
    (told,) = (message for message in seen(heard) if isinstance(message, dict))
    assert (told['level'], told['id']) == (server_messages.WARNING, 'lost /a')
    assert told['message'] == '3 messages of /a were left out: this client or the network is too slow'
    feed.lost = 4
    assert seen(one.turn())[0]['message'].startswith('7 messages of /a')


@pytest.mark.parametrize(
    ('request_', 'error'),
    [
        (protocol.Subscribe(((3, 9),)), 'subscribe: channel 9 is no channel of this server'),
        (protocol.Subscribe(((3, 1), (3, 1))), 'subscribe: channel 1 is subscribed already, or there are too many'),
        (protocol.Publish(4, b'x'), 'this client has no channel 4: advertise it first'),
        (
            protocol.Advertise((protocol.ClientChannel(1, '/x', 'xml', TEXT),)),
            "/x: edulaunch takes messages in cdr or json, not in 'xml'",
        ),
        (
            protocol.Advertise((protocol.ClientChannel(1, '/x', 'cdr', TEXT),) * 2),
            '/x: channel 1 already exists, or the client has too many channels',
        ),
        (
            protocol.WatchParameters(tuple(map(str, range(1001))), True),
            'a client may watch at most 1000 parameters by name, or all of them',
        ),
    ],
)
def test_what_is_refused_is_told(requests: None, request_: Any, error: str) -> None:
    _, one, _ = begun()
    one.take(request_)
    (told,) = seen(one.turn())
    assert (told['op'], told['level'], told['message']) == ('status', server_messages.ERROR, error)


def test_a_client_publishes_on_channels_of_its_own(requests: None) -> None:
    feed, one, _ = begun()
    for request in (
        protocol.Advertise((protocol.ClientChannel(4, '/x', 'json', TEXT),)),
        protocol.Publish(4, b'm'),
        protocol.Unadvertise((4, 5)),
        protocol.Publish(4, b'late'),
    ):
        one.take(request)
    assert feed.log == [('/x', TEXT, 'json'), b'm', 'retired']
    one.close()
    assert feed.log[-1] == 'closed'


def test_a_service_is_called(requests: None) -> None:
    feed, one, _ = begun()
    feed.count, feed.served = 1, [topic('/s', 'std_srvs/srv/SetBool', SetBool)]
    (told,) = seen(one.turn())
    number = told['services'][0]['id']
    for service, encoding, data in ((number, 'cdr', b'r'), (number, 'cdr', b'no'), (number, 'json', b'r'), (99, 'cdr', b'r')):
        one.take(protocol.Call(service, 8, encoding, data))
    answers = seen(one.turn())
    assert answers[0] == server_messages.response(number, 8, b'rr')
    assert [answer['op'] for answer in answers[1:]] == ['serviceCallFailure'] * 3
    assert [(answer['serviceId'], answer['callId'], answer['message']) for answer in answers[1:]] == [
        (number, 8, 'not now'),
        (number, 8, "/s: edulaunch takes requests in cdr, not in 'json'"),
        (99, 8, 'this server has no service 99'),
    ]


def values_of(messages: list[Any]) -> list[Any]:
    return [
        {row['name']: row['value'] for row in message['parameters']} if 'parameters' in message else message['message']
        for message in messages
    ]


def test_parameters_are_read_set_and_watched(requests: None) -> None:
    feed, one, _ = begun()
    feed.values = {'a': 1, 'b': 2}
    one.take(protocol.GetParameters((), None))
    one.take(protocol.GetParameters(('b', 'c'), 'r'))
    told = seen(one.turn())
    assert (values_of(told), told[1]['id'], 'id' in told[0]) == ([{'a': 1, 'b': 2}, {'b': 2}], 'r', False)
    one.take(protocol.WatchParameters(('b',), True))
    assert values_of(seen(one.turn())) == [{'b': 2}]
    feed.count, feed.values = 1, {'a': 5, 'b': 2}
    assert one.turn() == []
    one.take(protocol.WatchParameters((), True))
    assert values_of(seen(one.turn())) == [{'a': 5}]
    feed.count, feed.values = 2, {'a': 6, 'b': 7}
    assert values_of(seen(one.turn())) == [{'a': 6, 'b': 7}]
    one.take(protocol.WatchParameters((), False))
    feed.count, feed.values = 3, {'a': 8}
    assert one.turn() == []
    one.take(protocol.WatchParameters(('a', 'b'), True))
    one.take(protocol.WatchParameters(('a',), False))
    assert one.turn() == []
    one.take(protocol.SetParameters((('wrong', 3, None),), 's'))
    assert values_of(seen(one.turn())) == ['one is wrong', {'wrong': 3}]


def test_the_graph_is_told_while_it_is_watched(requests: None) -> None:
    feed, one, _ = begun()
    feed.shown = {'published': {'/a': ['/n']}, 'subscribed': {}, 'served': {}}
    assert one.turn() == []
    one.take(protocol.WatchGraph(True))
    (told,) = seen(one.turn())
    assert told['publishedTopics'] == [{'name': '/a', 'publisherIds': ['/n']}]
    feed.count = 1
    assert one.turn() == []
    feed.count, feed.shown = 2, {'published': {}, 'subscribed': {}, 'served': {}}
    (told,) = seen(one.turn())
    assert told['removedTopics'] == ['/a']
    one.take(protocol.WatchGraph(False))
    feed.count, feed.shown = 3, {'published': {'/b': ['/n']}, 'subscribed': {}, 'served': {}}
    assert one.turn() == []


def test_a_jump_in_time_shows_what_was_kept(requests: None) -> None:
    feed, one, _ = begun()
    one.take(protocol.Subscribe(((3, 1),)))
    feed.last = [(2, ('kept',))]
    one.take(protocol.Playback(True, 1.0, None, ''))
    assert one.turn() == [b'state']
    one.take(protocol.Playback(True, 1.0, 3, ''))
    told = one.turn()
    assert (told[0], frames(told[1:])) == (b'state', [(1, 3, 2, ('kept',))])


def test_files_are_not_served(requests: None) -> None:
    _, one, _ = begun()
    one.take(protocol.FetchAsset('package://a', 6))
    assert one.turn() == [server_messages.no_asset(6, 'edulaunch serves no files')]


def test_a_client_that_does_not_read_ends(requests: None) -> None:
    feed, one, _ = begun()
    feed.last = [(0, ('x' * (MOST_WAITING // 2),))]
    one.take(protocol.Subscribe(((3, 1), (4, 1), (5, 1))))
    with pytest.raises(TooMuch):
        one.take(protocol.Unsubscribe(()))
    assert len(frames(one.turn())) == 1
    one.take(protocol.Unsubscribe((3, 4)))


def test_cdr_is_what_is_sent() -> None:
    assert encode(String, ('x',))[:4] == b'\0\1\0\0'

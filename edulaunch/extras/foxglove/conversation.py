"""The server's state for one client: the client's subscriptions and publications, and the messages that the server sends.

A slow client receives messages less often. The server then leaves out old messages, and counts them. The queue of replies is
limited.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any

from edulaunch.desk.cli.ros2.bag_write import definition
from edulaunch.errors import InterfaceError
from edulaunch.extras.foxglove import protocol, server_messages
from edulaunch.extras.foxglove.feed import Feed, Key, Refused, Topic
from edulaunch.extras.foxglove.server_messages import Message
from edulaunch.ros.serialization.cdr import encode

MOST_ROWS = 500
"""The maximum number of messages of one topic in one turn."""
MOST_BYTES = 12 << 20
"""The maximum number of bytes of messages in one turn."""
MOST_WAITING = 4 << 20
"""The maximum number of bytes of waiting replies. A client that sends more requests without reading is disconnected."""
MOST_CHANNELS = 1000
"""The maximum number of subscriptions of one client, and of topics on which it publishes."""
ENCODING, SCHEMA = 'cdr', 'ros2msg'
PUBLISHED = (ENCODING, 'json')
"""The encodings of the messages that a client publishes."""


class TooMuch(ValueError):
    """The client sends requests faster than it reads the replies."""


class Conversation:
    """Handles the messages of a client, and returns the messages for the client in each turn."""

    def __init__(self, feed: Feed) -> None:
        self._feed = feed
        self._actions: dict[type, Callable[[Any], object]] = {
            protocol.Subscribe: self._subscribe,
            protocol.Unsubscribe: self._unsubscribe,
            protocol.Advertise: self._advertise,
            protocol.Unadvertise: self._unadvertise,
            protocol.Publish: self._publish,
            protocol.Call: self._call,
            protocol.GetParameters: self._get_parameters,
            protocol.SetParameters: self._set_parameters,
            protocol.WatchParameters: self._watch_parameters,
            protocol.WatchGraph: self._watch_graph,
            protocol.Playback: self._play,
            protocol.FetchAsset: self._fetch_asset,
        }
        self._publishers: dict[int, Callable[[bytes], object]] = {}
        self._waiting: list[Message] = []
        self._waiting_bytes = self._number = 0
        self._begin()

    def _begin(self) -> None:
        """Send the first messages of a session. They replace all data that the client has from an earlier session."""
        feed = self._feed
        self._session = feed.session()
        self._version: object = None
        self._channels: dict[int, Topic] = {}
        self._services: dict[int, Topic] = {}
        self._subscribed: dict[int, tuple[int, Key]] = {}
        self._cursors: dict[int, int] = {}
        self._lost: dict[str, int] = {}
        self._graph: Any = None
        self._watches_graph = False
        self._graph_version: object = None
        self._watched: set[str] | None = set()
        self._values: dict[str, Any] = {}
        self._values_version: object = None
        self._time_ns: int | None = None
        self._publishers.clear()
        self._say(
            server_messages.op(
                'serverInfo',
                name=feed.name,
                capabilities=list(feed.capabilities),
                supportedEncodings=list(PUBLISHED),
                metadata={'ROS_DISTRO': 'jazzy'},
                sessionId=self._session,
                **feed.details(),
            )
        )
        self._look()

    def _say(self, message: Message) -> None:
        self._waiting_bytes += len(message)
        if self._waiting_bytes <= MOST_WAITING or not self._waiting:
            self._waiting.append(message)

    # -- messages to the client

    def turn(self) -> list[Message]:
        """Return the messages for the client about everything that has happened since the last call."""
        self._renew()
        messages = self._feed.advance()
        data = self._data()  # read before `_look`, which may remove topics
        self._look()
        self._tell_changes()
        replies, self._waiting, self._waiting_bytes = self._waiting, [], 0
        now_ns = self._feed.now_ns()
        clock = [server_messages.time(now_ns)] if now_ns != self._time_ns and 'time' in self._feed.capabilities else []
        self._time_ns = now_ns
        return [*replies, *clock, *data, *messages]  # the state "ended" comes after the last message

    def _renew(self) -> None:
        if self._feed.session() != self._session:
            self._begin()

    def _look(self) -> None:
        """Report new and removed topics and services."""
        version = self._feed.version()
        if version == self._version:
            return
        self._version = version
        gone = self._compare(self._feed.topics(), self._channels, self._channel, 'unadvertise', 'advertise', 'channel')
        self._drop({number for number, (channel, _) in self._subscribed.items() if channel in gone})
        words = 'unadvertiseServices', 'advertiseServices', 'service'
        self._compare(self._feed.services(), self._services, self._service, *words)

    def _compare(
        self,
        here: Sequence[Topic],
        known: dict[int, Topic],
        described: Callable[[Topic], dict[str, Any] | None],
        takes_back: str,
        tells: str,
        what: str,
    ) -> list[int]:
        """Report new and removed entries, and return the numbers of the removed entries."""
        gone = [number for number, topic in known.items() if topic not in here]
        for number in gone:
            del known[number]
        if gone:
            self._say(server_messages.op(takes_back, **{f'{what}Ids': gone}))
        there = set(known.values())
        rows = [row for row in (described(topic) for topic in here if topic not in there) if row is not None]
        if rows:
            self._say(server_messages.op(tells, **{f'{what}s': rows}))
        return gone

    def _drop(self, subscriptions: set[int]) -> None:
        for number in subscriptions:
            del self._subscribed[number], self._cursors[number]

    def _channel(self, topic: Topic) -> dict[str, Any] | None:
        schema = _schema(topic.registry, topic.type)
        if schema is None:
            return None
        self._number += 1
        self._channels[self._number] = topic
        return {
            'id': self._number,
            'topic': topic.name,
            'encoding': ENCODING,
            'schemaName': topic.type,
            'schema': schema,
            'schemaEncoding': SCHEMA,
        }

    def _service(self, service: Topic) -> dict[str, Any] | None:
        parts = {}
        for part in ('Request', 'Response'):
            schema = _schema(service.registry, f'{service.type}_{part}')
            if schema is None:
                return None
            name = f'{service.type}_{part}'
            parts[part.lower()] = {'encoding': ENCODING, 'schemaName': name, 'schemaEncoding': SCHEMA, 'schema': schema}
        self._number += 1
        self._services[self._number] = service
        return {'id': self._number, 'name': service.name, 'type': service.type, **parts}

    def _data(self) -> list[bytes]:
        """Return the messages of subscribed topics since the last turn. If there are too many, leave out the oldest messages."""
        messages: list[bytes] = []
        left = MOST_BYTES
        for number, (channel, key) in self._subscribed.items():
            rows, self._cursors[number], lost = self._feed.rows(key, self._cursors[number], MOST_ROWS)
            newest: list[bytes] = []
            cls = self._channels[channel].cls
            for time_ns, wire in reversed(rows):
                cdr = encode(cls, wire)
                if len(cdr) > left:
                    break
                left -= len(cdr)
                newest.append(server_messages.data(number, time_ns, cdr))
            messages += reversed(newest)
            self._count(key[0], lost + len(rows) - len(newest))
        return messages

    def _count(self, topic: str, lost: int) -> None:
        if lost:
            total = self._lost[topic] = self._lost.get(topic, 0) + lost
            text = f'{total} messages of {topic} were left out: this client or the network is too slow'
            self._say(server_messages.status(server_messages.WARNING, text, f'lost {topic}'))

    def _tell_changes(self) -> None:
        if self._watches_graph and self._graph_version != self._version:
            self._graph_version = self._version
            graph = self._feed.graph()
            update = server_messages.graph_update(graph, self._graph)
            self._graph = graph
            if update is not None:
                self._say(update)
        if self._watched != set() and self._feed.parameter_version() != self._values_version:
            self._values_version = self._feed.parameter_version()
            values = {name: value for name, value in self._feed.parameters().items() if self._is_watched(name)}
            changed = {name: value for name, value in values.items() if self._values.get(name) != value}
            self._values = values
            if changed:
                self._say(server_messages.parameters(changed))

    def _is_watched(self, name: str) -> bool:
        return self._watched is None or name in self._watched

    # -- messages from the client

    def take(self, message: Message) -> None:
        """Handle a request of the client. If the request is impossible, reply with an error message.

        :raises TooMuch: when the client sends requests faster than it reads the replies.
        """
        if self._waiting_bytes > MOST_WAITING:
            raise TooMuch
        self._renew()
        try:
            request = protocol.parse(message)
            self._actions[type(request)](request)
        except (protocol.ProtocolError, Refused) as error:
            self._say(server_messages.status(server_messages.ERROR, str(error)))

    def _subscribe(self, request: protocol.Subscribe) -> None:
        for number, channel in request.pairs:
            topic = self._channels.get(channel)
            if topic is None or number in self._subscribed or len(self._subscribed) >= MOST_CHANNELS:
                why = 'is no channel of this server' if topic is None else 'is subscribed already, or there are too many'
                raise Refused(f'subscribe: channel {channel} {why}')
            key = topic.name, topic.type
            kept = self._feed.kept(key)
            self._subscribed[number] = channel, key
            self._cursors[number] = self._feed.end(key)
            for time_ns, wire in kept:
                self._say(server_messages.data(number, time_ns, encode(topic.cls, wire)))

    def _unsubscribe(self, request: protocol.Unsubscribe) -> None:
        self._drop(set(request.ids) & set(self._subscribed))

    def _advertise(self, request: protocol.Advertise) -> None:
        for channel in request.channels:
            if channel.encoding not in PUBLISHED:
                raise Refused(
                    f'{channel.topic}: edulaunch takes messages in {" or ".join(PUBLISHED)}, not in {channel.encoding!r}'
                )
            if channel.id in self._publishers or len(self._publishers) >= MOST_CHANNELS:
                raise Refused(f'{channel.topic}: channel {channel.id} already exists, or the client has too many channels')
            self._publishers[channel.id] = self._feed.advertise(channel.topic, channel.type, channel.encoding)

    def _unadvertise(self, request: protocol.Unadvertise) -> None:
        for number in request.ids:
            publish = self._publishers.pop(number, None)
            if publish is not None:
                self._feed.retire(publish)

    def _publish(self, request: protocol.Publish) -> None:
        publish = self._publishers.get(request.channel)
        if publish is None:
            raise Refused(f'this client has no channel {request.channel}: advertise it first')
        publish(request.data)

    def _call(self, request: protocol.Call) -> None:
        def answer(reply: bytes | str) -> None:
            if isinstance(reply, bytes):
                self._say(server_messages.response(request.service, request.number, reply))
            else:
                ids = {'serviceId': request.service, 'callId': request.number}
                self._say(server_messages.op('serviceCallFailure', **ids, message=reply))

        service = self._services.get(request.service)
        if service is None:
            answer(f'this server has no service {request.service}')
        elif request.encoding != ENCODING:
            answer(f'{service.name}: edulaunch takes requests in {ENCODING}, not in {request.encoding[:20]!r}')
        else:
            try:
                self._feed.call(service, request.data, answer)
            except Refused as error:
                answer(str(error))

    def _get_parameters(self, request: protocol.GetParameters) -> None:
        values = self._feed.parameters()
        wanted = request.names or values
        self._say(server_messages.parameters({name: values[name] for name in wanted if name in values}, request.request))

    def _set_parameters(self, request: protocol.SetParameters) -> None:
        def answer(wrong: str) -> None:
            if wrong:
                self._say(server_messages.status(server_messages.ERROR, wrong))
            names = tuple(name for name, _, _ in request.values)
            self._get_parameters(protocol.GetParameters(names, request.request))

        self._feed.set(request.values, answer)

    def _watch_parameters(self, request: protocol.WatchParameters) -> None:
        if not request.names:
            self._watched = None if request.on else set()
        elif self._watched is not None:
            self._watched = self._watched | set(request.names) if request.on else self._watched - set(request.names)
            if len(self._watched) > MOST_CHANNELS:
                self._watched = set()
                raise Refused(f'a client may watch at most {MOST_CHANNELS} parameters by name, or all of them')
        self._values_version = None

    def _watch_graph(self, request: protocol.WatchGraph) -> None:
        self._watches_graph, self._graph, self._graph_version = request.on, None, None

    def _play(self, request: protocol.Playback) -> None:
        state, did_seek = self._feed.play(request)
        self._say(state)
        if did_seek:
            for number, (channel, key) in self._subscribed.items():
                self._cursors[number] = self._feed.end(key)
                for time_ns, wire in self._feed.kept(key):
                    self._say(server_messages.data(number, time_ns, encode(self._channels[channel].cls, wire)))

    def _fetch_asset(self, request: protocol.FetchAsset) -> None:
        self._say(server_messages.no_asset(request.request, 'edulaunch serves no files'))

    def close(self) -> None:
        """Release the resources of a client that has disconnected."""
        self._feed.close()


def _schema(registry: Any, type_name: str) -> str | None:
    """Return the definition of a type and of all types that it contains, or None for an unknown type."""
    try:
        return definition(registry, type_name)
    except (InterfaceError, AssertionError):
        return None

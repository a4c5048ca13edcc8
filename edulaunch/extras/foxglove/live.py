"""A running machine as the feed of one client. If the client publishes or sends requests, it gets a separate node in the
graph.
"""

from __future__ import annotations

import json
from collections.abc import Callable, Sequence
from types import SimpleNamespace
from typing import Any

from edulaunch.desk.cli.ros2.fill_message import FillError, fill_message
from edulaunch.desk.view import ViewedMachine
from edulaunch.engine.graph.names import topic_name_problem
from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.parameters import BYTE_ARRAY, DOUBLE, DOUBLE_ARRAY, type_of_value
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.errors import InterfaceError
from edulaunch.extras.foxglove.feed import Key, Refused, Row, Topic
from edulaunch.extras.foxglove.protocol import Playback, Value
from edulaunch.extras.foxglove.server_messages import Graph
from edulaunch.ros.serialization.cdr import decode, encode
from edulaunch.runtime.session import Session

MOST_CALLS = 100
"""The maximum number of requests of one client that wait for their reply."""
MOST_PROBLEMS = 5
"""The maximum number of parameters in one error message."""
ANSWER_NS = 30 * 10**9
"""The simulated nanoseconds after which a request without a reply ends with an error."""
SLOTS = ('', 'bool', 'integer', 'double', 'string', 'byte_array', 'bool_array', 'integer_array', 'double_array', 'string_array')
"""The fields of rcl_interfaces/msg/ParameterValue by the number of the type. The name of each field ends in '_value'."""


class LiveFeed:
    """The feed of the current session of a machine.

    :param number: the number of the client, which is part of the name of its node.
    """

    name = 'edulaunch'
    capabilities: tuple[str, ...] = ('clientPublish', 'connectionGraph', 'parameters', 'parametersSubscribe', 'services', 'time')

    def __init__(self, machine: ViewedMachine, number: int) -> None:
        self._machine = machine
        self._number = number
        self._sessions = 0
        self._use(machine.session)

    def _use(self, session: Session) -> None:
        self._sessions += 1
        self._session, self._graph, self._recorder = session, session.graph, session.recorder
        self._node: NodeEntry | None = None
        self._ends: dict[Any, Any] = {}
        self._calls: dict[Any, tuple[int, Callable[[bytes | str], object]]] = {}
        self._early: dict[Any, Any] | None = None

    def session(self) -> str:
        if self._machine.session is not self._session:
            self._use(self._machine.session)
        return f'{self._session.sim.start_ns}-{self._sessions}'

    def details(self) -> dict[str, Any]:
        return {}

    def now_ns(self) -> int:
        return self._session.sim.now_ns

    def advance(self) -> list[bytes]:
        """End requests that received no reply in time. The time itself passes with the machine's own clock."""
        late = [call for call, (until_ns, _) in self._calls.items() if until_ns < self.now_ns()]
        for call in late:
            _, answer = self._calls.pop(call)
            answer(f'{call[0].service_name} did not answer within {ANSWER_NS // 10**9} s')
        return []

    # -- channels and services

    def version(self) -> object:
        return self._graph.changes

    def topics(self) -> list[Topic]:
        return _known(self._graph.publishers)

    def services(self) -> list[Topic]:
        return _known(self._graph.services)

    def graph(self) -> Graph:
        tables: dict[str, Any] = {
            'published': self._graph.publishers,
            'subscribed': self._graph.subscriptions,
            'served': self._graph.services,
        }
        return {
            part: {name: list(dict.fromkeys(end.node.fully_qualified_name for end in ends)) for name, ends in table.items()}
            for part, table in tables.items()
        }

    # -- messages

    def end(self, key: Key) -> int:
        return int(self._recorder.forgotten.get(key, 0)) + len(self._recorder.columns.get(key, ())) // 3

    def kept(self, key: Key) -> list[Row]:
        topic, kind = key
        ends = [end for end in self._graph.publishers.get(topic, ()) if end.type_name == kind]
        rows = [(time_ns, wire) for end in ends for wire, time_ns, *_ in end.late_samples()]
        return sorted(rows, key=lambda row: row[0])

    def rows(self, key: Key, first: int, most: int) -> tuple[list[Row], int, int]:
        end = self.end(key)
        if first == end:
            return [], end, 0
        flat, gone = self._recorder.columns[key], int(self._recorder.forgotten.get(key, 0))
        begin = max(first, gone, end - most)
        part = flat[3 * (begin - gone) :]
        return list(zip(part[::3], part[2::3], strict=True)), end, begin - first

    # -- the client's own node

    def _own_node(self) -> NodeEntry:
        if self._node is None:
            process = SimpleNamespace(name='foxglove', pid=0, state={}, sim=self._session.sim)
            self._node = self._graph.add_node(process, f'_foxglove_{self._number}', '/')
        return self._node

    def advertise(self, topic: str, type_name: str, encoding: str) -> Callable[[bytes], object]:
        problem = topic_name_problem(topic)
        if problem or not topic.startswith('/'):
            raise Refused(f'{topic!r} is not a topic name: {problem or "it has to begin with a slash"}')
        cls = self._class(type_name)
        publisher = self._graph.create_publisher(self._own_node(), topic, cls, QoS())
        read = _from_json if encoding == 'json' else _decoded

        def publish(data: bytes) -> None:
            if not publisher.destroyed:
                publisher.publish(read(cls, data, topic))

        self._ends[publish] = publisher
        return publish

    def retire(self, publish: Callable[[bytes], object]) -> None:
        publisher = self._ends.pop(publish, None)
        if publisher is not None:
            publisher.destroy()

    def _class(self, type_name: str) -> Any:
        """Return the class of a message type, from an endpoint that uses the type or from the machine."""
        for node in self._graph.nodes:
            for end in node.endpoints:
                if end.type_name == type_name and hasattr(end.cls, 'from_wire'):
                    return end.cls
        try:
            cls = self._session.host.overlay(self._session.index).registry.get(type_name)
        except InterfaceError as error:
            raise Refused(str(error)) from None
        if not hasattr(cls, 'from_wire'):
            raise Refused(f'{type_name} is not a message type')
        return cls

    def call(self, service: Topic, request: bytes, answer: Callable[[bytes | str], object]) -> None:
        self._ask(service.name, service.cls, _decoded(service.cls.Request, request, service.name), answer)

    def _ask(self, name: str, cls: Any, wire: Any, answer: Callable[[bytes | str], object]) -> None:
        if len(self._calls) >= MOST_CALLS:
            raise Refused(f'{MOST_CALLS} requests of this client already wait for a reply')
        client: Any = self._ends.get((name, cls))
        if client is None:

            def ready() -> None:
                number, reply = client.take()
                _, waiting = self._calls.pop((client, number), (0, None))
                if waiting is not None:
                    waiting(encode(cls.Response, reply))
                elif self._early is not None:
                    self._early[number] = reply

            client = self._ends[name, cls] = self._graph.create_client(self._own_node(), name, cls, QoS(), ready)
        if not client.server_is_ready():
            raise Refused(f'no node serves {name} any more')
        self._early = {}
        number = client.send(wire)
        early, self._early = self._early, None
        if number in early:  # some services reply immediately
            answer(encode(cls.Response, early[number]))
        else:
            self._calls[client, number] = self.now_ns() + ANSWER_NS, answer

    # -- parameters

    def parameter_version(self) -> object:
        forgotten = self._recorder.forgotten.get('parameters', 0)
        return forgotten, len(self._recorder.parameters), self._graph.changes

    def parameters(self) -> dict[str, Any]:
        alive = {node.fully_qualified_name for node in self._graph.nodes}
        rows = (row for row in self._recorder.parameters if row[1] in alive)
        found = {f'{node}.{name}': value for _, node, name, value, _ in rows}
        return {name: value for name, value in sorted(found.items()) if value is not None}

    def set(self, values: Sequence[tuple[str, Value, str | None]], answer: Callable[[str], object]) -> None:
        current, wrong, left = self.parameters(), [], [len(values)]

        def done(problem: str) -> None:
            wrong.extend([problem] if problem else [])
            left[0] -= 1
            if not left[0]:
                answer('; '.join(wrong[:MOST_PROBLEMS]))

        if not values:
            answer('')
        for name, value, kind in values:
            try:
                self._set(name, value, kind, current.get(name), done)
            except Refused as error:
                done(str(error))

    def _set(self, full: str, value: Value, kind: str | None, current: Any, done: Callable[[str], object]) -> None:
        node, _, name = full.partition('.')
        service = next(iter(self._graph.services.get(f'{node}/set_parameters', ())), None)
        if service is None or service.type_name != 'rcl_interfaces/srv/SetParameters':
            raise Refused(f'{full}: no node {node} has parameters here')
        cls = service.cls
        underlay = underlay_registry()
        typed = underlay.get('rcl_interfaces/msg/ParameterValue')(**_typed(full, value, kind, current))
        parameter = underlay.get('rcl_interfaces/msg/Parameter')(name=name, value=typed)
        request = cls.Request(parameters=[parameter])

        def on_reply(reply: bytes | str) -> None:
            if isinstance(reply, str):
                done(f'{full}: {reply}')
                return
            (successful, reason), *_ = decode(cls.Response, reply)[0]
            done('' if successful else f'{full}: {reason or "the node refused the value"}')

        self._ask(service.service_name, cls, cls.Request.to_wire(request), on_reply)

    def play(self, request: Playback) -> tuple[bytes, bool]:
        raise Refused('this is a running machine, not a recording: `edulaunch machine pause` stops the time of a machine')

    def close(self) -> None:
        if self._node is not None:
            self._graph.remove_node(self._node)
            self._node = None


def _known(table: dict[str, list[Any]]) -> list[Topic]:
    """Return the names in a table of the graph, each with its known types."""
    found: dict[Key, Topic] = {}
    for name, ends in table.items():
        for end in ends:
            overlay = getattr(end.node.process, 'overlay', None)
            if hasattr(end.cls, 'from_wire') or hasattr(end.cls, 'Request'):
                registry = underlay_registry() if overlay is None else overlay.registry
                found.setdefault((name, end.type_name), Topic(name, end.type_name, end.cls, registry))
    return list(found.values())


def _decoded(cls: Any, data: bytes, what: str) -> Any:
    try:
        return decode(cls, data)
    except (InterfaceError, MemoryError) as error:
        raise Refused(f'{what}: {error}') from None


def _from_json(cls: Any, data: bytes, what: str) -> Any:
    """Return the wire tuple of a message in JSON. A field that is missing in the JSON object has its default value."""
    message = cls()
    try:
        values = json.loads(data)
        if not isinstance(values, dict):
            raise ValueError(f'{data[:20]!r} is not an object with the fields of a {cls.TYPE}')
        fill_message(message, values)
        return cls.to_wire(message)
    except (ValueError, RecursionError, FillError, InterfaceError) as error:
        raise Refused(f'{what}: {error}') from None


def _typed(name: str, value: Value, kind: str | None, current: Any) -> dict[str, Any]:
    """Return the fields of a ParameterValue. In JSON, 2 can also mean 2.0, so the current type decides."""
    if kind == 'byte_array':
        raise Refused(f'{name}: byte arrays cannot be set')
    was = type_of_value(current)
    if was == DOUBLE or kind == 'float64':
        value = float(value) if isinstance(value, int) and not isinstance(value, bool) else value
    if (was == DOUBLE_ARRAY or kind == 'float64_array') and isinstance(value, list):
        value = [float(one) if isinstance(one, int) and not isinstance(one, bool) else one for one in value]
    try:
        number = was if value == [] and was >= BYTE_ARRAY else type_of_value(value)
    except TypeError as error:
        raise Refused(f'{name}: {error}') from None
    limits = range(-(1 << 63), 1 << 63)
    whole = [one for one in (value if isinstance(value, list) else [value]) if isinstance(one, int)]
    if any(one not in limits for one in whole):
        raise Refused(f'{name}: a whole number of a parameter has 64 bits')
    return {'type': number, f'{SLOTS[number]}_value': value}

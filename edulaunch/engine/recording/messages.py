"""The messages of a recording: their senders, receivers and content."""

from __future__ import annotations

from functools import cached_property
from typing import TYPE_CHECKING, Any

from edulaunch.engine.interfaces import current_registry
from edulaunch.engine.recording.absent import NoMessages
from edulaunch.engine.recording.records import ServiceCall, TopicRecord
from edulaunch.engine.underlay_place import help_text
from edulaunch.errors import InterfaceError, RecordingError, UnusableInput

if TYPE_CHECKING:
    from edulaunch.engine.graph.qos import QoS
    from edulaunch.engine.recording.recorded_types import RecordedTypes


class Messages:
    """The part of a recording with messages and their types. A recording file is first read as plain data. The messages of
    a topic and the service calls are checked against their types on first use.
    """

    def __init__(self, content: dict[str, Any]) -> None:
        self._content = content
        self.start_ns: int = content['start_ns']
        self._unread: str | None = None
        self._read: set[int] = set()

    @cached_property
    def topics(self) -> dict[str, TopicRecord]:
        """All topics by name, in alphabetical order."""
        names = {row[4]: row[0] for row in self._content['nodes']}
        counts: dict[str, int] = {}
        for topic in self._content['topics']:
            counts[topic['topic']] = counts.get(topic['topic'], 0) + len(topic['times'])
        found: dict[str, TopicRecord] = {}
        for kind, name, type_name, node, *_ in self._content['endpoints']:
            if kind in ('publisher', 'subscription'):
                record = found.setdefault(name, TopicRecord(name, type_name, [], [], counts.get(name, 0)))
                who = record.publishers if kind == 'publisher' else record.subscriptions
                if names.get(node, '') not in who:
                    who.append(names.get(node, ''))
        return dict(sorted(found.items()))

    def rows(self, part: str) -> list[Any]:
        """Return the rows of a `part` ('topics', 'calls', 'logs', 'output', 'parameters') as plain data. Do not change them."""
        found: list[Any] = self._content[part]
        return found

    def offered(self, topic: str) -> list[QoS]:
        """Return the QoS policies of each publisher that a `topic` had during the run. The name of the topic is its
        full name.
        """
        from edulaunch.engine.graph.qos import QoS

        return [QoS(*row[6]) for row in self._content['endpoints'] if row[0] == 'publisher' and row[1] == topic]

    def messages(self, topic: str) -> list[tuple[float, Any]]:
        """Return all messages of a topic as (time in seconds, message), in order of publication. `topic` is the full name.

        For an unknown topic, return an empty list.
        :raises KeyError: when code reads an item of the empty list; the message names the nearest topic.
        """
        if topic not in self.topics:
            return NoMessages(topic, self.topics)
        rows = []
        for column in self._columns(topic):
            from_wire = self.message_class(column['type']).from_wire
            rows += [(time, from_wire(wire)) for time, wire in zip(column['times'], column['messages'], strict=True)]
        rows.sort(key=_time_of)
        return [(time / 1e9, message) for time, message in rows]

    def wires(self, topic: str, type_name: str) -> list[tuple[int, Any]]:
        """Return the messages of type `type_name` ('turtlesim/msg/Pose') on a `topic`, in order, as (time in ns, wire)."""
        columns = [column for column in self._columns(topic) if column['type'] == type_name]
        rows = (row for column in columns for row in zip(column['times'], column['messages'], strict=True))
        return sorted(rows, key=_time_of)

    def published(self, topic: str, type_name: str) -> list[tuple[int, str, Any]]:
        """Return the messages of type `type_name` on a `topic`, in order, as (time in ns, name of the publishing node, wire)."""
        nodes = {row[4]: row[0] for row in self._content['nodes']}
        owner = {row[4]: nodes.get(row[3], '') for row in self._content['endpoints'] if row[0] == 'publisher'}
        rows = (
            (time, owner.get(publisher, ''), wire)
            for column in self._columns(topic)
            if column['type'] == type_name
            for time, publisher, wire in zip(column['times'], column['publishers'], column['messages'], strict=True)
        )
        return sorted(rows, key=_time_of)

    def series(self, topic: str, *fields: str) -> list[tuple[float, ...]]:
        """Return numbers of a `topic` over time: rows of (time in seconds, field, field ...).

        :param fields: paths such as 'pose.pose.position.x' or 'ranges[0]'; the numbers have the units of the message.
        :raises NotRecorded: if the messages have no such field; the message names the nearest field.
        :raises ValueError: if `fields` is empty.
        """
        from edulaunch.engine.recording.fields import getter

        if not fields:
            raise ValueError('series() needs at least one field, such as "linear.x"')
        if topic not in self.topics:
            return NoMessages(topic, self.topics)
        cls = self.message_class(self.topics[topic].type)
        places = {path: place for place, (path, kind) in enumerate(cls.wire_type()) if ']' not in kind}
        if set(fields) <= places.keys() and all(column['type'] == cls.TYPE for column in self._columns(topic)):
            wires = self.wires(topic, cls.TYPE)  # reading wire tuples takes a fifth of the time of creating messages
            return [(time / 1e9, *(wire[places[field]] for field in fields)) for time, wire in wires]
        gets = [getter(cls, field) for field in fields]
        return [(time, *(get(message) for get in gets)) for time, message in self.messages(topic)]

    @cached_property
    def registry(self) -> RecordedTypes:
        """The interfaces of this recording: the student's own interfaces as recorded, and all importable interfaces."""
        from edulaunch.engine.recording.recorded_types import RecordedTypes

        return RecordedTypes(self._content.get('interfaces') or {}, current_registry())

    def message_class(self, type_name: str) -> Any:
        """Return the class of the message type `type_name` ('turtlesim/msg/Pose'), with the fields that it had in the run.

        :raises RecordingError: if the type is unknown here, or its definition is invalid.
        """
        try:
            return self.registry.get(type_name)
        except InterfaceError as error:
            raise RecordingError(error.message, help=error.help) from None
        except RecursionError:
            raise RecordingError(f'{type_name} contains too many nested messages') from None

    def _columns(self, topic: str) -> list[dict[str, Any]]:
        columns = [column for column in self._content['topics'] if column['topic'] == topic]
        for column in columns:
            if self._unread is not None and id(column) not in self._read:
                self._check(column['type'], column['messages'])
                self._read.add(id(column))
        return columns

    def _check(self, type_name: str, wires: list[Any]) -> None:
        """Raise RecordingError if messages from a file do not fit their type."""
        self.message_class(type_name)
        try:
            fit = self.registry.checks.check(type_name)
        except InterfaceError as error:
            raise RecordingError(error.message, help=error.help) from None
        if not fit(wires):
            raise RecordingError(f'{self._unread} is damaged: it has messages that are not of the type {type_name}.')

    @cached_property
    def service_calls(self) -> list[ServiceCall]:
        """The requests and their replies as messages, in order of the requests."""
        calls = []
        for time, service, kind, client, request, served, replied, response in self._content['calls']:
            cls = self.message_class(kind)
            if self._unread is not None:
                self._check(f'{kind}_Request', [request])
                self._check(f'{kind}_Response', [] if replied is None else [response])
            answer = cls.Response.from_wire(response) if replied is not None else None
            calls.append(
                ServiceCall(time / 1e9, service, kind, client, cls.Request.from_wire(request), served, seconds(replied), answer)
            )
        return calls

    def to_pandas(self, topic: str, *fields: str) -> Any:
        """Return the messages of a `topic` as a pandas DataFrame, with the time in seconds as its index.

        :param fields: the columns (default: every field that is not a list).
        :raises UnusableInput: if pandas is not installed.
        """
        from edulaunch.engine.recording.fields import getter, leaf_paths

        try:
            import pandas  # type: ignore[import-untyped, unused-ignore]
        except ImportError:
            raise UnusableInput('to_pandas() needs pandas', help=help_text('pandas')) from None
        messages = self.messages(topic)
        if isinstance(messages, NoMessages):
            messages[0]  # raises an error that lists the existing topics
        cls = self.message_class(self.topics[topic].type)
        paths = fields or tuple(path for path, kind in cls.wire_type() if ']' not in kind and path in leaf_paths(cls))
        gets = [getter(cls, path) for path in paths]
        rows = [[get(message) for get in gets] for _, message in messages]
        return pandas.DataFrame(rows, columns=list(paths), index=pandas.Index([time for time, _ in messages], name='time_s'))


def seconds(time_ns: int | None) -> float | None:
    """Convert nanoseconds to seconds. None stays None."""
    return None if time_ns is None else time_ns / 1e9


def _time_of(row: Any) -> int:
    return row[0]  # type: ignore[no-any-return]

"""What a run leaves behind, and the questions one asks it."""

from __future__ import annotations

import os
from functools import cached_property
from typing import TYPE_CHECKING, Any

from edulaunch.attached import attached
from edulaunch.errors import InterfaceError, RecordingError, UnusableInput
from edulaunch.recording import file_format
from edulaunch.recording.absent import NodeParameters, NoMessages, not_recorded
from edulaunch.recording.records import (
    DeclaredArgument,
    EndRecord,
    Fact,
    Frame,
    LaunchRecord,
    LogRecord,
    NodeRecord,
    Note,
    Output,
    Parameter,
    ProcessRecord,
    ServiceCall,
    TopicRecord,
    UnreadArgument,
)

if TYPE_CHECKING:
    from edulaunch.graph.qos import QoS
    from edulaunch.recording.misfits import Misfit
    from edulaunch.recording.recorded_types import RecordedTypes
    from edulaunch.recording.trajectory import Trajectory


UNREPEATABLE = ('real program', 'real machine', 'stopped', 'interrupted')
"""Kinds of notes about what differs from run to run."""


class Recording:
    """A run as data: processes, nodes, parameters with their origin, every message, tf, logs.

    All times are float seconds since the start of the simulation. Made by `edulaunch.run`, or by :meth:`load`.
    """

    hosted_nodes: frozenset[int] | None = None
    """Positions in `nodes` of those that a trusted half hosted (see `edulaunch.link`); None when all ran in one process."""
    hosted_parameters: frozenset[int] = frozenset()
    """Positions among the parameters of what these nodes set: another node of the same name does not speak for them."""

    def __init__(self, content: dict[str, Any]) -> None:
        self._content = content
        self._unread: str | None = None
        self._read: set[int] = set()
        self.seed: int = content['seed']
        self.start_ns: int = content['start_ns']
        self.duration_s: float = content['duration_ns'] / 1e9

    def __repr__(self) -> str:
        return (
            f'<Recording {self.duration_s:.3f} s: {len(self.processes)} processes, {len(self.nodes)} nodes, '
            f'{sum(topic.count for topic in self.topics.values())} messages>'
        )

    @classmethod
    def load(cls, path: str | os.PathLike[str]) -> Recording:
        """Read a recording file.

        :raises RecordingError: when the file is missing, damaged, or something else.
        """
        name = os.fspath(path)
        try:
            if os.path.exists(name) and not os.path.isfile(name):
                raise RecordingError(f'cannot read the recording {name!r}: it is not a file')
            with open(name, 'rb') as file:
                data = file.read(file_format.MOST_BYTES + 1)
        except (OSError, ValueError) as error:
            raise RecordingError(f'cannot read the recording {name!r}: {getattr(error, "strerror", None) or error}') from None
        if len(data) > file_format.MOST_BYTES:
            raise RecordingError(f'cannot read the recording {name!r}: it is larger than {file_format.MOST_BYTES >> 30} GiB')
        return cls.from_bytes(data, name)

    @classmethod
    def from_bytes(cls, data: bytes, name: str = 'this recording') -> Recording:
        """A recording from the bytes that :meth:`to_bytes` gave. Raises RecordingError when they are something else."""
        recording = cls(file_format.decode(data, name))
        recording._unread = name
        return recording

    def to_bytes(self) -> bytes:
        """The recording as text (JSON lines), the same bytes for the same run."""
        return file_format.encode(self._content)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a recording file, whole or not at all. Raises RecordingError when it cannot be written."""
        temporary = f'{os.fspath(path)}.part'
        try:
            with open(temporary, 'wb') as file:
                file.write(self.to_bytes())
            os.replace(temporary, path)
        except OSError as error:
            raise RecordingError(f'cannot write the recording {os.fspath(path)!r}: {error.strerror or error}') from None

    def digest(self) -> str:
        """SHA-256 of everything that happened: equal for equal launch file, arguments and seed, on every machine.

        Paths of the launch files are left out, so that a copy of a workspace gives the same digest.
        """
        import hashlib

        from edulaunch.recording.canonical import canonical

        return hashlib.sha256(file_format.encode(canonical(self._content))).hexdigest()

    def rows(self, part: str) -> list[Any]:
        """The rows of a part ('topics', 'calls', 'logs', 'output', 'parameters') as the file has them: plain data, times in
        nanoseconds. For who reads all of a long run; not to be changed.
        """
        found: list[Any] = self._content[part]
        return found

    @cached_property
    def launch(self) -> LaunchRecord:
        """What was launched, its declared arguments, and launch's return code."""
        fields = {**self._content['launch']}
        for words in ('warnings', 'help'):  # of recordings of old: they are found anew
            fields.pop(words, None)
        fields['declared'] = [DeclaredArgument(*row) for row in fields.get('declared', ())]
        fields['unread'] = [UnreadArgument(*row) for row in fields.get('unread', ())]
        return LaunchRecord(**fields)

    @property
    def includes(self) -> list[str]:
        """The launch files that were included, in order."""
        return self.launch.includes

    @cached_property
    def processes(self) -> list[ProcessRecord]:
        """The programs that were started, in order."""
        return [
            ProcessRecord(
                row['name'],
                row['pid'],
                row['argv'],
                row['package'],
                row['executable'],
                row['file'],
                row['line'],
                row['parameter_origins'],
                row['started'] / 1e9,
                _seconds(row['ended']),
                row['returncode'],
                row['exception'],
            )
            for row in self._content['processes']
        ]

    @cached_property
    def nodes(self) -> list[NodeRecord]:
        """The nodes that joined the graph, in order, with everything they ever published, heard, served or called."""
        ends: dict[int, dict[str, list[tuple[str, str]]]] = {}
        for kind, name, type_name, node, *_ in self._content['endpoints']:
            of_kind = ends.setdefault(node, {}).setdefault(kind, [])
            if (name, type_name) not in of_kind:
                of_kind.append((name, type_name))
        return [
            NodeRecord(
                name,
                process,
                start / 1e9,
                _seconds(end),
                *(ends.get(index, {}).get(kind, []) for kind in ('publisher', 'subscription', 'service', 'client')),
            )
            for name, process, start, end, index in self._content['nodes']
        ]

    @cached_property
    def ends(self) -> list[EndRecord]:
        """All publishers, subscriptions, services and clients, in order of their making."""
        nodes = {row[4]: row[0] for row in self._content['nodes']}
        return [
            EndRecord(kind, name, type_name, nodes.get(node, ''), made / 1e9, qos)
            for kind, name, type_name, node, _, made, qos in self._content['endpoints']
        ]

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

    def parameters(self, node: str) -> dict[str, Parameter]:
        """The parameters of a node (fully qualified name) at the end, in the order of declaration.

        :raises KeyError: when no such node was there; the message names the nodes that were.
        """
        found: dict[str, Parameter] = NodeParameters(node, next((end.ended_s for end in self.nodes if end.name == node), None))
        is_hosted = any(self.nodes[position].name == node for position in self.hosted_nodes or ())
        for position, (_, name, parameter, value, origin) in enumerate(self._content['parameters']):
            if name == node and (position in self.hosted_parameters or not is_hosted):
                if value is None:
                    found.pop(parameter, None)
                else:
                    found[parameter] = Parameter(value, origin)
        if not found and node not in {record.name for record in self.nodes}:
            raise not_recorded(f'no node {node!r}', node, (record.name for record in self.nodes))
        return found

    def messages(self, topic: str) -> list[tuple[float, Any]]:
        """All messages of a topic as (time in seconds, message), in order of publication; [] for a topic that is not there.

        :raises KeyError: later, when one of the messages of a topic that is not there is asked for; it names the nearest topic.
        """
        if topic not in self.topics:
            return NoMessages(topic, self.topics)
        rows = []
        for column in self._columns(topic):
            from_wire = self._class(column['type']).from_wire
            rows += [(time, from_wire(wire)) for time, wire in zip(column['times'], column['messages'], strict=True)]
        rows.sort(key=_time_of)
        return [(time / 1e9, message) for time, message in rows]

    def wires(self, topic: str, type_name: str) -> list[tuple[int, Any]]:
        """All messages of one type on a topic as (time in ns, wire), in order of publication; much cheaper than messages."""
        columns = [column for column in self._columns(topic) if column['type'] == type_name]
        rows = [row for column in columns for row in zip(column['times'], column['messages'], strict=True)]
        rows.sort(key=_time_of)
        return rows

    def published(self, topic: str, type_name: str) -> list[tuple[int, str, Any]]:
        """As :meth:`wires`, each with the name of the node that published it: (time in ns, node, wire)."""
        nodes = {row[4]: row[0] for row in self._content['nodes']}
        owner = {row[4]: nodes.get(row[3], '') for row in self._content['endpoints'] if row[0] == 'publisher'}
        rows = [
            (time, owner.get(publisher, ''), wire)
            for column in self._columns(topic)
            if column['type'] == type_name
            for time, publisher, wire in zip(column['times'], column['publishers'], column['messages'], strict=True)
        ]
        rows.sort(key=_time_of)
        return rows

    @cached_property
    def own_processes(self) -> list[ProcessRecord]:
        """The processes that run a student's program: neither one of ours, nor a `ros2` command."""
        ours = tuple(os.path.join(path, '') for path, name in self._content['roots'] if name == '@underlay')
        return [row for row in self.processes if not row.argv[0].startswith(ours) and os.path.basename(row.argv[0]) != 'ros2']

    def offered(self, topic: str) -> list[QoS]:
        """The quality of service of each publisher that a topic ever had."""
        from edulaunch.graph.qos import QoS

        return [QoS(*row[6]) for row in self._content['endpoints'] if row[0] == 'publisher' and row[1] == topic]

    @property
    def registry(self) -> RecordedTypes:
        """The interfaces of this recording: the student's own ones as they were, over those that can be imported now."""
        return self._registry

    def series(self, topic: str, *fields: str) -> list[tuple[float, ...]]:
        """Numbers over time: rows of (time in seconds, field, field ...); a field is a path: 'pose.pose.position.x', 'ranges[0]'.

        :raises NotRecorded: when the messages have no such field; the message names the nearest one.
        """
        from edulaunch.recording.fields import getter

        if not fields:
            raise ValueError('series() needs at least one field, such as "linear.x"')
        messages = self.messages(topic)
        if isinstance(messages, NoMessages):
            return messages
        gets = [getter(self._class(self.topics[topic].type), field) for field in fields]
        return [(time, *(get(message) for get in gets)) for time, message in messages]

    def message_class(self, type_name: str) -> Any:
        """The class of a message type, as it was in the run: 'turtlesim/msg/Pose'."""
        return self._class(type_name)

    def plot(self, topic: str, *fields: str, ax: Any = None) -> Any:
        """Numbers of a topic over time: `recording.plot('/turtle1/pose', 'x', 'y')`; see :func:`edulaunch.canvas.plot_series`."""
        return attached('plot_series')(self, topic, *fields, ax=ax)

    def table(self, topic: str, *fields: str) -> Any:
        """The messages of a topic as a table; see :func:`edulaunch.canvas.table.message_table`."""
        return attached('message_table')(self, topic, fields)

    def log_table(self, process: str | None = None, level: str = 'DEBUG', word: str = '') -> Any:
        """Log lines as a table: of one process, from a level up ('WARN'), with a word in them."""
        return attached('log_table')(self, process, level, word)

    def to_pandas(self, topic: str, *fields: str) -> Any:
        """The messages of a topic as a pandas DataFrame with the time in seconds as its index (pandas has to be installed).

        :param fields: default: every field that is no list.
        :raises UnusableInput: when pandas is not installed.
        """
        from edulaunch.recording.fields import getter, leaf_paths

        try:
            import pandas  # type: ignore[import-untyped, unused-ignore]
        except ImportError:
            raise UnusableInput('to_pandas() needs pandas', help='pip install pandas') from None
        messages = self.messages(topic)
        if isinstance(messages, NoMessages):
            messages[0]  # says which topics there are
        cls = self._class(self.topics[topic].type)
        paths = fields or tuple(path for path, kind in cls.wire_type() if ']' not in kind and path in leaf_paths(cls))
        gets = [getter(cls, path) for path in paths]
        rows = [[get(message) for get in gets] for _, message in messages]
        return pandas.DataFrame(rows, columns=list(paths), index=pandas.Index([time for time, _ in messages], name='time_s'))

    @cached_property
    def _registry(self) -> RecordedTypes:
        """The interfaces of this recording: the student's own ones as they were, over those that can be imported now."""
        from edulaunch.interfaces import current_registry
        from edulaunch.recording.recorded_types import RecordedTypes

        return RecordedTypes(self._content.get('interfaces') or {}, current_registry())

    def _class(self, type_name: str) -> Any:
        """The class of a type. Raises RecordingError when it is unknown here, or its text in the file is wrong."""
        try:
            return self._registry.get(type_name)
        except InterfaceError as error:
            raise RecordingError(error.message, help=error.help) from None
        except RecursionError:
            raise RecordingError(f'{type_name} contains too many messages in each other') from None

    def _columns(self, topic: str) -> list[dict[str, Any]]:
        columns = [column for column in self._content['topics'] if column['topic'] == topic]
        for column in columns:
            if self._unread is not None and id(column) not in self._read:
                self._check(column['type'], column['messages'])
                self._read.add(id(column))
        return columns

    def _check(self, type_name: str, wires: list[Any]) -> None:
        """What came from a file is looked at before it is used. Raises RecordingError when it fits no message of the type."""
        self._class(type_name)
        try:
            fits = self._registry.checks.check(type_name)
        except InterfaceError as error:
            raise RecordingError(error.message, help=error.help) from None
        if not all(map(fits, wires)):
            raise RecordingError(f'{self._unread} is damaged: it has messages that are no {type_name}.')

    def trajectory(self, turtle: str) -> Trajectory:
        """Where a turtle was, as numpy arrays t, x, y, theta; `turtle` is 'turtle1', or '/ns/turtle1' with a namespace.

        A robot's odometry topic such as '/odom' works too. See :class:`~edulaunch.recording.trajectory.Trajectory`.

        :raises KeyError: when nothing of that name was recorded; the message names what was.
        """
        from edulaunch.recording.trajectory import read_trajectory

        return read_trajectory(self, turtle)

    def frames_at(self, time_s: float) -> dict[str, Frame]:
        """The newest transform of each tf child frame at a time, by child name in order of first appearance."""
        from edulaunch.recording.frames import frames_at

        return frames_at(self, time_s)

    @cached_property
    def logs(self) -> list[LogRecord]:
        """Log messages of nodes, in order."""
        return [LogRecord(row[0] / 1e9, *row[1:]) for row in self._content['logs']]

    @cached_property
    def output(self) -> list[Output]:
        """What programs wrote, in order."""
        return [Output(row[0] / 1e9, *row[1:]) for row in self._content['output']]

    @cached_property
    def notes(self) -> list[Note]:
        """What the engine noticed, in order."""
        return [Note(row[0] / 1e9, *row[1:]) for row in self._content['notes']]

    @cached_property
    def facts(self) -> list[Fact]:
        """Odd things that programs did, each with how often, in order of their first time: what advice is made of."""
        rows = self._content.get('facts') or ()
        return [Fact(time / 1e9, process, kind, data, times, last / 1e9) for time, process, kind, data, times, last in rows]

    @cached_property
    def misfits(self) -> list[Misfit]:
        """Publishers and subscriptions of one topic that could not be joined, in order of time."""
        from edulaunch.recording.misfits import misfits

        return list(misfits(self))

    @property
    def not_repeatable(self) -> list[str]:
        """Why the same launch may not give the same recording again: programs that read the real machine, and what they used;
        real programs that were started. Empty for a run that repeats.
        """
        return list(dict.fromkeys(note.text for note in self.notes if note.kind in UNREPEATABLE))

    @cached_property
    def advice(self) -> list[Any]:
        """What the rules of :mod:`edulaunch.advice` find in this run, as its Findings, the worst first."""
        found: list[Any] = attached('judge')(self)
        return found

    @property
    def warnings(self) -> list[str]:
        """What people should hear of after the run, in words: dead programs, misspelt names, and what went wrong in silence."""
        return [*map(str, map(attached('told'), self.advice))]

    @cached_property
    def service_calls(self) -> list[ServiceCall]:
        """Requests and their replies, as messages, in order of the requests."""
        calls = []
        for time, service, kind, client, request, served, replied, response in self._content['calls']:
            cls = self._class(kind)
            if self._unread is not None:
                self._check(f'{kind}_Request', [request])
                self._check(f'{kind}_Response', [] if replied is None else [response])
            answer = cls.Response.from_wire(response) if replied is not None else None
            calls.append(
                ServiceCall(time / 1e9, service, kind, client, cls.Request.from_wire(request), served, _seconds(replied), answer)
            )
        return calls

    def plot_turtles(self, time_s: float | None = None, **looks: Any) -> Any:
        """The turtle windows at a time (default: the end); for `looks` see :func:`edulaunch.canvas.plot_turtles`."""
        return attached('plot_turtles')(self, time_s, **looks)

    def plot_frames(self, time_s: float | None = None, *, side: str = 'xy', ax: Any = None) -> Any:
        """tf frames from above or from a side, at a time (default: the end); see :func:`edulaunch.canvas.plot_frames`."""
        return attached('plot_frames')(self, time_s, side=side, ax=ax)

    def plot_tf_tree(self, *, ax: Any = None) -> Any:
        """Which frame is whose parent, and who broadcasts it; see :func:`edulaunch.canvas.plot_tf_tree`."""
        return attached('plot_tf_tree')(self, ax=ax)

    def plot_graph(self, *, unused: bool = False, services: bool = False, ax: Any = None) -> Any:
        """Nodes and topics; see :func:`edulaunch.canvas.plot_graph`."""
        return attached('plot_graph')(self, unused=unused, services=services, ax=ax)

    def plot_distance(self, first: str, second: str, close_m: float = 1.0, *, ax: Any = None) -> Any:
        """How far a turtle, robot or tf frame is from another over time; see :func:`edulaunch.canvas.plot_distance`."""
        return attached('plot_distance')(self, first, second, close_m, ax=ax)

    def parameter_table(self, node: str | None = None, *, every: bool = False) -> Any:
        """Parameters with their values and where these came from; see :func:`edulaunch.canvas.parameter_table`."""
        return attached('parameter_table')(self, node, every=every)

    def replay(self) -> Any:
        """Everything of the run over time, with a slider; see :class:`edulaunch.view.replay.Replay`."""
        return attached('replay')(self)


def _seconds(time_ns: int | None) -> float | None:
    return None if time_ns is None else time_ns / 1e9


def _time_of(row: Any) -> int:
    return row[0]  # type: ignore[no-any-return]

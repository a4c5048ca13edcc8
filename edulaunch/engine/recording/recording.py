"""The recording of a run as a class, with methods that answer questions about the run."""

from __future__ import annotations

import os
from collections.abc import Mapping
from functools import cached_property
from types import MappingProxyType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.recording import file_format
from edulaunch.engine.recording.absent import NodeParameters, not_recorded
from edulaunch.engine.recording.messages import Messages, seconds
from edulaunch.engine.recording.records import (
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
    UnreadArgument,
)
from edulaunch.engine.recording.safe_file import write_safely
from edulaunch.engine.recording.views import Views, view
from edulaunch.errors import RecordingError

if TYPE_CHECKING:
    from edulaunch.engine.recording.mismatches import Mismatch
    from edulaunch.engine.recording.trajectory import Trajectory


UNREPEATABLE = ('real program', 'real machine', 'stopped', 'interrupted')
"""Kinds of notes about what differs from run to run."""


class Recording(Messages, Views):
    """A run as data: processes, nodes, parameters with their origin, every message, tf, logs.

    Times are float seconds since the start of the simulation, unless a docstring says otherwise. `edulaunch.run` and :meth:`load`
    return a recording.
    """

    command: frozenset[str] | None = None
    """Launch names of the programs of a command, if this is an excerpt for a command; otherwise None."""
    beside: Mapping[str, str] = {}
    """The commands that started the other programs of an excerpt, by launch name."""
    owners: dict[str, list[int]] | None = None
    """For 'nodes', 'parameters', 'logs' and 'output', the position in `processes` of the process behind each row. A trusted peer
    (`edulaunch.runtime.link`) knows these positions. If all rows come from one process, this has the value None.
    """
    hosted: dict[int, tuple[str, str]] | None = None
    """The package and the executable of each program that a trusted peer ran itself, by position in `processes`."""

    _lines_of_topics: Mapping[int, bytes] = MappingProxyType({})

    def __init__(self, content: dict[str, Any], lines: Mapping[int, tuple[str, int]] | None = None) -> None:
        """:param content: the parts of a recording, as plain data.
        :param lines: the file and line that created each publisher, subscription, service or client, by its index. Recording
            files do not contain these lines.
        """
        super().__init__(content)
        self.lines = dict(lines or {})
        self.seed: int = content['seed']
        self.duration_s: float = content['duration_ns'] / 1e9

    def __repr__(self) -> str:
        return (
            f'<Recording {self.duration_s:.3f} s: {len(self.processes)} processes, {len(self.nodes)} nodes, '
            f'{sum(topic.count for topic in self.topics.values())} messages>'
        )

    @classmethod
    def load(cls, path: str | os.PathLike[str], *, trusted: bool = False) -> Recording:
        """Read a recording file.

        :param path: the path of the file.
        :param trusted: whether to read the file without a size limit. A recording from an unknown source could take all memory.
        :raises RecordingError: if the file is missing, damaged, too large, or not a recording.
        """
        name = os.fspath(path)
        try:
            if os.path.exists(name) and not os.path.isfile(name):
                raise RecordingError(f'cannot read the recording {name!r}: it is not a file')
            with open(name, 'rb') as file:
                data = file.read(-1 if trusted else file_format.MOST_BYTES + 1)
        except (OSError, ValueError) as error:
            raise RecordingError(f'cannot read the recording {name!r}: {getattr(error, "strerror", None) or error}') from None
        if not trusted:
            file_format.refuse_huge(data, name)
        return cls.from_bytes(data, name)

    @classmethod
    def from_bytes(cls, data: bytes, name: str = 'this input', *, is_ours: bool = False) -> Recording:
        """Return a recording from the bytes of :meth:`to_bytes`.

        :param name: the name of the recording, for error messages.
        :param is_ours: whether this edulaunch wrote the bytes. Then :meth:`digest` can use the lines of topics unchanged.
        :raises RecordingError: if the bytes are not a recording.
        """
        recording = cls(file_format.decode(data, name))
        recording._unread = name
        recording._lines_of_topics = file_format.lines_of_topics(data, recording._content) if is_ours else {}
        return recording

    def to_bytes(self) -> bytes:
        """Return the recording as JSON lines, with the same bytes for the same run."""
        return file_format.encode(self._content)

    def save(self, path: str | os.PathLike[str]) -> None:
        """Write a recording file, either completely or not at all.

        A path that is not a regular file (`/dev/stdout`, a pipe) is written to directly. If the file cannot be written, an older
        recording with this path does not change.

        :param path: the path of the file, usually with the ending .rec.
        :raises RecordingError: if the file cannot be written.
        """
        try:
            write_safely(path, file_format.lines_of(self._content))
        except OSError as error:
            raise RecordingError(f'cannot write the recording {os.fspath(path)!r}: {error.strerror or error}') from None
        except MemoryError:
            raise RecordingError(f'cannot write the recording {os.fspath(path)!r}: this computer has no memory left') from None

    def digest(self) -> str:
        """Return the SHA-256 hash of all events. The hash is equal for the same launch file, arguments and seed, on every
        machine.

        The hash does not cover the records of other parts of edulaunch (`Recorder.beside`). It does not depend on the path of
        the launch files, so a copy of a workspace gives the same digest.
        """
        import hashlib

        from edulaunch.engine.recording.canonical import canonical

        content = {**canonical(self._content), 'beside': {}}
        return hashlib.sha256(file_format.encode(content, self._lines_of_topics)).hexdigest()

    @cached_property
    def launch(self) -> LaunchRecord:
        """The launch file, its declared arguments, and the return code of launch."""
        fields = {**self._content['launch']}
        for words in ('warnings', 'help'):  # older recordings lack them, so they are computed again
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
        fields = [dict(row) for row in self._content['processes']]
        times = [{'started_s': row.pop('started') / 1e9, 'ended_s': seconds(row.pop('ended'))} for row in fields]
        return [ProcessRecord(**row, **span) for row, span in zip(fields, times, strict=True)]

    @cached_property
    def nodes(self) -> list[NodeRecord]:
        """The nodes of the run in order of creation, with all their topics and services."""
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
                seconds(end),
                *(ends.get(index, {}).get(kind, []) for kind in ('publisher', 'subscription', 'service', 'client')),
            )
            for name, process, start, end, index in self._content['nodes']
        ]

    @cached_property
    def ends(self) -> list[EndRecord]:
        """All publishers, subscriptions, services and clients, in order of creation."""
        nodes = {row[4]: row[0] for row in self._content['nodes']}
        return [
            EndRecord(kind, name, type_name, nodes.get(node, ''), made / 1e9, qos)
            for kind, name, type_name, node, _, made, qos in self._content['endpoints']
        ]

    def parameters(self, node: str) -> dict[str, Parameter]:
        """Return the parameters of a node at the end of the run, by name, in order of declaration.

        :param node: the full name of the node, such as '/sim'.
        :raises KeyError: for an unknown node; the message lists the nodes of the run.
        """
        found: dict[str, Parameter] = NodeParameters(node, next((end.ended_s for end in self.nodes if end.name == node), None))
        rows = [row for row, values in enumerate(self.parameter_rows) if values[1] == node]
        hosted = [row for row in rows if self.owners and self.owners['parameters'][row] in (self.hosted or ())]
        for row in hosted or rows:  # prefer the hosted node over another node of the same name
            _, _, parameter, value, origin = self.parameter_rows[row]
            if value is None:
                found.pop(parameter, None)
            else:
                found[parameter] = Parameter(value, origin)
        if not found and node not in {record.name for record in self.nodes}:
            raise not_recorded(f'no node {node!r}', node, (record.name for record in self.nodes))
        return found

    @cached_property
    def parameter_rows(self) -> list[tuple[int, str, str, Any, str]]:
        """Every value that was set, in order: (time in ns, node, parameter, value, origin). A row with the value None means
        that the parameter was undeclared.
        """
        return list(map(tuple, self._content['parameters']))

    @cached_property
    def own_processes(self) -> list[ProcessRecord]:
        """The processes that run a student's program, without programs of edulaunch and `ros2` commands."""
        ours = tuple(os.path.join(path, '') for path, name in self._content['roots'] if name == '@underlay')
        return [row for row in self.processes if not _is_program_of(ours, row.argv) and os.path.basename(row.argv[0]) != 'ros2']

    def trajectory(self, turtle: str) -> Trajectory:
        """Return the path of a turtle or robot as numpy arrays t, x, y, theta.

        t is in seconds since the start, x and y are in metres, and theta is in radians. See
        :class:`~edulaunch.engine.recording.trajectory.Trajectory`.

        :param turtle: 'turtle1', '/ns/turtle1' with a namespace, or the odometry topic of a robot, such as '/odom'.
        :raises KeyError: for an unknown name; the message lists the known names.
        """
        from edulaunch.engine.recording.trajectory import read_trajectory

        return read_trajectory(self, turtle)

    def frames_at(self, time_s: float) -> dict[str, Frame]:
        """Return the newest transform of each tf child frame at a given time, by child frame.

        The frames are in order of first appearance.

        :param time_s: seconds since the start of the run.
        """
        from edulaunch.engine.recording.frames import frames_at

        return frames_at(self, time_s)

    @cached_property
    def logs(self) -> list[LogRecord]:
        """The log messages of nodes, in order."""
        return [LogRecord(row[0] / 1e9, *row[1:]) for row in self._content['logs']]

    @cached_property
    def output(self) -> list[Output]:
        """The output of programs, in order."""
        return [Output(row[0] / 1e9, *row[1:]) for row in self._content['output']]

    @cached_property
    def notes(self) -> list[Note]:
        """The messages of the engine to the user, in order."""
        return [Note(row[0] / 1e9, *row[1:]) for row in self._content['notes']]

    @cached_property
    def facts(self) -> list[Fact]:
        """Unusual actions of programs with their counts, in order of first occurrence. The rules of advice use them."""
        rows = self._content.get('facts') or ()
        return [Fact(time / 1e9, process, kind, data, times, last / 1e9) for time, process, kind, data, times, last in rows]

    @cached_property
    def mismatches(self) -> list[Mismatch]:
        """The pairs of a publisher and a subscription of one topic that were not connected, in order of time."""
        from edulaunch.engine.recording.mismatches import mismatches

        return list(mismatches(self.nodes, self.notes))

    @property
    def not_repeatable(self) -> list[str]:
        """The reasons why the same launch may give another recording: real programs, and programs that used facts about the real
        machine.

        The list is empty for a run that repeats exactly.
        """
        return list(dict.fromkeys(note.text for note in self.notes if note.kind in UNREPEATABLE))

    @cached_property
    def advice(self) -> list[Any]:
        """The findings of the rules of :mod:`edulaunch.advice` about this run, the worst first."""
        found: list[Any] = view('judge')(self)
        return found

    @property
    def warnings(self) -> list[str]:
        """The findings of :attr:`advice` as sentences: programs that died, misspelt names, and other problems without an
        error.
        """
        return [*map(str, map(view('sentences'), self.advice))]


def _is_program_of(folders: tuple[str, ...], argv: list[str]) -> bool:
    """Return whether a command line runs a program below the folders, directly or after a prefix such as `xterm -e`."""
    library = f'{os.sep}lib{os.sep}'
    return argv[0].startswith(folders) or any(word.startswith(folders) and library in word for word in argv[1:4])

"""Convert a run to plain data for the page: deltas with new records, and marks on nodes, topics and frames.

The first delta of a finished recording contains the whole recording. A live machine sends the changes since the last delta.
Times are whole microseconds since the start of the simulation. The marks come from the rules of advice. This module only
defines their format.
"""

from __future__ import annotations

import os
from bisect import bisect_left
from collections.abc import Callable, Iterable, Mapping, Sequence
from typing import TYPE_CHECKING, Any, NamedTuple, Protocol

from edulaunch.canvas.outlines import FOOTPRINTS, outline_of, outline_of_footprint
from edulaunch.desk.view.columns import FINE, number_steps, text_steps
from edulaunch.desk.view.launches import in_microseconds
from edulaunch.engine.recording.frames import TF_TYPE

if TYPE_CHECKING:
    from edulaunch.advice.rendering import Mark
    from edulaunch.engine.recording import Recording

SUBJECTS = ('node', 'topic', 'frame')
NUMBERS = {'bool', 'char', 'int8', 'uint8', 'int16', 'uint16', 'int32', 'uint32', 'int64', 'uint64'}
FLOATS = {'float32', 'float64'}
TEXT_TYPE = 'std_msgs/msg/String'
SCAN_TYPE = 'sensor_msgs/msg/LaserScan'
SCAN_EVERY_US = 200_000
"""The page shows five scans per second, because each contains hundreds of numbers."""
LONGEST_TEXT = 160
"""The page shows this many characters of an array or string field."""


def marks_of(recording: Recording) -> list[Mark]:
    """Return the advice on a run as marks. The marks contain no paths of this computer, because notebooks store them."""
    from edulaunch.advice.rendering import marks  # imported here, so that a page loads the rules only on request

    return marks(recording)


def mark_rows(marks: Iterable[Mark]) -> list[dict[str, Any]]:
    """Return marks as plain data: `[{time (us), subject: {node | topic | frame: name}, text, rule}]`."""
    return [
        {
            'time': round(mark.time_s * 1e6),
            'subject': {mark.subject[0]: mark.subject[1]} if mark.subject[0] in SUBJECTS else {},
            'text': mark.text,
            'rule': mark.rule,
        }
        for mark in marks
    ]


class TimelineSource(Protocol):
    """The interface of the sources of a timeline: the recorder of a live machine, and a finished recording."""

    def rows(self, topic: str, kind: str, first: int) -> tuple[Sequence[int], Sequence[int], Sequence[Any]]:
        """Return the times (ns since the start), publishers and wire tuples of a topic's messages.

        :param topic: the name of the topic.
        :param kind: the message type of the topic.
        :param first: the number of the first message to return, counted over the whole run.
        """

    def topics(self) -> list[tuple[str, str]]:
        """Return the (name, type) of each topic."""

    def part(self, name: str) -> Sequence[Any]:
        """Return the rows of a part of the recording.

        :param name: 'processes', 'nodes', 'endpoints', 'parameters', 'descriptors', 'calls', 'logs', 'output' or 'notes'.
        """

    def numbers(self, name: str) -> Sequence[int]:
        """Return the number of each row of a part, counted over the whole run. During a long run, old rows are dropped."""

    def forgotten(self, topic: tuple[str, str]) -> int:
        """Return the number of dropped messages of a (topic, type)."""

    def wire_type(self, kind: str) -> Sequence[tuple[str, str]]:
        """Return (dotted path, type) for each entry of a type's wire tuple."""

    def lines(self) -> Mapping[int, tuple[str, int]]:
        """Return the file and line that created each endpoint, by the number of the endpoint.

        Only code of students is included.
        """

    def beside(self, name: str, since: Mapping[int, int]) -> Sequence[dict[str, Any]]:
        """Return the records of another part of edulaunch (see `Recorder.beside`).

        :param name: the name of these records, such as 'launches'.
        :param since: the counts that the previous call returned, by process id.
        """

    def start_ns(self) -> int:
        """Return the time at which the simulation started, in nanoseconds since the epoch."""

    def now_ns(self) -> int:
        """Return the simulated time since the start in nanoseconds."""


class _Column(NamedTuple):
    """A field of a message type that is a number or a string: its path, its place in a wire tuple, and its form.

    The form is 'float', 'number' or 'text'.
    """

    path: str
    place: int
    how: str


class Timeline:
    """Returns the content of a source in consecutive deltas, with :meth:`delta`."""

    def __init__(self, source: TimelineSource) -> None:
        self._source = source
        self._marks: list[dict[str, Any]] | None = None
        self._sent: dict[tuple[str, str], int] = {}
        self._layout: dict[str, list[_Column]] = {}
        self._last: dict[Any, Any] = {}
        self._rows: dict[str, int] = {}
        self._open: dict[str, list[int]] = {}
        self._launches: dict[int, tuple[int, Any]] = {}

    def mark(self, marks: Iterable[Mark] | None) -> None:
        """Send these marks with the next delta. The new marks replace the previous marks on the page; None keeps the previous
        marks.
        """
        self._marks = None if marks is None else mark_rows(marks)

    def delta(self) -> dict[str, Any]:
        """Return the changes since the last call as data for JSON.

        The delta contains `start` (us since the epoch), `now` (us), `topics`, `tf`, `scans`, and the new rows of all other parts.
        After :meth:`mark`, it also contains `advice`.
        """
        source = self._source
        delta: dict[str, Any] = {
            'start': source.start_ns() // 1000,
            'now': source.now_ns() // 1000,
            'topics': [],
            'tf': [],
            'scans': [],
            'robots': [],
        }
        for topic, kind in source.topics():
            first = max(self._sent.get((topic, kind), 0), source.forgotten((topic, kind)))
            times, publishers, wires = source.rows(topic, kind, first)
            if len(times) or not first:
                self._sent[topic, kind] = first + len(times)
                delta['topics'].append(self._columns(topic, kind, times, wires))
                if kind == TF_TYPE:
                    delta['tf'] += self._transforms(topic, times, publishers, wires)
                elif kind == TEXT_TYPE and topic.endswith('/robot_description'):
                    delta['robots'] += self._robots(topic, times, wires)
                elif kind == SCAN_TYPE:
                    delta['scans'] += self._scans(topic, times, wires)
        endpoints, lines = self._new('endpoints'), source.lines()
        delta['endpoints'] = [_endpoint(row) for row in endpoints]
        delta['places'] = [[row[4], _place(*lines[row[4]])] for row in endpoints if row[4] in lines]
        parameters = self._new('parameters')
        delta['parameters'] = [_parameter(row) for row in parameters]
        for time, node, name, value, _ in parameters:
            if name in FOOTPRINTS and (outline := outline_of_footprint(str(value))):
                delta['robots'].append([time // 1000, node, False, outline])
        for name in ('descriptors', 'logs', 'output', 'notes'):
            delta[name] = [_event(row) for row in self._new(name)]
        for name, row_of, end in (('nodes', _node, 3), ('processes', _process, 'ended'), ('calls', _call, 6)):
            delta[name] = self._living(name, row_of, end)
        delta['launches'] = self._launched()
        delta = {name: value for name, value in delta.items() if value != []}
        if self._marks is not None:
            delta['advice'], self._marks = self._marks, None
        return delta

    def _launched(self) -> list[dict[str, Any]]:
        """Return the launches that have changed since the last delta. Each launch contains only its new and changed steps."""
        found = []
        for trace in self._source.beside('launches', {pid: count for pid, (count, _) in self._launches.items()}):
            state = trace['count'], trace['at']
            if self._launches.get(trace['pid']) != state:
                self._launches[trace['pid']] = state
                found.append(in_microseconds(trace))
        return found

    def _new(self, name: str) -> Sequence[Any]:
        numbers = self._source.numbers(name)
        first = bisect_left(numbers, self._rows.get(name, 0))
        if numbers:
            self._rows[name] = numbers[-1] + 1
        return self._source.part(name)[first:]

    def _living(self, name: str, row_of: Callable[[int, Any], list[Any]], end: Any) -> list[list[Any]]:
        """Return the new rows of a part, and the old rows that have ended since the last delta. Each row begins with its number.

        :param name: the name of the part, such as 'nodes'.
        :param row_of: a function that converts a row to plain data.
        :param end: the index or key of a value of the row. This value stays None until the row ends.
        """
        numbers, new = self._source.numbers(name), self._new(name)
        rows = self._source.part(name)
        found = [(number, bisect_left(numbers, number)) for number in self._open.get(name, ())]
        open_before = [(number, rows[at]) for number, at in found if at < len(rows) and numbers[at] == number]
        new_rows = list(zip(numbers[len(numbers) - len(new) :], new, strict=True))
        self._open[name] = [number for number, row in [*open_before, *new_rows] if row[end] is None]
        return [row_of(number, row) for number, row in [*(pair for pair in open_before if pair[1][end] is not None), *new_rows]]

    def _columns(self, topic: str, kind: str, times: Sequence[int], wires: Sequence[Any]) -> dict[str, Any]:
        """Return the messages of a topic as columns: one for the times, and one for each field that is a number or a string."""
        if kind not in self._layout:
            self._layout[kind] = _layout(self._source.wire_type(kind)) if kind != TF_TYPE else []
        found: dict[str, Any] = {'name': topic, 'type': kind}
        found['t'] = self._steps((topic, kind, 't'), (time // 1000 for time in times), 1)
        layout = self._layout[kind]
        found['fields'] = [[column.path, column.how] for column in layout]
        found['c'] = [self._leaf((topic, kind, column.place), column, wires) for column in layout]
        return found

    def _leaf(self, key: Any, column: _Column, wires: Sequence[Any]) -> list[Any]:
        place = column.place
        if column.how == 'text':
            steps, self._last[key] = text_steps((_text(wire[place]) for wire in wires), self._last.get(key))
            return steps
        return self._steps(key, (wire[place] for wire in wires), FINE if column.how == 'float' else 1)

    def _steps(self, key: Any, values: Iterable[float], scale: int) -> list[Any]:
        steps, self._last[key] = number_steps(values, scale, self._last.get(key, 0))
        return steps

    def _transforms(
        self, topic: str, times: Sequence[int], publishers: Sequence[int], wires: Sequence[Any]
    ) -> list[dict[str, Any]]:
        """Return the transforms of TFMessages, as one track for each combination of child, parent and publisher."""
        tracks: dict[tuple[str, str, int], list[tuple[float, ...]]] = {}
        for time, publisher, wire in zip(times, publishers, wires, strict=True):
            for sec, nanosec, parent, child, *numbers in wire[0]:
                stamp = sec * 1_000_000 + nanosec // 1000
                tracks.setdefault((child, parent, publisher), []).append((time // 1000, stamp, *numbers))
        found = []
        for (child, parent, publisher), rows in tracks.items():
            key = (topic, child, parent, publisher)
            scales = (1, 1, *[FINE] * 3, *[FINE * 100] * 4)
            columns = [self._steps((*key, i), [row[i] for row in rows], scale) for i, scale in enumerate(scales)]
            found.append({'child': child, 'parent': parent, 'by': publisher, 'static': topic == '/tf_static', 'c': columns})
        return found

    def _robots(self, topic: str, times: Sequence[int], wires: Sequence[Any]) -> list[list[Any]]:
        """Return [time, namespace, is a description, outline from above] of robots. The third value is False for a footprint."""
        found = []
        for time, wire in zip(times, wires, strict=True):
            if outline := outline_of(wire[0]):
                found.append([time // 1000, topic.removesuffix('/robot_description'), True, outline])
        return found

    def _scans(self, topic: str, times: Sequence[int], wires: Sequence[Any]) -> list[list[Any]]:
        """Return [topic, time, frame, first angle, step, ranges] of some scans.

        Angles are in radians. Ranges are in centimetres, or None.
        """
        places = {path: place for place, (path, _) in enumerate(self._source.wire_type(SCAN_TYPE))}
        found = []
        for time, wire in zip(times, wires, strict=True):
            key = ('scan', topic)
            if time // 1000 - self._last.get(key, -SCAN_EVERY_US) >= SCAN_EVERY_US:
                self._last[key] = time // 1000
                range_min = wire[places['range_min']]
                range_max = wire[places['range_max']]
                ranges = [round(value * 100) if range_min <= value <= range_max else None for value in wire[places['ranges']]]
                angles = (round(wire[places[name]], 5) for name in ('angle_min', 'angle_increment'))
                found.append([topic, time // 1000, wire[places['header.frame_id']], *angles, ranges])
        return found


def _layout(wire_type: Sequence[tuple[str, str]]) -> list[_Column]:
    return [
        _Column(path, place, 'float' if kind in FLOATS else 'number' if kind in NUMBERS or kind == 'boolean' else 'text')
        for place, (path, kind) in enumerate(wire_type)
    ]


def _text(value: Any) -> str:
    """Return a string, or the representation of another value. A long string is shortened."""
    text = value if isinstance(value, str) else repr(list(value[:24]) if isinstance(value, (tuple, bytes)) else value)
    return text if len(text) <= LONGEST_TEXT else text[: LONGEST_TEXT - 1] + '…'


def _event(row: Sequence[Any]) -> list[Any]:
    """Return a row as plain data. It begins with a time, which is converted to microseconds."""
    return [row[0] // 1000, *map(_json, row[1:])]


def _parameter(row: Sequence[Any]) -> list[Any]:
    """Return [time, node, name, value, origin, is double].

    The last value is needed because a browser cannot distinguish 1.0 from 1.
    """
    value = row[3]
    entries = value if isinstance(value, (list, tuple)) else [value]
    return [*_event(row), bool(entries) and all(isinstance(entry, float) for entry in entries)]


def _endpoint(row: Sequence[Any]) -> list[Any]:
    """Return [time, kind, name, type, number of the node, number of the endpoint, QoS]."""
    *what, time, qos = row
    return [time // 1000, *what, _json(qos)]


def _json(value: Any) -> Any:
    if value is None or isinstance(value, (bool, int, str)):
        return value
    if isinstance(value, float):
        return value if value - value == 0 else str(value)
    if isinstance(value, bytes):
        return list(value)
    return [_json(entry) for entry in value] if isinstance(value, (list, tuple)) else str(value)


def _place(file: str | None, line: int | None) -> str:
    """Return a place as 'file:line' without folders, or an empty string if there is no file."""
    return '' if not file else f'{os.path.basename(file)}:{line}'


def _node(number: int, row: Sequence[Any]) -> list[Any]:
    """Return [number, name, process, index, start, end]."""
    name, process, start, end, index = row
    return [number, name, process, index, start // 1000, None if end is None else end // 1000]


def _process(number: int, row: Any) -> list[Any]:
    """Return [number, name, pid, argv, start, end, return code, place of the launch action]."""
    end = row['ended']
    return [
        number,
        row['name'],
        row['pid'],
        list(row['argv']),
        row['started'] // 1000,
        None if end is None else end // 1000,
        row['returncode'],
        _place(row.get('file'), row.get('line')),
    ]


def _call(number: int, row: Sequence[Any]) -> list[Any]:
    """Return [number, time, service, type, client, request, served, replied]. The request is a list of its fields."""
    time, service, kind, client, request, served, replied, _ = row
    return [number, time // 1000, service, kind, client, _json(request), served, None if replied is None else replied // 1000]

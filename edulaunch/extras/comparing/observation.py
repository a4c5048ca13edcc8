"""The observation of a run from outside, in the same terms for simulations and real runs. Times are seconds since launch
began.
"""

from __future__ import annotations

import re
from collections.abc import Callable, Iterable, Iterator
from typing import Any, NamedTuple

from edulaunch.engine.interfaces.message import Message

ClassOf = Callable[[str], type[Message]]
NOT_COMPARED = ('/rosout', '/parameter_events')
"""The topics whose messages are compared in another form, as output or as parameters."""
BRIEFLY = float('inf')
_HIDDEN_NODE = re.compile(r'/(_|launch_ros_\d)')
_STAMPED_LOG = re.compile(r'\[\d{9,}\.\d+\]')
_NUMBER = re.compile(r'-?\d+(\.\d+)?(e[+-]?\d+)?')
_ROW = re.compile(r'#(,? +#)+')
_UNIQUE = re.compile(r'\b[0-9a-f]{32}\b|0x[0-9a-f]+|(?<=_)[A-Za-z0-9]{16}(?=\W|$)|(?<=edulaunch-compare-)\w+')
_SOURCE = re.compile(r', at /\S+\.\w+:\d+')
"""The place in rcl's own source where it found an error."""
_NOISE = re.compile(r'\x1b\[[\d;]*m\[?\x1b|RTPS_TRANSPORT_SHM')
"""Output of Fast DDS itself about other processes of this computer."""
_TRANSFORMS = 'tf2_msgs/msg/TFMessage'


class End(NamedTuple):
    """A publisher, subscription, service or client (`kind`) of a node."""

    kind: str
    name: str
    type: str
    node: str


class Range(NamedTuple):
    """The values of a field. Numbers become a range (without numbers, `low` is above `high`), and strings become a set."""

    low: float
    high: float
    texts: frozenset[str]

    def __str__(self) -> str:
        if self.texts:
            return ', '.join(sorted(map(repr, self.texts))[:3])
        if self.low > self.high:
            return 'nothing'
        return f'{self.low:.6g}' if self.low == self.high else f'{self.low:.6g} to {self.high:.6g}'


class Values:
    """One field of a topic over time: its numbers, and its strings with numbers masked."""

    def __init__(self) -> None:
        self._numbers: list[tuple[float, float]] = []
        self._texts: dict[str, float] = {}

    def add(self, time_s: float, value: Any) -> None:
        """Add a value."""
        if isinstance(value, str):
            self._texts.setdefault(masked(value), time_s)
        elif isinstance(value, (bool, int, float)):
            self._numbers.append((time_s, value))
        elif len(value) > 2 and not isinstance(value[0], str):
            self.add(time_s, min(value))
            self.add(time_s, max(value))
        else:
            for each in value:
                self.add(time_s, each)

    def between(self, begin_s: float, end_s: float) -> Range:
        """Return the range of the values between two times."""
        numbers = [value for time_s, value in self._numbers if begin_s <= time_s <= end_s]
        texts = frozenset(text for text, time_s in self._texts.items() if begin_s <= time_s <= end_s)
        return Range(min(numbers, default=float('inf')), max(numbers, default=float('-inf')), texts)

    @property
    def range(self) -> Range:
        """Return the range of the values in the whole run."""
        return self.between(float('-inf'), float('inf'))


class Flow(NamedTuple):
    """The messages of a topic, or the transforms from one frame to another."""

    times: list[float]
    fields: dict[str, Values]


class Line(NamedTuple):
    """A line of a program's output, with numbers masked."""

    process: str
    text: str
    time_s: float


class Program(NamedTuple):
    """A program's start, end (None while it runs) and known nodes, and the times of its first signal and first line."""

    started_s: float
    ended_s: float | None = None
    returncode: int | None = None
    nodes: frozenset[str] = frozenset()
    signalled_s: float = BRIEFLY
    spoke_s: float = BRIEFLY


class Observation(NamedTuple):
    """The nodes, endpoints, parameters, messages, output and programs that were observed in a run.

    :ivar nodes: when each node first existed; :data:`BRIEFLY` for a node that ended before all programs can have found it.
    :ivar ends: the QoS (reliability and durability) and the first appearance of endpoints, as for nodes.
    :ivar parameters: the parameters at the end, by node.
    :ivar flows: the messages by topic, and the transforms by 'tf a -> b'.
    :ivar lines: the output of programs.
    :ivar programs: the programs by launch name.
    :ivar asked_s: when Ctrl-C was pressed.
    :ivar start_s: when launch began, in seconds since 1970.
    """

    nodes: dict[str, float]
    ends: dict[End, tuple[str, float]]
    parameters: dict[str, dict[str, Any]]
    flows: dict[str, Flow]
    lines: list[Line]
    programs: dict[str, Program]
    asked_s: float
    start_s: float = 0.0

    @property
    def codes(self) -> dict[str, list[int]]:
        """Return the exit codes of each program that has ended, by launch name without its number."""
        codes: dict[str, list[int]] = {}
        for name, program in self.programs.items():
            if program.returncode is not None:
                codes.setdefault(program_of(name), []).append(program.returncode)
        return codes

    def until_asked(self) -> Observation:
        """Return the observation without the effects of Ctrl-C."""
        lines = [line for line in self.lines if line.time_s < self.asked_s]
        programs = {
            name: program._replace(ended_s=None, returncode=None) if (program.ended_s or 0.0) >= self.asked_s else program
            for name, program in self.programs.items()
        }
        return self._replace(lines=lines, programs=programs)


def is_compared(node: str) -> bool:
    """Return whether a node belongs to the launch file, not to a command, an observer or launch itself."""
    return _HIDDEN_NODE.search(node) is None


def masked(text: str) -> str:
    """Return a line of output with times, IDs and numbers replaced by `#`, because they vary between runs."""
    text = _UNIQUE.sub('#', _STAMPED_LOG.sub('[#]', _SOURCE.sub('', text)))
    return _ROW.sub('#', _NUMBER.sub('#', text)).rstrip()


def steady_name(node: str) -> str:
    """Return the name of a node without its random letters (`static_transform_publisher_ezuB4ij12Li9ZFsK`)."""
    return _UNIQUE.sub('#', node)


def lines_of(process: str, pieces: Iterable[tuple[float, str]]) -> Iterator[Line]:
    """Return the lines of a program's output. A traceback is reduced to its error, because its frames differ in a real run."""
    rest, in_traceback, last_s = '', False, 0.0
    for time_s, piece in (*pieces, (None, '\n')):
        last_s = last_s if time_s is None else time_s
        *whole, rest = (rest + piece).split('\n')
        for text in whole:
            in_traceback = text.startswith('Traceback ') or (in_traceback and text.startswith(' '))
            if text.strip() and not in_traceback and not _NOISE.search(text):
                yield Line(process, masked(text), last_s)


def program_of(name: str) -> str:
    """Return a launch name without its number, such as 'talker' for 'talker-1'."""
    return name.rpartition('-')[0] or name


def add_messages(
    flows: dict[str, Flow], topic: str, type_name: str, rows: Iterable[tuple[float, Any]], class_of: ClassOf
) -> None:
    """Add the messages of a topic, given as rows (seconds, wire tuple)."""
    for time_s, wire in rows:
        if type_name == _TRANSFORMS:
            for transform in wire[0]:
                flow = flows.setdefault(f'tf {transform[2]} -> {transform[3]}', Flow([], {}))
                flow.times.append(time_s)
                _add(flow.fields, '', class_of('geometry_msgs/msg/TransformStamped'), time_s, transform, class_of)
        else:
            flow = flows.setdefault(topic, Flow([], {}))
            flow.times.append(time_s)
            _add(flow.fields, '', class_of(type_name), time_s, wire, class_of)


def _add(
    fields: dict[str, Values], before: str, cls: type[Message], time_s: float, wire: tuple[Any, ...], class_of: ClassOf
) -> None:
    for (path, text), value in zip(cls.wire_type(), wire, strict=True):
        nested, bracket, _ = text.partition('[')
        if path.endswith(('stamp.sec', 'stamp.nanosec')) or cls.TYPE == 'builtin_interfaces/msg/Time' or 'goal_id' in path:
            continue
        if bracket and '/' in nested:
            for each in value:
                _add(fields, f'{before}{path}[].', class_of(nested), time_s, each, class_of)
        else:
            fields.setdefault(before + path, Values()).add(time_s, value)

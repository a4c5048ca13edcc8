"""Collects the events of a simulation. Recording a publication costs only one call of `list.extend`."""

from __future__ import annotations

from bisect import bisect_right
from collections.abc import Callable, Hashable, Iterator, Sequence
from typing import TYPE_CHECKING, Any, Protocol

from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.tracer import Look, Record, Tracer
from edulaunch.engine.processes.frame_owner import student_line

if TYPE_CHECKING:
    from edulaunch.engine.processes.finding import Overlay
    from edulaunch.engine.processes.process import Process
    from edulaunch.engine.recording.recording import Recording
    from edulaunch.engine.sim.simulation import Simulation


MOST_ROOTS = 500
"""No more places are kept, so that a machine that runs for hours stays small."""


class Beside(Protocol):
    """A record about a process that another part of edulaunch keeps."""

    @property
    def pid(self) -> int:
        """The number of the process."""

    def as_data(self, since: int = 0) -> dict[str, Any]:
        """Return the entries as plain data, without the first `since` entries."""


class Recorder(Tracer):
    """A tracer that records all events, in order, until :meth:`stop`. Most times are integer nanoseconds since the start.

    :ivar forgotten: the number of dropped messages of each (topic, type), and of dropped rows of each part; see
        :meth:`numbers`.
    :ivar lines: the file and line of the student's code that created each publisher, subscription, service or client, by its
        index.
    :ivar groups: for each process id, the process id of the program that was started in the same terminal or session.
    :ivar pids: the process id of each node's program, by the node's index.
    :ivar beside: the records of other parts of edulaunch, by name. Recording files contain them, but the digest does not
        cover them.
    :ivar overlay: the student's workspaces, or None. Their message types are recorded with the messages.
    """

    def __init__(self, sim: Simulation) -> None:
        self.sim = sim
        self.on = True
        self.launch: dict[str, Any] = {}
        self.roots: list[list[str]] = []
        self.beside: dict[str, Sequence[Beside]] = {}
        self.overlay: Overlay | None = None
        self.columns: dict[tuple[str, str], list[Any]] = {}
        self.endpoints: list[list[Any]] = []
        self.nodes: list[list[Any]] = []
        self.processes: list[dict[str, Any]] = []
        self.parameters: list[list[Any]] = []
        self.descriptors: list[list[Any]] = []
        self.calls: list[list[Any]] = []
        self.logs: list[list[Any]] = []
        self.output_lines: list[list[Any]] = []
        self.notes: list[list[Any]] = []
        self.facts: dict[tuple[Any, str, Hashable], list[Any]] = {}
        self.looks: dict[NodeEntry, Look] = {}
        self.forgotten: dict[Any, int] = {}
        self.groups: dict[int, int] = {}
        self.pids: dict[int, int] = {}
        self.lines: dict[int, tuple[str, int]] = {}
        self._numbers: dict[str, list[int]] = {}
        self._node_row: dict[NodeEntry, list[Any]] = {}
        self._process_row: dict[Any, dict[str, Any]] = {}
        self._call_row: dict[tuple[int, int], list[Any]] = {}
        self._duration_ns = 0

    def _now(self) -> int:
        return self.sim.now_ns - self.sim.start_ns

    def stop(self) -> None:
        """Stop recording. Call this before the clean-up at the end of a run, which is not part of the run."""
        if self.on:
            self.on = False
            self._duration_ns = self._now()

    def recording(self) -> Recording:
        """Stop recording, and return the collected data as a Recording."""
        from edulaunch.engine.recording.recording import Recording

        self.stop()
        return Recording(self.content(), self.lines)

    def content(self) -> dict[str, Any]:
        """Return the recorded data as plain data, in a fixed order."""
        start = self.sim.start_ns
        end = start + self._duration_ns
        topics = [_column(topic, kind, flat, start, end) for (topic, kind), flat in sorted(self.columns.items())]
        return {
            'seed': self.sim.seed,
            'start_ns': start,
            'duration_ns': self._duration_ns,
            'roots': self.roots,
            'launch': self.launch,
            'processes': self.processes,
            'nodes': self.nodes,
            'endpoints': self.endpoints,
            'parameters': self.parameters,
            'calls': self.calls,
            'logs': self.logs,
            'output': self.output_lines,
            'notes': self.notes,
            'facts': self.facts_now(),
            'descriptors': self.descriptors,
            'interfaces': self.interfaces({row[2] for row in (*self.endpoints, *self.calls)}),
            'beside': {name: [one.as_data() for one in many] for name, many in self.beside.items() if many},
            'topics': topics,
        }

    def facts_now(self) -> list[list[Any]]:
        """Return the facts that still hold, including facts about live nodes, in the order in which they were first recorded."""
        return sorted((row for _, row in self.facts_of()), key=lambda row: row[0])

    def facts_of(self) -> Iterator[tuple[int, list[Any]]]:
        """Yield (process id, fact) for each fact that still holds."""
        yield from ((key[0].pid, row) for key, row in self.facts.items())
        now = self._now()
        for node, look in self.looks.items():
            for kind, data in look():
                yield node.process.pid, [now, node.process.name, kind, data, 1, now]

    def leads(self, pid: int) -> bool:
        """Return whether a program was started directly in a terminal or session, and not by another program."""
        return self.groups.get(pid) == pid

    def interfaces(self, used: set[str]) -> dict[str, str]:
        """Return the definitions of the student's own types among `used`. They make messages readable without the workspace."""
        if self.overlay is None or not self.overlay.interface_packages:
            return {}
        from edulaunch.engine.interfaces.texts import texts_of

        return texts_of(self.overlay.registry, used)

    def channel(self, publisher: Any) -> Callable[[Record], object]:
        """Return the `extend` method of the list for a topic and type. Each publication adds three entries to this list.

        The list is flat, because a list of a million records would take three times the memory and slow down the garbage
        collector.
        """
        return self.columns.setdefault((publisher.topic_name, publisher.type_name), []).extend

    def forget_before(self, at_ns: int, kept: int) -> None:
        """Delete old records, except for records of live nodes and the last value of each parameter.

        :param at_ns: the simulated time in ns; older records are deleted.
        :param kept: the number of messages to keep, however old they are, of each topic with an endpoint. Records of their
            publishers stay, too.
        """
        alive = {end.name for node in self._node_row for end in node.endpoints}
        for key, flat in self.columns.items():
            most = len(flat) // 3 - (kept if key[0] in alive else 0)
            count = max(0, min(bisect_right(flat[::3], at_ns), most))
            del flat[: 3 * count]
            self.forgotten[key] = self.forgotten.get(key, 0) + count
        since = at_ns - self.sim.start_ns
        for name in ('output_lines', 'logs', 'notes', 'calls'):
            rows = getattr(self, name)
            count = bisect_right([row[0] for row in rows], since)
            del rows[:count]
            self.forgotten[name] = self.forgotten.get(name, 0) + count
        self._call_row = {key: row for key, row in self._call_row.items() if row[0] > since}
        self._forget_ended(since)

    def _forget_ended(self, since: int) -> None:
        publishers = {publisher for flat in self.columns.values() for publisher in flat[1::3]}
        publishers |= {end.index for node in self._node_row for end in node.endpoints}
        self._keep('endpoints', lambda row: row[5] > since or row[4] in publishers)
        self.lines = {row[4]: self.lines[row[4]] for row in self.endpoints if row[4] in self.lines}
        used = {row[3] for row in self.endpoints}
        self._keep('nodes', lambda row: row[3] is None or row[3] > since or row[4] in used)
        self._keep('processes', lambda row: row['ended'] is None or row['ended'] > since)
        names, alive = {row[0] for row in self.nodes}, {row['pid'] for row in self.processes}
        self.pids = {row[4]: self.pids[row[4]] for row in self.nodes if row[4] in self.pids}
        self.groups = {pid: group for pid, group in self.groups.items() if pid in alive}
        for name in ('parameters', 'descriptors'):
            last = {(row[1], row[2]): id(row) for row in getattr(self, name)}
            latest = {number for (node, _), number in last.items() if node in names}
            self._keep(name, lambda row: row[0] > since or id(row) in latest)  # noqa: B023  # called immediately
        self.facts = {key: row for key, row in self.facts.items() if row[5] > since or key[0] in self._process_row}

    def _keep(self, name: str, is_kept: Callable[[Any], bool]) -> None:
        rows, numbers = getattr(self, name), self.numbers(name)
        kept = [number for number, row in zip(numbers, rows, strict=True) if is_kept(row)]
        self.forgotten[name] = self.forgotten.get(name, 0) + len(rows) - len(kept)
        rows[:] = filter(is_kept, rows)
        self._numbers[name] = kept

    def numbers(self, name: str) -> Sequence[int]:
        """Return the number of each stored row of a part, counted over all rows of the run."""
        kept, gone = self._numbers.get(name, ()), self.forgotten.get(name, 0)
        later = range(gone + len(kept), gone + len(getattr(self, name)))
        return [*kept, *later] if kept else later

    def publication_count(self) -> int:
        """Return the number of stored messages. Messages that :meth:`forget_before` has deleted do not count."""
        return sum(map(len, self.columns.values())) // 3

    def node_added(self, node: NodeEntry) -> None:
        if self.on:
            row = [node.fully_qualified_name, node.process.name, self._now(), None, node.index]
            self._node_row[node] = row
            self.pids[node.index] = node.process.pid
            self.nodes.append(row)

    def watch(self, node: NodeEntry, look: Look) -> None:
        self.looks[node] = look

    def node_leaving(self, node: NodeEntry) -> None:
        look = self.looks.pop(node, None)
        if self.on and look is not None:
            for number, (kind, data) in enumerate(look()):
                self.fact(node.process, kind, (node.index, number), data)

    def node_removed(self, node: NodeEntry) -> None:
        if self.on and node in self._node_row:
            self._node_row.pop(node)[3] = self._now()

    def endpoint_added(self, kind: str, endpoint: Any) -> None:
        if self.on:
            name = endpoint.topic_name if kind in ('publisher', 'subscription') else endpoint.service_name
            self.endpoints.append(
                [kind, name, endpoint.type_name, endpoint.node.index, endpoint.index, self._now(), list(endpoint.qos)]
            )
            line = student_line()
            if line:
                self.lines[endpoint.index] = line['file'], line['line']

    def request(self, client: Any, sequence: int, wire: Any, served: bool) -> None:
        if self.on:
            row = [self._now(), client.service_name, client.type_name, client.node.fully_qualified_name, wire, served, None, None]
            self._call_row[client.index, sequence] = row
            self.calls.append(row)

    def response(self, client: Any, sequence: int, wire: Any) -> None:
        if self.on:
            self._call_row[client.index, sequence][6:] = [self._now(), wire]

    def incompatible(self, publisher: Any, subscription: Any, policy: str) -> None:
        if self.on:
            text = (
                f'{publisher.topic_name}: {publisher.node.fully_qualified_name} ({publisher.type_name}) and '
                f'{subscription.node.fully_qualified_name} ({subscription.type_name}) cannot talk because of {policy}'
            )
            self.notes.append([self._now(), publisher.node.process.name, 'incompatible', text])

    def parameter(self, node: NodeEntry, name: str, value: Any, origin: str) -> None:
        if self.on:
            self.parameters.append([self._now(), node.fully_qualified_name, name, value, origin])

    def descriptor(
        self, node: NodeEntry, name: str, description: str, read_only: bool, limits: tuple[float, float, float] | None
    ) -> None:
        if self.on:
            row = [self._now(), node.fully_qualified_name, name, description, read_only, None if limits is None else list(limits)]
            self.descriptors.append(row)

    def process_started(self, process: Process) -> None:
        if self.on:
            spec = process.spec
            row = {
                'name': spec.name,
                'pid': process.pid,
                'argv': list(spec.argv),
                'package': spec.package,
                'executable': spec.executable,
                'file': spec.origin.file if spec.origin else None,
                'line': spec.origin.line if spec.origin else None,
                'parameter_origins': dict(spec.parameter_origins),
                'started': self._now(),
                'ended': None,
                'returncode': None,
                'exception': None,
            }
            self._process_row[process] = row
            self.groups[process.pid] = (process.group or process).pid
            self.processes.append(row)

    def process_exited(self, process: Process) -> None:
        row = self._process_row.pop(process, None)
        if self.on and row is not None:
            row.update(ended=self._now(), returncode=process.returncode)
            error = process.exception
            if error is not None:
                file, line = error['place'] or (None, None)
                row['exception'] = {'type': error['type'], 'message': error['message'], 'file': file, 'line': line}
                if error['facts']:
                    row['exception']['facts'] = error['facts']

    def use_sources(self, source_path: Callable[[str], str]) -> None:
        """Replace links in folders with installed packages by the student's own files.

        :param source_path: a function that returns the student's own file for a path.
        """
        for row in self.processes:
            for place in (row, row['exception']):
                if place and place['file']:
                    place['file'] = source_path(place['file'])
        for _, _, _, data, *_ in self.facts.values():
            if isinstance(data.get('line'), int):
                data['file'] = source_path(data['file'])
        self.lines = {index: (source_path(file), line) for index, (file, line) in self.lines.items()}

    def output(self, process: Process, stream: str, text: str) -> None:
        if self.on:
            self.output_lines.append([self._now(), process.name, stream, text])

    def log(self, process: Process, level: int, logger: str, message: str) -> None:
        if self.on:
            self.logs.append([self._now(), process.name, logger, level, message])

    def note(self, process: Process | None, kind: str, text: str) -> None:
        if self.on:
            self.notes.append([self._now(), process.name if process is not None else None, kind, text])

    def temporary(self, path: str) -> None:
        if self.on and len(self.roots) < MOST_ROOTS:
            self.roots.append([path, '@temporary'])

    def fact(self, process: Process, kind: str, key: Hashable, data: dict[str, Any]) -> None:
        if self.on:
            row = self.facts.get((process, kind, key))
            if row is None:
                self.facts[process, kind, key] = [self._now(), process.name, kind, data, 1, self._now()]
            else:
                row[3:] = [data, row[4] + 1, self._now()]

    def fact_over(self, process: Process, kind: str, key: Hashable) -> None:
        if self.on:
            self.facts.pop((process, kind, key), None)


def _column(topic: str, kind: str, flat: list[Any], start_ns: int, end_ns: int) -> dict[str, Any]:
    """Return the record of one topic up to `end_ns`, from a flat list (time, publisher, message, time, publisher, message
    ...).
    """
    times = flat[::3]
    count = bisect_right(times, end_ns)
    return {
        'topic': topic,
        'type': kind,
        'times': [time - start_ns for time in times[:count]],
        'publishers': flat[1::3][:count],
        'messages': flat[2::3][:count],
    }

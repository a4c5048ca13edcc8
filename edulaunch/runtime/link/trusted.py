"""The trusted peer: it owns the clock, the worlds, the stock nodes and the recorder.

The trusted peer does not trust reports of the confined peer about other programs. From the student, it reads only frames.
"""

from __future__ import annotations

import os
import socket
from collections import Counter
from collections.abc import Callable, Mapping, Sized
from functools import partial
from types import MappingProxyType
from typing import Any

from edulaunch.engine.graph.graph import Graph
from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.qos import TRANSIENT_LOCAL, QoS
from edulaunch.engine.graph.services import ServiceClient
from edulaunch.engine.graph.topics import WatchedPublisher
from edulaunch.engine.graph.tracer import Record
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.recording.recorder import Recorder
from edulaunch.engine.underlay_place import underlay_prefix
from edulaunch.ros.sourcing import source
from edulaunch.runtime.fittings import hint_of
from edulaunch.runtime.link.clock import PeerSimulation
from edulaunch.runtime.link.codec import FrameKind, Messages, Violation, load, tuples
from edulaunch.runtime.link.peer import Peer
from edulaunch.runtime.link.provenance import HostedProgram, Provenance
from edulaunch.runtime.link.replica import Replica
from edulaunch.runtime.link.trusted_host import TrustedHost, is_shipped, runs_beside_the_student, spec_from_data, text_of

STREAMS = ('stdout', 'stderr')
VISITOR_PID, VISITOR = 1, ProcessSpec(argv=('visitor',), name='visitor')


class ConfinedProgram:
    """A program of the confined peer, with the data that the recording needs."""

    def __init__(self, pid: int, spec: ProcessSpec) -> None:
        self.pid = pid
        self.group: Any = None
        self.spec = spec
        self.name = spec.name
        self.returncode: int | None = None
        self.exception: dict[str, Any] | None = None


class ToldBeside:
    """The steps of a launch as reported by the confined peer. The live view checks them."""

    pid = 0

    def __init__(self, data: dict[str, Any]) -> None:
        self._data = data

    def as_data(self, since: int = 0) -> dict[str, Any]:
        """Return all steps."""
        return self._data


class TrustedRecorder(Recorder):
    """Stores the recording, and sends the confined peer the parts that it may see.

    :ivar provenance: the process of each row, and the programs that ran here.
    :ivar programs: the programs that run here, by pid.
    """

    replica: Replica
    texts: dict[str, str]

    def __init__(self, sim: PeerSimulation) -> None:
        super().__init__(sim)
        self.provenance = Provenance()
        self.programs: dict[int, HostedProgram] = {}
        self._positions: dict[int, int] = {}

    def process_started(self, process: Process) -> None:
        position = len(self.processes)
        super().process_started(process)
        self._positions[process.pid] = position
        if process.pid in self.programs:
            self.provenance.programs[position] = self.programs[process.pid]

    def _own(self, part: str, rows: Sized, process: Process | ConfinedProgram) -> None:
        """Record the process of the rows that were added since the last call."""
        owners = self.provenance.owners[part]
        owners += [self._positions.get(process.pid, -1)] * (len(rows) - len(owners))

    def output(self, process: Process, stream: str, text: str) -> None:
        super().output(process, stream, text)
        self._own('output', self.output_lines, process)

    def log(self, process: Process, level: int, logger: str, message: str) -> None:
        super().log(process, level, logger, message)
        self._own('logs', self.logs, process)

    def channel(self, publisher: Any) -> Callable[[Record], object]:
        keep = super().channel(publisher)
        lasts = isinstance(publisher, WatchedPublisher) or publisher.qos.durability == TRANSIENT_LOCAL
        if self.replica.is_repeating or not lasts:
            return keep

        def keep_and_tell(record: Record) -> None:
            keep(record)
            self.replica.published(publisher, record)

        return keep_and_tell

    def node_added(self, node: NodeEntry) -> None:
        super().node_added(node)
        self._own('nodes', self.nodes, node.process)
        self.replica.node_added(node)

    def parameter(self, node: NodeEntry, name: str, value: Any, origin: str) -> None:
        super().parameter(node, name, value, origin)
        self._own('parameters', self.parameters, node.process)

    def node_removed(self, node: NodeEntry) -> None:
        super().node_removed(node)
        self.replica.node_removed(node)

    def endpoint_added(self, kind: str, endpoint: Any) -> None:
        super().endpoint_added(kind, endpoint)
        self.replica.endpoint_added(kind, endpoint)

    def endpoint_removed(self, kind: str, endpoint: Any) -> None:
        super().endpoint_removed(kind, endpoint)
        self.replica.endpoint_removed(kind, endpoint)

    def interfaces(self, used: set[str]) -> dict[str, str]:
        """Return the definitions of types that the confined peer has sent."""
        return self.texts


class Trusted:
    """The trusted peer of one run.

    :param end: the trusted peer's end of the socket to the confined peer.
    :param quota: the maximum number of bytes from the confined peer.
    :ivar sent: for each topic, the simulated time in seconds and the string that the node /visitor publishes.
    :ivar turned: for each turtle, the simulated time in seconds and the angle in radians by which the node /visitor turns it.
    """

    def __init__(self, end: socket.socket, seed: int, quota: int | None = None) -> None:
        source()
        self.sim = PeerSimulation(seed)
        self.recorder = TrustedRecorder(self.sim)
        self.graph = Graph(self.sim, self.recorder)
        self.host = TrustedHost(self.sim, self.graph, Index([underlay_prefix()]), env={}, hint_of=hint_of)
        self.host.identified = self.recorder.programs
        self.peer = self.host.peer = Peer(self.sim, end, trusts=False, quota=quota)
        self.messages = Messages(underlay_registry())
        self.replica = self.recorder.replica = Replica(self.peer, self.graph, self.messages, self._program)
        self.replica.answered = self.recorder.response  # type: ignore[method-assign]
        self._programs: dict[int, ConfinedProgram] = {}
        self.sent: Mapping[str, tuple[float, str]] = MappingProxyType({})
        self.turned: Mapping[str, tuple[float, float]] = MappingProxyType({})
        self._seen: dict[int, list[tuple[str, dict[str, Any]]]] = {}  # facts about the nodes of the other peer, by node number
        self.peer.calls.update({FrameKind.SIGNAL: self.host.send_signal, FrameKind.MAY_START: self.host.may_start})
        self.peer.handlers.update(
            {
                FrameKind.ASKED: self._asked,
                FrameKind.ANSWERED: self._answered,
                FrameKind.PARAMETER: self._parameter,
                FrameKind.DESCRIPTOR: self._descriptor,
                FrameKind.STARTED: self._started,
                FrameKind.ENDED: self._ended,
                FrameKind.WROTE: self._wrote,
                FrameKind.LOG: self._log,
                FrameKind.NOTE: self._note,
                FrameKind.TEMPORARY: self._temporary,
                FrameKind.FACT: self._fact,
                FrameKind.FACT_OVER: self._fact_over,
                FrameKind.WATCH: self._watch,
                FrameKind.SPAWN: self.host.spawn,
                FrameKind.HEARD: self.host.hear,
            }
        )

    def run(self, duration_s: float) -> dict[str, Any]:
        """Advance simulated time, and return the content of the recording."""
        with streams_of_programs():
            self.peer.await_token(self.sim.now_ns)
            for topic, (time_s, text) in self.sent.items():
                self.sim.schedule(self.sim.start_ns + round(time_s * 1e9), partial(self._visit, topic, text))
            for turtle, (time_s, angle) in self.turned.items():
                self.sim.schedule(self.sim.start_ns + round(time_s * 1e9), partial(self._turn, turtle, angle))
            self.sim.run(self.sim.now_ns + round(duration_s * 1e9))
            self.peer.checked(self._describe)
        self.recorder.stop()
        return self.recorder.content()

    def _visit(self, topic: str, text: str) -> None:
        """Publish a message that the other peer cannot know in advance."""
        node = self.graph.add_node(ConfinedProgram(VISITOR_PID, VISITOR), 'visitor', '/')
        publisher = self.graph.create_publisher(node, topic, underlay_registry().get('std_msgs/msg/String'), QoS())
        publisher.publish((text,))

    def _turn(self, turtle: str, angle: float) -> None:
        """Turn a turtle at a time that the other peer cannot know in advance."""
        node = self.graph.add_node(ConfinedProgram(VISITOR_PID, VISITOR), 'visitor', '/')
        kind = underlay_registry().get('turtlesim/srv/TeleportRelative')
        client = self.graph.create_client(node, f'{turtle}/teleport_relative', kind, QoS(), bool)
        client.send((0.0, angle))

    def go_on(self, duration_s: float) -> None:
        """Advance simulated time after `run`, without recording."""
        with streams_of_programs():
            self.sim.run(self.sim.now_ns + round(duration_s * 1e9))

    def published_bytes(self, topic: str) -> Counter[bytes]:
        """Return how many times each message of a stock type was published on a topic. The keys are CDR bytes."""
        found: Counter[bytes] = Counter()
        for (name, kind), flat in self.recorder.columns.items():
            if name == topic:
                cls = self.messages.type(kind)
                found.update(self.messages.packed(cls, wire)[1:] for wire in flat[2::3])
        return found

    def _describe(self) -> None:
        """Request the other peer's record of the launch. The record may contain anything, so nothing here depends on it."""
        recorder = self.recorder
        types = {row[2] for row in (*recorder.endpoints, *recorder.calls)}
        files = {place['file'] for row in recorder.processes for place in (row, row['exception']) if place and place['file']}
        answer = self.peer.call(FrameKind.FINISH, [sorted(types), sorted(files)])
        recorder.launch, recorder.roots, recorder.texts = answer['launch'], answer['roots'], answer['interfaces']
        recorder.beside = {text_of(name): [ToldBeside(dict(one)) for one in many] for name, many in answer['beside'].items()}
        self._seen.update({index: [(text_of(kind), dict(data)) for kind, data in seen] for index, seen in answer['seen']})
        recorder.use_sources(lambda path: text_of(answer['sources'].get(path, path)))

    def _program(self, pid: Any) -> ConfinedProgram:
        return self._programs[pid]

    def _started(self, payload: memoryview) -> None:
        pid, data = load(bytes(payload))
        spec = spec_from_data(data)
        if is_shipped(spec.argv[0] if spec.argv else '') and not runs_beside_the_student(
            spec.package, spec.executable, spec.argv[0]
        ):
            raise Violation('programs of edulaunch do not run in that peer')
        if self.host.refused_now(' '.join(spec.argv)) is not None:
            raise Violation('the other peer must ask before it starts a program')
        program = self._programs[self.host.their_pid(pid)] = ConfinedProgram(pid, spec)
        self.recorder.process_started(program)  # type: ignore[arg-type]

    def _ended(self, payload: memoryview) -> None:
        pid, returncode, exception = load(bytes(payload))
        program = self._programs[pid]
        program.returncode, program.exception = returncode, exception
        self.recorder.process_exited(program)  # type: ignore[arg-type]

    def _wrote(self, payload: memoryview) -> None:
        pid, stream, text = load(bytes(payload))
        if stream not in STREAMS:
            raise Violation('no stream')
        self.recorder.output(self._programs[pid], stream, text_of(text))  # type: ignore[arg-type]

    def _log(self, payload: memoryview) -> None:
        pid, level, logger, message = load(bytes(payload))
        self.recorder.log(self._programs[pid], int(level), text_of(logger), text_of(message))  # type: ignore[arg-type]

    def _note(self, payload: memoryview) -> None:
        pid, kind, text = load(bytes(payload))
        program: Any = None if pid is None else self._programs[pid]
        self.recorder.note(program, text_of(kind), text_of(text))

    def _temporary(self, payload: memoryview) -> None:
        path = text_of(load(bytes(payload)))
        if os.path.dirname(path) not in ('', '/'):  # a folder such as /usr keeps its name in the digest
            self.recorder.temporary(path)

    def _fact(self, payload: memoryview) -> None:
        pid, kind, key, data = load(bytes(payload))
        self.recorder.fact(self._programs[pid], text_of(kind), tuples(key), dict(data))  # type: ignore[arg-type]

    def _fact_over(self, payload: memoryview) -> None:
        pid, kind, key = load(bytes(payload))
        self.recorder.fact_over(self._programs[pid], text_of(kind), tuples(key))  # type: ignore[arg-type]

    def _watch(self, payload: memoryview) -> None:
        node = self.replica.their(load(bytes(payload)), NodeEntry)
        self.recorder.watch(node, lambda: self._seen.get(node.index, ()))

    def _parameter(self, payload: memoryview) -> None:
        index, name, value, origin = load(bytes(payload))
        self.recorder.parameter(self.replica.their(index, NodeEntry), text_of(name), value, text_of(origin))

    def _descriptor(self, payload: memoryview) -> None:
        index, name, description, read_only, limits = load(bytes(payload))
        node = self.replica.their(index, NodeEntry)
        self.recorder.descriptor(node, text_of(name), text_of(description), read_only is True, limits)

    def _asked(self, payload: memoryview) -> None:
        index, sequence, served, data = load(bytes(payload))
        client = self.replica.their(index, ServiceClient)
        self.recorder.request(client, sequence, self.messages.unpacked(client.cls.Request, data), served is True)

    def _answered(self, payload: memoryview) -> None:
        index, sequence, data = load(bytes(payload))
        client = self.replica.their(index, ServiceClient)
        self.recorder.response(client, sequence, self.messages.unpacked(client.cls.Response, data))

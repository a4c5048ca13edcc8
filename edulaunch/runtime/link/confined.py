"""The confined peer: launch and the student's programs. It reports to the trusted peer, and its own records do not count."""

from __future__ import annotations

import errno
import os
import socket
from collections.abc import Callable, Hashable
from functools import partial
from typing import Any

from edulaunch.engine.facts import facts_of
from edulaunch.engine.graph.node_entry import NodeEntry
from edulaunch.engine.graph.parameter_files import ParameterFileError
from edulaunch.engine.graph.ros_arguments import entries_of_file
from edulaunch.engine.graph.tracer import Look, Record
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.host_face import OnExit, OnOutput
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.recording.recorder import Recorder
from edulaunch.runtime.link.clock import PeerSimulation
from edulaunch.runtime.link.codec import FrameKind, Messages, dump, load
from edulaunch.runtime.link.peer import Peer
from edulaunch.runtime.link.replica import Replica
from edulaunch.runtime.link.trusted_host import is_hosted
from edulaunch.runtime.session import Session


class HostedProgram:
    """A program of the trusted peer, with the data that the confined peer has about it."""

    is_passed_on = False

    def __init__(
        self, host: ConfinedHost, spec: ProcessSpec, pid: int, on_output: OnOutput | None, on_exit: OnExit | None
    ) -> None:
        self.host = host
        self.index = host.index
        self.spec = spec
        self.pid = pid
        self.name = spec.name
        self.group: Any = None
        self.returncode: int | None = None
        self.exception: dict[str, Any] | None = None
        self.on_output = on_output
        self.on_exit = on_exit
        self._is_recorded = True

    @property
    def is_recorded(self) -> bool:
        """See `Process.is_recorded`."""
        return self._is_recorded

    @is_recorded.setter
    def is_recorded(self, is_recorded: bool) -> None:
        self._is_recorded = is_recorded
        self.host.peer.send(FrameKind.HEARD, dump([self.pid, is_recorded]))

    def send_signal(self, signum: int) -> None:
        """Implement `Process.send_signal`."""
        if self.returncode is None:
            self.host.peer.call(FrameKind.SIGNAL, [self.pid, int(signum)])


class ConfinedRecorder(Recorder):
    """Records nothing, and sends everything to the trusted peer."""

    peer: Peer
    replica: Replica
    messages: Messages

    def channel(self, publisher: Any) -> Callable[[Record], object]:
        if self.replica.is_repeating:
            return _forget
        return partial(self.replica.published, publisher)

    def node_added(self, node: NodeEntry) -> None:
        self.replica.node_added(node)

    def node_removed(self, node: NodeEntry) -> None:
        self.replica.node_removed(node)

    def endpoint_added(self, kind: str, endpoint: Any) -> None:
        self.replica.endpoint_added(kind, endpoint)

    def endpoint_removed(self, kind: str, endpoint: Any) -> None:
        self.replica.endpoint_removed(kind, endpoint)

    def request(self, client: Any, sequence: int, wire: Any, served: bool) -> None:
        data = self.messages.packed(client.cls.Request, wire)
        self.peer.send(FrameKind.ASKED, dump([client.index, sequence, served, data]))

    def response(self, client: Any, sequence: int, wire: Any) -> None:
        if self.replica.is_ours(client):
            data = self.messages.packed(client.cls.Response, wire)
            self.peer.send(FrameKind.ANSWERED, dump([client.index, sequence, data]))

    def incompatible(self, publisher: Any, subscription: Any, policy: str) -> None:
        """Do nothing, because the trusted peer observes the same event."""

    def parameter(self, node: NodeEntry, name: str, value: Any, origin: str) -> None:
        self.peer.send(FrameKind.PARAMETER, dump([node.index, name, value, origin]))

    def descriptor(
        self, node: NodeEntry, name: str, description: str, read_only: bool, limits: tuple[float, float, float] | None
    ) -> None:
        self.peer.send(FrameKind.DESCRIPTOR, dump([node.index, name, description, read_only, limits]))

    def process_started(self, process: Any) -> None:
        if not isinstance(process, HostedProgram):
            self.peer.send(FrameKind.STARTED, dump([process.pid, spec_as_data(process.spec)]))

    def process_exited(self, process: Any) -> None:
        if not isinstance(process, HostedProgram):
            self.peer.send(FrameKind.ENDED, dump([process.pid, process.returncode, process.exception]))

    def output(self, process: Any, stream: str, text: str) -> None:
        self.peer.send(FrameKind.WROTE, dump([process.pid, stream, text]))

    def log(self, process: Process, level: int, logger: str, message: str) -> None:
        self.peer.send(FrameKind.LOG, dump([process.pid, level, logger, message]))

    def note(self, process: Process | None, kind: str, text: str) -> None:
        self.peer.send(FrameKind.NOTE, dump([None if process is None else process.pid, kind, text]))

    def temporary(self, path: str) -> None:
        self.peer.send(FrameKind.TEMPORARY, dump(path))

    def fact(self, process: Process, kind: str, key: Hashable, data: dict[str, Any]) -> None:
        self.peer.send(FrameKind.FACT, dump([process.pid, kind, key, data]))

    def fact_over(self, process: Process, kind: str, key: Hashable) -> None:
        self.peer.send(FrameKind.FACT_OVER, dump([process.pid, kind, key]))

    def watch(self, node: NodeEntry, look: Look) -> None:
        super().watch(node, look)
        self.peer.send(FrameKind.WATCH, dump(node.index))

    def seen_now(self) -> list[list[Any]]:
        """Return the facts of the existing nodes, each with the number of its node."""
        return [[node.index, list(look())] for node, look in self.looks.items()]


def _forget(record: Record) -> None:
    """Do nothing, because the other peer records its own publications."""


def spec_as_data(spec: ProcessSpec) -> list[Any]:
    """Return a spec as plain data; `trusted_host.spec_from_data` reads it."""
    values = spec._asdict()
    values['origin'] = None if spec.origin is None else list(spec.origin)
    values['env'] = None if spec.env is None else dict(spec.env)
    values['parameter_origins'] = dict(spec.parameter_origins)
    return list(values.values())


class ConfinedHost(Host):
    """Starts the student's programs in this peer, and makes the trusted peer host the programs of edulaunch."""

    peer: Peer

    def start(
        self, spec: ProcessSpec, on_output: OnOutput | None = None, on_exit: OnExit | None = None, *, index: Index | None = None
    ) -> Any:
        """Implement `Host.start`. In some runs of a rubric, one program cannot be started."""
        known, starter = self.known_command(spec, index), self.program_here()
        program = None if known is None or known.program is None or not is_hosted(known.program) else known.program
        if known is not None and starter is not None:
            name = ' '.join(known.argv) if program is None else program.executable
            if not self.peer.call(FrameKind.MAY_START, name):
                raise BlockingIOError(errno.EAGAIN, os.strerror(errno.EAGAIN))
        if known is None or program is None:
            return super().start(spec, on_output, on_exit, index=index)
        hosted = HostedProgram(self, spec, self.next_pid(), on_output, on_exit)
        if starter is not None:
            starter.limit.programs += 2
            hosted.group = starter.group
        self.processes.append(hosted)  # type: ignore[arg-type]
        self.tracer.process_started(hosted)
        spec = spec if spec.env is not None else spec._replace(env=self.env)
        self.peer.tell(FrameKind.SPAWN, dump([hosted.pid, known.argv, program.package, program.executable, spec_as_data(spec)]))
        return hosted

    def hosted(self, pid: int) -> Any:
        """Return the hosted program with that process ID, or None for a node of the trusted peer itself."""
        return next((each for each in self.processes if each.pid == pid), None)


class ConfinedSession(Session):
    """A session whose worlds and stock nodes run in the trusted peer.

    :param end: this process's end of the socket to the trusted peer.
    """

    sim: PeerSimulation
    recorder: ConfinedRecorder
    host: ConfinedHost
    simulation_class = PeerSimulation
    recorder_class = ConfinedRecorder
    host_class = ConfinedHost

    def __init__(self, end: socket.socket, **options: Any) -> None:
        super().__init__(**options)
        recorder, host = self.recorder, self.host
        peer = recorder.peer = host.peer = Peer(self.sim, end, trusts=True)
        self.sim.other = (0, 0, 0, 0)  # the other peer runs first
        recorder.messages = Messages(underlay_registry())
        recorder.replica = Replica(peer, self.graph, recorder.messages, host.hosted)
        peer.fatal = lambda error: os._exit(0)  # type: ignore[method-assign]
        peer.calls.update(
            {
                FrameKind.OUTPUT: self._on_output,
                FrameKind.EXIT: self._on_exit,
                FrameKind.ENTRIES: self._entries,
                FrameKind.FINISH: self._finish,
            }
        )

    def run_as_asked(self) -> None:
        """Give the token to the trusted peer. Run whenever the token returns, until the trusted peer ends this process."""
        with streams_of_programs():
            self.sim.run(None)

    def _on_output(self, payload: memoryview) -> None:
        pid, stream, text = load(bytes(payload))
        program = self.host.hosted(pid)
        if program.on_output is not None:
            program.on_output(stream, text)

    def _on_exit(self, payload: memoryview) -> None:
        pid, returncode, exception = load(bytes(payload))
        program = self.host.hosted(pid)
        program.returncode, program.exception = returncode, exception
        self.host.ended(program)
        if program.on_exit is not None:
            program.on_exit(returncode)

    def _entries(self, payload: memoryview) -> Any:
        path, folder = load(bytes(payload))
        generated = self.host.generated_files.get(path)
        try:
            entries = generated.entries() if generated is not None else entries_of_file(os.path.join(folder, path))
        except ParameterFileError as error:
            return {'reason': str(error), 'facts': facts_of(error)}
        except UnicodeDecodeError as error:
            return {'coding': [error.encoding, error.object[error.start : error.end], error.start, error.end, error.reason]}
        except OSError as error:
            return {'system': [error.errno, error.strerror, error.filename]}
        return [list(entry) for entry in entries]

    def _finish(self, payload: memoryview) -> Any:
        """Return launch's own record of the launch, with the items that the trusted peer requests."""
        types, files = load(bytes(payload))
        self.describe()
        recorder = self.recorder
        sources = {file: self.index.source_path(file) for file in files}
        interfaces = recorder.interfaces(set(types))
        answer = {'launch': recorder.launch, 'roots': recorder.roots, 'seen': recorder.seen_now()}
        beside = {name: [one.as_data() for one in many] for name, many in recorder.beside.items()}
        return {**answer, 'interfaces': interfaces, 'sources': sources, 'beside': beside}

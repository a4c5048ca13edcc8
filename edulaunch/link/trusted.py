"""The trusted half: the clock's owner, worlds and stock nodes, the recorder. It believes nothing that the confined half says of
others, and reads nothing of the student's but frames.
"""

from __future__ import annotations

import shlex
import socket
from collections.abc import Callable, Sequence
from types import MappingProxyType
from typing import Any

from edulaunch.facts import with_facts
from edulaunch.graph.graph import Graph, NodeEntry
from edulaunch.graph.parameter_files import Entry, ParameterFileError
from edulaunch.graph.qos import TRANSIENT_LOCAL
from edulaunch.graph.services import ServiceClient
from edulaunch.graph.topics import WatchedPublisher
from edulaunch.graph.tracer import Record
from edulaunch.interfaces.underlay import underlay_registry
from edulaunch.link.clock import HalfSimulation
from edulaunch.link.codec import Kind, Messages, Violation, load, tuples
from edulaunch.link.half import Half
from edulaunch.link.hosted import hosted_program, shipped_path
from edulaunch.link.replica import Replica
from edulaunch.packages import Index
from edulaunch.processes.host import Host
from edulaunch.processes.origin import Origin
from edulaunch.processes.process import Process
from edulaunch.processes.programs import run_program
from edulaunch.processes.shared_streams import streams_of_programs
from edulaunch.processes.spec import ProcessSpec
from edulaunch.recording.recorder import Recorder
from edulaunch.sourcing import source
from edulaunch.underlay_place import underlay_prefix

MOST_PROGRAMS = 2000
STREAMS = ('stdout', 'stderr')


class ConfinedProgram:
    """A program of the confined half, as far as the record needs it."""

    def __init__(self, pid: int, spec: ProcessSpec) -> None:
        self.pid = pid
        self.spec = spec
        self.name = spec.name
        self.returncode: int | None = None
        self.exception: dict[str, Any] | None = None


class TrustedRecorder(Recorder):
    """Keeps the record, and lets the confined half know what it may see of it.

    :ivar hosted_nodes, hosted_parameters: positions in `nodes` of the nodes that run here, and in `parameters` of theirs.
    """

    replica: Replica
    texts: dict[str, str]

    def __init__(self, sim: HalfSimulation) -> None:
        super().__init__(sim)
        self.hosted_nodes: list[int] = []
        self.hosted_parameters: list[int] = []

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
        if not self.replica.is_repeating:
            self.hosted_nodes.append(len(self.nodes))
        super().node_added(node)
        self.replica.node_added(node)

    def parameter(self, node: NodeEntry, name: str, value: Any, origin: str) -> None:
        if node.index not in self.replica.theirs:
            self.hosted_parameters.append(len(self.parameters))
        super().parameter(node, name, value, origin)

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
        """The texts that the confined half gave."""
        return self.texts


class TrustedHost(Host):
    """Hosts what came with edulaunch. It starts no program of the system, and looks for none among the student's files."""

    half: Half

    def spawn(self, payload: memoryview) -> None:
        """Start a program that the confined half asks for."""
        pid, argv, package, executable, data = load(bytes(payload))
        spec = spec_from_data(data)
        program = hosted_program(_text(package), _text(executable))
        _check_words(spec, argv)
        is_called_so = spec.argv[:1] == (shipped_path(spec.package, spec.executable),)
        if program is None or (is_called_so and (spec.package, spec.executable) != (package, executable)):
            raise Violation('no program that is hosted here')
        process = Process(self, spec, self.their_pid(pid), argv, lambda process: run_program(process, program))
        process.on_output = lambda stream, text: self.half.call(Kind.OUTPUT, [pid, stream, text])
        process.on_exit = lambda code: self.half.call(Kind.EXIT, [pid, code, process.exception])
        self.adopt(process)

    def their_pid(self, pid: Any) -> int:
        """The next number, which the confined half has to name."""
        if pid != self.next_pid() or pid >= 1000 + MOST_PROGRAMS:
            raise Violation('programs are numbered as they come')
        return int(pid)

    def hosted(self, pid: Any) -> Process | None:
        """The hosted program of that pid; None when it has ended."""
        return next((each for each in self.processes if each.pid == pid), None)

    def send_signal(self, payload: memoryview) -> None:
        """Deliver a signal to a hosted program."""
        pid, signum = load(bytes(payload))
        process = self.hosted(pid)
        if process is not None and 0 < signum < 65:
            process.send_signal(signum)

    def hear(self, payload: memoryview) -> None:
        """Set whether the output of a hosted program is recorded."""
        pid, is_heard = load(bytes(payload))
        process = self.hosted(pid)
        if process is not None:
            process.is_heard = is_heard is True

    def parameter_entries(self, path: str) -> Sequence[Entry]:
        """As `Host.parameter_entries`: the confined half reads the file."""
        program = self.program_here()
        told = self.half.call(Kind.ENTRIES, [path, (program and program.cwd) or ''])
        if isinstance(told, list):
            return [_entry(row) for row in told]
        raise _reading_error(told)


def _entry(row: Any) -> Entry:
    pattern, name, value, line = row
    if not (isinstance(pattern, str) and isinstance(name, str) and isinstance(line, int) and _is_value(value)):
        raise Violation('no parameter')
    return Entry(pattern, name, value, line)


def _is_value(value: Any) -> bool:
    if isinstance(value, list):
        return all(isinstance(each, (bool, int, float, str)) for each in value)
    return value is None or isinstance(value, (bool, int, float, str))


def _reading_error(told: Any) -> Exception:
    if 'reason' in told:
        error = ParameterFileError(_text(told['reason']))
        return with_facts(error, _text(told['facts'].pop('about')), **told['facts']) if told['facts'] else error
    if 'coding' in told:
        encoding, wrong, start, end, reason = told['coding']
        if not (0 <= start < end < 1 << 26 and isinstance(wrong, bytes)):
            raise Violation('no place in a file')
        return UnicodeDecodeError(_text(encoding), bytes(start) + wrong, start, end, _text(reason))
    number, text, file = told['system']
    return OSError(int(number), _text(text), _text(file))


def _text(value: Any) -> str:
    if not isinstance(value, str):
        raise Violation('no text')
    return value


def _check_words(spec: ProcessSpec, argv: Any) -> None:
    """What a program is told to be started with is the end of the command line that the record shows."""
    words = shlex.split(' '.join(spec.argv)) if spec.shell else list(spec.argv)
    if not isinstance(argv, list) or not argv or words[-len(argv) :] != argv:
        raise Violation('a program is what its command line says')


def spec_from_data(data: Any) -> ProcessSpec:
    """The spec that `confined.spec_as_data` made.

    :raises Violation: when it is none.
    """
    argv, name, cwd, env, shell, origin, package, executable, origins, emulate_tty, has_pipe = data
    texts = [*argv, name, *(env or {}).values(), *origins.values()]
    maybe = [cwd, package, executable]
    if not (all(isinstance(text, str) for text in texts) and all(text is None or isinstance(text, str) for text in maybe)):
        raise Violation('no command')
    return ProcessSpec(
        argv=tuple(argv),
        name=name,
        cwd=cwd,
        env=MappingProxyType(dict(env or {})),
        shell=shell is True,
        origin=None if origin is None else Origin(_text(origin[0]), int(origin[1])),
        package=package,
        executable=executable,
        parameter_origins=dict(origins),
        emulate_tty=emulate_tty is True,
        has_pipe=has_pipe is True,
    )


class Trusted:
    """The trusted half of one run.

    :param end: of the socket to the confined half.
    :param quota: how many bytes that may send.
    """

    def __init__(self, end: socket.socket, seed: int, quota: int | None = None) -> None:
        source()
        self.sim = HalfSimulation(seed)
        self.recorder = TrustedRecorder(self.sim)
        self.graph = Graph(self.sim, self.recorder)
        self.host = TrustedHost(self.sim, self.graph, Index([underlay_prefix()]), env={})
        self.half = self.host.half = Half(self.sim, end, trusts=False, quota=quota)
        self.messages = Messages(underlay_registry())
        self.replica = self.recorder.replica = Replica(self.half, self.graph, self.messages, self._program)
        self.replica.answered = self.recorder.response  # type: ignore[method-assign]
        self._programs: dict[int, ConfinedProgram] = {}
        self._seen: dict[int, list[tuple[str, dict[str, Any]]]] = {}  # what is odd about the other half's nodes, by their numbers
        self.half.calls[Kind.SIGNAL] = self.host.send_signal
        self.half.handlers.update(
            {
                Kind.ASKED: self._asked,
                Kind.ANSWERED: self._answered,
                Kind.PARAMETER: self._parameter,
                Kind.DESCRIPTOR: self._descriptor,
                Kind.STARTED: self._started,
                Kind.ENDED: self._ended,
                Kind.WROTE: self._wrote,
                Kind.LOG: self._log,
                Kind.NOTE: self._note,
                Kind.FACT: self._fact,
                Kind.FACT_OVER: self._fact_over,
                Kind.WATCH: self._watch,
                Kind.SPAWN: self.host.spawn,
                Kind.HEARD: self.host.hear,
            }
        )

    def run(self, duration_s: float) -> dict[str, Any]:
        """Let simulated time pass, and give the content of the recording."""
        with streams_of_programs():
            self.half.await_token(self.sim.now_ns)
            self.sim.run(self.sim.now_ns + round(duration_s * 1e9))
            self.half.checked(self._describe)
        self.recorder.stop()
        return self.recorder.content()

    def _describe(self) -> None:
        """Ask the other half what it knows of what was launched. It may say what it likes: nothing here depends on it."""
        recorder = self.recorder
        types = {row[2] for row in (*recorder.endpoints, *recorder.calls)}
        files = {place['file'] for row in recorder.processes for place in (row, row['exception']) if place and place['file']}
        told = self.half.call(Kind.FINISH, [sorted(types), sorted(files)])
        recorder.launch, recorder.roots, recorder.texts = told['launch'], told['roots'], told['interfaces']
        self._seen.update({index: [(_text(kind), dict(data)) for kind, data in seen] for index, seen in told['seen']})
        recorder.use_sources(lambda path: _text(told['sources'].get(path, path)))

    def _program(self, pid: Any) -> ConfinedProgram:
        return self._programs[pid]

    def _started(self, payload: memoryview) -> None:
        pid, data = load(bytes(payload))
        spec = spec_from_data(data)
        if hosted_program(spec.package or '', spec.executable or '') and spec.argv[:1] == (
            shipped_path(spec.package, spec.executable),
        ):
            raise Violation('what came with edulaunch does not run there')
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
        self.recorder.output(self._programs[pid], stream, _text(text))  # type: ignore[arg-type]

    def _log(self, payload: memoryview) -> None:
        pid, level, logger, message = load(bytes(payload))
        self.recorder.log(self._programs[pid], int(level), _text(logger), _text(message))  # type: ignore[arg-type]

    def _note(self, payload: memoryview) -> None:
        pid, kind, text = load(bytes(payload))
        program: Any = None if pid is None else self._programs[pid]
        self.recorder.note(program, _text(kind), _text(text))

    def _fact(self, payload: memoryview) -> None:
        pid, kind, key, data = load(bytes(payload))
        self.recorder.fact(self._programs[pid], _text(kind), tuples(key), dict(data))  # type: ignore[arg-type]

    def _fact_over(self, payload: memoryview) -> None:
        pid, kind, key = load(bytes(payload))
        self.recorder.fact_over(self._programs[pid], _text(kind), tuples(key))  # type: ignore[arg-type]

    def _watch(self, payload: memoryview) -> None:
        node = self.replica.their(load(bytes(payload)), NodeEntry)
        self.recorder.watch(node, lambda: self._seen.get(node.index, ()))

    def _parameter(self, payload: memoryview) -> None:
        index, name, value, origin = load(bytes(payload))
        self.recorder.parameter(self.replica.their(index, NodeEntry), _text(name), value, _text(origin))

    def _descriptor(self, payload: memoryview) -> None:
        index, name, description, read_only, limits = load(bytes(payload))
        node = self.replica.their(index, NodeEntry)
        self.recorder.descriptor(node, _text(name), _text(description), read_only is True, limits)

    def _asked(self, payload: memoryview) -> None:
        index, sequence, served, data = load(bytes(payload))
        client = self.replica.their(index, ServiceClient)
        self.recorder.request(client, sequence, self.messages.unpacked(client.cls.Request, data), served is True)

    def _answered(self, payload: memoryview) -> None:
        index, sequence, data = load(bytes(payload))
        client = self.replica.their(index, ServiceClient)
        self.recorder.response(client, sequence, self.messages.unpacked(client.cls.Response, data))

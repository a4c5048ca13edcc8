"""Observe a run in simulation. The observation comes from the recording of the run."""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from functools import cached_property
from typing import Any

from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.packages import Index
from edulaunch.engine.packages.index import interfaces_of
from edulaunch.engine.processes.host import Host
from edulaunch.engine.processes.host_face import OnExit, OnOutput
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.real import RealProcess
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.recorder import Recorder
from edulaunch.engine.sim.simulation import EPOCH_NS, Simulation
from edulaunch.extras.comparing.observation import (
    BRIEFLY,
    NOT_COMPARED,
    ClassOf,
    End,
    Flow,
    Line,
    Observation,
    Program,
    add_messages,
    is_compared,
    lines_of,
    program_of,
    steady_name,
)
from edulaunch.runtime.session import Session

FOUND_S = 3.0
"""The time, in seconds, after which all real programs have found a new node or endpoint."""
END_S = 15.0
"""Seconds after Ctrl-C."""


class RealProgram:
    """A real program of this computer that a simulation started: its output and its end, in simulated seconds.

    :ivar written: the output of each stream as pairs (time, string).
    """

    def __init__(self, host: Host, spec: ProcessSpec, on_output: OnOutput | None, on_exit: OnExit | None) -> None:
        self.name = spec.name
        self.written: dict[str, list[tuple[float, str]]] = {}
        self.ended_s: float | None = None
        self.returncode: int | None = None
        self._host, self._on_output, self._on_exit = host, on_output, on_exit
        self.started_s = self._now_s()

    def _now_s(self) -> float:
        return (self._host.sim.now_ns - self._host.sim.start_ns) / 1e9

    def hear(self, stream: str, text: str) -> None:
        """Record output of the program."""
        self.written.setdefault(stream, []).append((self._now_s(), text))
        if self._on_output is not None:
            self._on_output(stream, text)

    def end(self, returncode: int) -> None:
        """Record the end of the program."""
        self.returncode, self.ended_s = returncode, self._now_s()
        if self._on_exit is not None:
            self._on_exit(returncode)


class LateHost(Host):
    """A host whose programs start as late as in the real run. `delays_s` has the delays by launch name.

    The host also records the programs that run directly on this computer, which no recording contains.
    """

    delays_s: Mapping[str, float] = {}

    @cached_property
    def of_computer(self) -> list[RealProgram]:
        """Return the programs that were started directly on this computer, in order."""
        return []

    def start(
        self, spec: ProcessSpec, on_output: OnOutput | None = None, on_exit: OnExit | None = None, *, index: Index | None = None
    ) -> Process | RealProcess:
        """Implement `Host.start`."""
        if self.known_command(spec, index) is not None:
            return super().start(spec, on_output, on_exit, index=index)
        program = RealProgram(self, spec, on_output, on_exit)
        started = super().start(spec, program.hear, program.end, index=index)
        self.of_computer.append(program)
        return started

    def begin(self, process: Process) -> None:
        """Implement `Host.begin`."""
        delay_ns = round(self.delays_s.get(process.name, 0.0) * 1e9)
        if delay_ns:
            self.sim.schedule(self.sim.now_ns + delay_ns, process.lifecycle.task.start)
        else:
            super().begin(process)


class EndsRecorder(Recorder):
    """A recorder that also records when publishers, subscriptions, services and clients are removed.

    :ivar gone_s: the times of removal, by the number of the endpoint.
    """

    def __init__(self, sim: Simulation) -> None:
        super().__init__(sim)
        self.gone_s: dict[int, float] = {}

    def endpoint_removed(self, kind: str, endpoint: Any) -> None:
        """Implement `Recorder.endpoint_removed`."""
        super().endpoint_removed(kind, endpoint)
        self.gone_s[endpoint.index] = (self.sim.now_ns - self.sim.start_ns) / 1e9


class LateSession(Session):
    """A session with a `LateHost` and an `EndsRecorder`."""

    host_class = LateHost
    recorder_class = EndsRecorder


def simulate(
    path: str,
    file: str | None,
    arguments: Mapping[str, str],
    seconds: float,
    workspaces: Sequence[str],
    delays_s: Mapping[str, float] | None = None,
    start_s: float = EPOCH_NS / 1e9,
    seed: int = 0,
) -> Observation:
    """Run a launch file, press Ctrl-C after `seconds`, and return the observation.

    :param delays_s: the delays before programs start, by launch name.
    :param start_s: the time of day at which the run begins, in seconds since 1970.
    :param seed: the seed of the random numbers.
    :raises UnusableInput: when the file cannot be launched.
    :raises KeyboardInterrupt: when the user pressed Ctrl-C before the end of the run.
    """
    with LateSession(workspaces=workspaces, start_ns=round(start_s * 1e9), seed=seed) as session:
        assert isinstance(session.host, LateHost) and isinstance(session.recorder, EndsRecorder)
        session.host.delays_s = delays_s or {}
        launch = session.launch(path, file, arguments)
        was_stopped = session.run(seconds)
        launch.raise_error()
        session.interrupt()
        if session.run(END_S) or was_stopped:
            raise KeyboardInterrupt
        recording = session.recording()
        gone = [session.recorder.gone_s.get(row[4], END_S + seconds) for row in session.recorder.endpoints]
        seen = observe(recording, gone, seconds, interfaces_of(session.index)[1].get)
        return with_programs(seen, session.host.of_computer)


def with_programs(seen: Observation, programs: Sequence[RealProgram]) -> Observation:
    """Return the observation extended by the output and the ends of the real programs that ran on this computer."""
    lines = [line for each in programs for pieces in each.written.values() for line in lines_of(program_of(each.name), pieces)]
    known = {each.name: Program(each.started_s, each.ended_s, each.returncode) for each in programs}
    return seen._replace(lines=[*seen.lines, *lines], programs={**seen.programs, **known})


def observe(recording: Recording, gone_s: Sequence[float], asked_s: float, class_of: ClassOf) -> Observation:
    """Return the observation of a recording.

    :param asked_s: when Ctrl-C was pressed.
    :param gone_s: when each endpoint was removed, by its number.
    """
    nodes: dict[str, float] = {}
    for node in recording.nodes:
        if is_compared(node.name):
            lasted_s = (asked_s if node.ended_s is None else node.ended_s) - node.started_s
            when = node.started_s if lasted_s > FOUND_S else BRIEFLY
            name = steady_name(node.name)
            nodes[name] = min(when, nodes.get(name, BRIEFLY))
    ends: dict[End, tuple[str, float]] = {}
    for record, end_s in zip(recording.ends, gone_s, strict=True):
        if is_compared(record.node):
            qos = QoS(*record.qos) if record.kind in ('publisher', 'subscription') else None
            words = '' if qos is None else f'{qos.reliability} {qos.durability}'
            name = steady_name(record.node)
            is_brief = nodes[name] == BRIEFLY or end_s < min(asked_s, record.made_s + FOUND_S)
            when = BRIEFLY if is_brief else record.made_s
            end = End(record.kind, steady_name(record.name), record.type, name)
            ends[end] = min(ends.get(end, (words, when)), (words, when), key=lambda each: each[1])
    known = dict.fromkeys(node.name for node in recording.nodes if is_compared(node.name))
    parameters = {steady_name(name): {key: each.value for key, each in recording.parameters(name).items()} for name in known}
    flows: dict[str, Flow] = {}
    for topic, record_of in recording.topics.items():
        if topic not in NOT_COMPARED and record_of.publishers:
            published = recording.published(topic, record_of.type)
            lasting = [
                (time / 1e9, wire)
                for time, node, wire in published
                if nodes.get(steady_name(node)) != BRIEFLY and time / 1e9 <= asked_s
            ]
            add_messages(flows, topic, record_of.type, lasting, class_of)
            flows.setdefault(topic, Flow([], {}))
    nodes_of: dict[str, set[str]] = {}
    for node in recording.nodes:
        nodes_of.setdefault(node.process, set()).add(steady_name(node.name))
    programs = {
        each.name: Program(each.started_s, each.ended_s, each.returncode, frozenset(nodes_of.get(each.name, ())))
        for each in recording.processes
        if each.name != 'launch'
    }
    return Observation(nodes, ends, parameters, flows, _lines(recording), programs, asked_s)


def _lines(recording: Recording) -> list[Line]:
    pieces: dict[tuple[str, str], list[tuple[float, str]]] = {}
    for output in recording.output:
        if output.process != 'launch':
            pieces.setdefault((output.process, output.stream), []).append((output.time_s, output.text))
    return [line for (process, _), written in pieces.items() for line in lines_of(program_of(process), written)]

"""A run in simulation, observed: everything is read from its recording."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from edulaunch.comparing.observation import (
    BRIEFLY,
    NOT_COMPARED,
    End,
    Flow,
    Line,
    Observation,
    add_messages,
    is_compared,
    lines_of,
    program_of,
)
from edulaunch.graph.qos import QoS
from edulaunch.recording import Recording
from edulaunch.session import Session

FOUND_S = 3.0
"""A node that lasts longer is found by everybody for real."""
END_S = 15.0
"""After Ctrl-C."""


def simulate(path: str, file: str | None, arguments: Mapping[str, str], seconds: float, workspaces: Sequence[str]) -> Observation:
    """Run it, press Ctrl-C after `seconds`, and say what was seen.

    :raises UnusableInput: when it cannot be launched at all.
    """
    with Session(workspaces=workspaces) as session:
        launch = session.launch(path, file, arguments)
        session.run(seconds)
        launch.raise_error()
        session.interrupt()
        session.run(END_S)
        recording = session.recording()
    return observe(recording, seconds)


def observe(recording: Recording, asked_s: float) -> Observation:
    """What a recording shows; Ctrl-C was pressed at `asked_s`."""
    nodes: dict[str, float] = {}
    for node in recording.nodes:
        if is_compared(node.name):
            lasted_s = (asked_s if node.ended_s is None else node.ended_s) - node.started_s
            when = node.started_s if lasted_s > FOUND_S else BRIEFLY
            nodes[node.name] = min(when, nodes.get(node.name, BRIEFLY))
    ends: dict[End, tuple[str, float]] = {}
    for record in recording.ends:
        if is_compared(record.node):
            qos = QoS(*record.qos) if record.kind in ('publisher', 'subscription') else None
            words = '' if qos is None else f'{qos.reliability} {qos.durability}'
            when = record.made_s if nodes[record.node] != BRIEFLY else BRIEFLY
            ends.setdefault(End(record.kind, record.name, record.type, record.node), (words, when))
    parameters = {name: {key: each.value for key, each in recording.parameters(name).items()} for name in nodes}
    flows: dict[str, Flow] = {}
    for topic, record_of in recording.topics.items():
        if topic not in NOT_COMPARED and record_of.publishers:
            published = recording.published(topic, record_of.type)
            lasting = [
                (time / 1e9, wire) for time, node, wire in published if nodes.get(node) != BRIEFLY and time / 1e9 <= asked_s
            ]
            add_messages(flows, topic, record_of.type, lasting, recording.message_class)
            flows.setdefault(topic, Flow([], {}))
    return Observation(nodes, ends, parameters, flows, _lines(recording), _codes(recording), asked_s)


def _lines(recording: Recording) -> list[Line]:
    pieces: dict[tuple[str, str], list[tuple[float, str]]] = {}
    for output in recording.output:
        if output.process != 'launch':
            pieces.setdefault((output.process, output.stream), []).append((output.time_s, output.text))
    return [line for (process, _), written in pieces.items() for line in lines_of(program_of(process), written)]


def _codes(recording: Recording) -> dict[str, list[int]]:
    codes: dict[str, list[int]] = {}
    for process in recording.processes:
        if process.name != 'launch' and process.returncode is not None:
            codes.setdefault(program_of(process.name), []).append(process.returncode)
    return codes

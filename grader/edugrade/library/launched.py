"""Finds the programs that a launch started, and checks which programs publish a topic."""

from __future__ import annotations

import os
from collections.abc import Collection
from typing import TYPE_CHECKING

from ..evidence import Evidence, Failure, Missing
from ..source import shipped_program
from .identity import nodes_of, process_of, processes_of
from .written import node_of

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord, ProcessRecord

VISITOR = 'visitor'
"""The process of the grader's own node. Launch gives each process a number, so no other process has this name."""


def refuse_strangers(recording: Recording, topic: str, package: str, executable: str | None = None) -> None:
    """Fail unless only programs of a package publish a topic.

    :param executable: the only program of the package that may publish the topic (default: all of its programs).
    :raises Failure: with the name of another node that publishes the topic.
    """
    found = stranger(recording, topic, package, executable)
    if found is not None:
        node, process = found
        raise Failure(
            f'{node.name} publishes on {topic}, but only a program of {package} may publish there',
            expected=f'only {package} publishes on {topic}',
            seen=f'the process {node.process} publishes on it',
            where=process.origin if process else None,
            try_='publish on another topic, and move turtles and robots with velocity commands',
        )


def stranger(
    recording: Recording, topic: str, package: str, executable: str | None = None, names: Collection[str] | None = None
) -> tuple[NodeRecord, ProcessRecord | None] | None:
    """Return a node whose program publishes a topic without permission, and the process of the node. Return None if there is no
    such node.

    The node of the grader, which publishes the messages of `Scenario.sent`, is ignored.

    :param names: the names of the nodes to look at (default: all nodes).
    """
    own, owners = set(nodes_of(recording, package, executable)), recording.owners
    for position, node in enumerate(recording.nodes):
        is_of_the_grader = node.process == VISITOR if owners is None else owners['nodes'][position] < 0
        is_asked = names is None or node.name in names
        if is_asked and position not in own and not is_of_the_grader and any(name == topic for name, _ in node.publishers):
            return node, process_of(recording, node, position)
    return None


def find_processes(recording: Recording, package: str, executable: str) -> list[ProcessRecord]:
    """Return the processes of one executable in the order in which they started, even if ``ros2 run`` or a shell started them."""
    return [recording.processes[position] for position in processes_of(recording, package, executable)]


def _named(recording: Recording, package: str, executable: str) -> list[ProcessRecord]:
    return [process for process in recording.processes if (process.package, process.executable) == (package, executable)]


def require_process(run: Evidence, package: str, executable: str) -> ProcessRecord:
    """Return the first process of an executable in the first scenario.

    :raises Missing: if the launch did not start the executable, with the names of the started executables.
    :raises Failure: if another program ran with the name of the executable.
    """
    found = find_processes(run.first, package, executable)
    if found:
        return found[0]
    others = _named(run.first, package, executable)
    if others:
        raise Failure(
            f'{executable} of the package {package} is not the program of edulaunch',
            expected=shipped_program(package, executable),
            seen=' '.join(others[0].argv),
            where=others[0].origin,
            try_=f'remove the prefix of the Node, or give your own package another name than {package}',
        )
    started = [process.executable or os.path.basename(process.argv[0]) for process in launched(run.first)]
    raise Missing(
        f'the node {executable} of the package {package}',
        name=executable,
        among=started,
        expected=node_of(run, package, executable),
        where=run.source.place,
        try_=f'add {node_of(run, package, executable)} to the launch file',
    )


def launched(recording: Recording) -> list[ProcessRecord]:
    """Return every process except launch itself, which is the first process."""
    known = recording.processes
    return known[1:] if known and known[0].name == 'launch' else list(known)


def included_files(recording: Recording) -> list[str]:
    """Return the file names of the included launch files. The launched file itself is left out."""
    return [os.path.basename(path) for path in recording.includes if path != recording.launch.file]


def refuse_shared_names(run: Evidence) -> None:
    """Fail if two nodes with the same name run at the same time, because ROS 2 cannot distinguish them.

    :raises Failure: with the names of both programs.
    """
    for recording in run.values():
        owners: dict[str, str] = {}
        for node in recording.nodes:
            other = owners.setdefault(node.name, node.process)
            if other != node.process and node.ended_s is None:
                raise Failure(
                    f'two nodes have the name {node.name}',
                    where=_place_of(run, recording, node.process),
                    expected='each node has its own name',
                    seen=f'{other} and {node.process} have the same name',
                    try_=f'give {node.process} another name',
                )


def _place_of(run: Evidence, recording: Recording, name: str) -> tuple[str, int | None] | None:
    """Return the launch file and line of a process or, if they are unknown, the place of the submission."""
    origins = [process.origin for process in recording.processes if process.name == name and process.origin is not None]
    return origins[0] if origins else run.source.place

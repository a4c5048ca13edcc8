"""Finds the program of a process or a node. The source is the trusted peer of a run, never a claim of a submission.

A recording without provenance comes from a single process (an author's own run), so the names in the launch file are used.
"""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from ..source import comes_with_edulaunch, shipped_program

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord, ProcessRecord

COMMAND = 'ros2'
STARTERS = ('ros2', 'bash', 'sh')  # programs that start other programs under their own name


def program_of(recording: Recording, position: int) -> tuple[str, str] | None:
    """Return the (package, executable) of a process.

    Return None if the process has no package, or falsely claims to be a program of edulaunch.

    :param position: the position of the process in `recording.processes`.
    """
    process, hosted = recording.processes[position], recording.hosted
    if hosted is not None and position in hosted:
        return hosted[position]
    if process.package is None or process.executable is None:
        return None
    if comes_with_edulaunch(process.package) and not _is_stock_by_its_word(process, hosted is not None):
        return None
    return process.package, process.executable


def _is_stock_by_its_word(process: ProcessRecord, is_confined: bool) -> bool:
    """Return whether a process of the confined peer may be one of the stock programs that the trusted peer never runs."""
    package, executable, word = process.package or '', process.executable or '', process.argv[0] if process.argv else ''
    if not is_confined:
        return word == shipped_program(package, executable)
    from edulaunch.runtime.link.trusted_host import runs_beside_the_student

    return runs_beside_the_student(package, executable, word)


def is_stock(recording: Recording, node: int) -> bool:
    """Return whether a node belongs to a program of edulaunch or to a `ros2` command, or is the node of the grader.

    :param node: the position of the node in `recording.nodes`.
    """
    process = process_of(recording, recording.nodes[node], node)
    if process is None:
        return True
    position = recording.processes.index(process) if recording.owners is None else recording.owners['nodes'][node]
    program = program_of(recording, position)
    return _is_command(recording, position, '') or (program is not None and comes_with_edulaunch(program[0]))


def processes_of(recording: Recording, package: str, executable: str | None = None) -> list[int]:
    """Return the positions of the processes that run a program of a package, in the order in which they started.

    The package ros2 means the command ros2. `executable` is then the first words of the command, such as ``bag play``.
    """
    if package == COMMAND:
        return [position for position in range(len(recording.processes)) if _is_command(recording, position, executable or '')]
    return [
        position
        for position in range(len(recording.processes))
        if (found := program_of(recording, position)) is not None and found[0] == package and executable in (None, found[1])
    ]


def nodes_of(recording: Recording, package: str, executable: str | None = None) -> list[int]:
    """Return the positions of the nodes whose process runs a program of a package, in order of creation."""
    if recording.owners is None:
        return [
            position
            for position, node in enumerate(recording.nodes)
            if _is_of_by_name(recording, node.process, package, executable)
        ]
    wanted, owners = set(processes_of(recording, package, executable)), recording.owners['nodes']
    inside = set(components_of(recording, package)) if executable is None else set()
    return [position for position in range(len(recording.nodes)) if owners[position] in wanted or position in inside]


def components_of(recording: Recording, package: str) -> list[int]:
    """Return the positions of the nodes that containers of edulaunch have loaded from a package."""
    containers = set(processes_of(recording, 'rclcpp_components'))
    loaded = {
        call.response.full_node_name
        for call in (recording.service_calls if containers else ())
        if call.service.endswith('/_container/load_node') and call.response and call.request.package_name == package
    }
    owners = recording.owners['nodes'] if recording.owners is not None else []
    return [at for at, owner in enumerate(owners) if owner in containers and recording.nodes[at].name in loaded]


def rows_of(recording: Recording, part: str, package: str, executable: str | None = None) -> list[int]:
    """Return the positions of the rows of `part` ('logs' or 'output') that come from a program of a package."""
    wanted = processes_of(recording, package, executable)
    if recording.owners is None:
        names = {recording.processes[position].name for position in wanted}
        owners = [row.process for row in recording.logs] if part == 'logs' else [row.process for row in recording.output]
        return [position for position, owner in enumerate(owners) if owner in names]
    return [position for position, owner in enumerate(recording.owners[part]) if owner in wanted]


def process_of(recording: Recording, node: NodeRecord, position: int) -> ProcessRecord | None:
    """Return the process of a node, or None if the recording has no such process.

    :param position: the position of the node in `recording.nodes`.
    """
    if recording.owners is not None:
        owner = recording.owners['nodes'][position]
        return recording.processes[owner] if owner >= 0 else None
    return next((process for process in recording.processes if process.name == node.process), None)


def _is_of_by_name(recording: Recording, name: str, package: str, executable: str | None) -> bool:
    """Return whether all processes with a name run a program of a package. Shells and prefixes that start them do not count."""
    if package == COMMAND:
        return any(recording.processes[position].name == name for position in processes_of(recording, package, executable))
    ran = [position for position, process in enumerate(recording.processes) if process.name == name]
    programs = [position for position in ran if not _is_starter(recording.processes[position])]
    found = [program_of(recording, position) for position in programs]
    return bool(found) and all(each is not None and each[0] == package and executable in (None, each[1]) for each in found)


def _is_command(recording: Recording, position: int, words: str) -> bool:
    """Return whether a process is a ros2 command of edulaunch with these first words."""
    first, *others = recording.processes[position].argv or ('',)
    is_ours = recording.hosted is None or position in recording.hosted
    return is_ours and os.path.basename(first) == COMMAND and others[: len(words.split())] == words.split()


def _is_starter(process: ProcessRecord) -> bool:
    return process.package is None and os.path.basename(process.argv[0].split()[0]) in STARTERS

"""What a launch started, or what it started instead; whether that came with edulaunch, and whether a topic speaks for it."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from ..evidence import Evidence, Failure, Missing
from ..source import Place, comes_with_edulaunch, shipped_program

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import ProcessRecord

STARTERS = ('ros2', 'bash', 'sh')  # programs that start others under their own name


def is_stock(process: ProcessRecord) -> bool:
    """Whether a process ran its executable itself: not one of that name in another workspace, nor another program before it.

    An executable of a package that did not come with edulaunch is what its action says.
    """
    if process.package is None or process.executable is None:
        return False
    return not comes_with_edulaunch(process.package) or process.argv[:1] == [shipped_program(process.package, process.executable)]


def refuse_strangers(recording: Recording, topic: str, package: str) -> None:
    """A topic of a world counts only when nobody but the world publishes it.

    :param package: of the programs that may.
    :raises Failure: naming the node that publishes it besides, or instead.
    """
    hosted = recording.hosted_nodes
    for position, node in enumerate(recording.nodes):
        is_stranger = (hosted is not None and position not in hosted) or not is_of(recording, node.process, package)
        if is_stranger and any(name == topic for name, _ in node.publishers):
            origins = [process.origin for process in recording.processes if process.name == node.process]
            raise Failure(
                f'{node.name} publishes {topic}, which only a program of {package} may',
                expected=f'{topic} comes from {package}: it is what happened, and not an answer',
                seen=f'the process {node.process}',
                where=next(filter(None, origins), None),
                try_='publish on another topic, and let the commands move what you want to move',
            )


def is_of(recording: Recording, name: str, package: str) -> bool:
    """Whether the process of that name, or what it started under its name, is of a package and nothing else."""
    ran = [process for process in recording.processes if process.name == name]
    programs = [
        process for process in ran if not (process.package is None and os.path.basename(process.argv[0].split()[0]) in STARTERS)
    ]
    return bool(programs) and all(process.package == package and is_stock(process) for process in programs)


def find_processes(recording: Recording, package: str, executable: str) -> list[ProcessRecord]:
    """The processes of one executable, in order of their start; started by Node, by ``ros2 run`` or by a shell."""
    return [process for process in _named(recording, package, executable) if is_stock(process)]


def _named(recording: Recording, package: str, executable: str) -> list[ProcessRecord]:
    return [process for process in recording.processes if (process.package, process.executable) == (package, executable)]


def require_process(run: Evidence, package: str, executable: str) -> ProcessRecord:
    """The first process of an executable in the first scenario.

    :raises Missing: when none was started; names what was.
    :raises Failure: when something else ran under its name.
    """
    found = find_processes(run.first, package, executable)
    if found:
        return found[0]
    others = _named(run.first, package, executable)
    if others:
        raise Failure(
            f'{executable} of the package {package} is not the one that came with edulaunch',
            expected=shipped_program(package, executable),
            seen=' '.join(others[0].argv),
            where=others[0].origin,
            try_=f'take out the prefix of the Node, or give your own package another name than {package}',
        )
    started = [process.executable or os.path.basename(process.argv[0]) for process in launched(run.first)]
    raise Missing(
        f'the node {executable} of the package {package}',
        name=executable,
        among=started,
        expected=f"Node(package='{package}', executable='{executable}')",
        where=run.source.place,
        try_='add this Node to the LaunchDescription',
    )


def launched(recording: Recording) -> list[ProcessRecord]:
    """Every process but launch itself."""
    return [process for process in recording.processes if process.name != 'launch']


def included_files(recording: Recording) -> list[str]:
    """Names, without folders, of the launch files that were included; not the launched file itself."""
    return [os.path.basename(path) for path in recording.includes if path != recording.launch.file]


def refuse_dead(run: Evidence) -> None:
    """Fail when a process died (ended with another exit code than 0) before its run was over.

    :raises Failure: with the exception's own text and place when one ended it.
    """
    for name, recording in run.items():
        for process in launched(recording):
            if process.returncode:
                raise _death(process, run.scenario(name).words)


def node_names(recording: Recording, processes: list[ProcessRecord]) -> list[str]:
    """Fully qualified names of the nodes in these processes."""
    launched = {process.name for process in processes}
    return [node.name for node in recording.nodes if node.process in launched]


def _death(process: ProcessRecord, words: str) -> Failure:
    when = f'after {process.ended_s:.1f} s, when launched with {words}'
    error = process.exception
    if error is None:
        return Failure(
            f'{process.name} died {when}',
            expected='it runs until the end',
            where=process.origin,
            seen=f'exit code {process.returncode}',
            try_='read what it printed before it died',
        )
    place = Place(error['file'], error['line']) if error.get('file') else process.origin
    origin = '' if process.origin is None else f', at {process.origin[0]}:{process.origin[1]}'
    return Failure(
        f'{process.name} died {when}',
        seen=f'{error["type"]}: {error["message"]}',
        where=place,
        expected='it runs until the end',
        try_=f'look at what the launch file gives it{origin}',
    )


def refuse_shared_names(run: Evidence) -> None:
    """Two nodes that run at the same time must not have one name: ROS 2 cannot tell them apart.

    :raises Failure: names both programs.
    """
    for recording in run.values():
        owners: dict[str, str] = {}
        for node in recording.nodes:
            other = owners.setdefault(node.name, node.process)
            if other != node.process and node.ended_s is None:
                raise Failure(
                    f'two nodes are called {node.name}',
                    where=_place_of(run, recording, node.process),
                    expected='a name of its own for each node',
                    seen=f'{other} and {node.process} share it',
                    try_=f'give {node.process} another name',
                )


def _place_of(run: Evidence, recording: Recording, name: str) -> tuple[str, int | None] | None:
    """Launch file and line of a process, else of the submission."""
    origins = [process.origin for process in recording.processes if process.name == name and process.origin is not None]
    return origins[0] if origins else run.source.place

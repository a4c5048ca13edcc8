"""Whether what ran is what came with edulaunch, and whether a topic speaks for it."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from ..evidence import Failure
from ..source import comes_with_edulaunch, shipped_program

if TYPE_CHECKING:
    from edulaunch.recording import Recording
    from edulaunch.recording.records import ProcessRecord

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

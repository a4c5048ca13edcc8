"""What a launch started, and in words what it started instead."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from ..evidence import Evidence
from ..failure import Failure, Missing
from ..place import Place

if TYPE_CHECKING:
    from edulaunch.recording import Recording
    from edulaunch.recording.records import ProcessRecord


def find_processes(recording: Recording, package: str, executable: str) -> list[ProcessRecord]:
    """The processes of one executable, in order of their start; started by Node or by ``ros2 run``."""
    return [
        process
        for process in recording.processes
        if (process.package, process.executable) == (package, executable)
        or _words_of_run(process.argv) == [package, executable]
    ]


def require_process(
    run: Evidence, package: str, executable: str, *, try_: str | None = None
) -> ProcessRecord:
    """The first process of an executable in the first scenario.

    :raises Missing: when none was started; names what was.
    """
    found = find_processes(run.first, package, executable)
    if found:
        return found[0]
    started = [process.executable or os.path.basename(process.argv[0]) for process in run.first.processes]
    raise Missing(
        f'the node {executable} of the package {package}',
        name=executable,
        among=started,
        expected=f"Node(package='{package}', executable='{executable}')",
        where=run.source.place,
        try_=try_,
    )


def included_files(recording: Recording) -> list[str]:
    """Names, without folders, of the launch files that were included; not the launched file itself."""
    return [os.path.basename(path) for path in recording.includes if path != recording.launch.file]


def refuse_ended(run: Evidence, package: str, executable: str) -> None:
    """Fail when a process of this executable ended before its run was over.

    :raises Failure: with the exception's own text and place when one ended it.
    """
    for name, recording in run.items():
        for process in find_processes(recording, package, executable):
            if process.ended_s is not None:
                raise _ended(process, run.scenario(name).command)


def node_names(recording: Recording, processes: list[ProcessRecord]) -> list[str]:
    """Fully qualified names of the nodes in these processes."""
    launched = {process.name for process in processes}
    return [node.name for node in recording.nodes if node.process in launched]


def _ended(process: ProcessRecord, command: str) -> Failure:
    with_ = f' when launched with {command}' if command else ''
    error = process.exception
    if error is None:
        return Failure(
            f'{process.name} ended after {process.ended_s:.1f} s with exit code {process.returncode}{with_}',
            where=process.origin,
            try_='read what it printed before it ended',
        )
    where = Place(error['file'], error['line']) if error.get('file') else process.origin
    started = '' if process.origin is None else f'; it was started at {process.origin[0]}:{process.origin[1]}'
    return Failure(
        f'{process.name} was ended by an exception after {process.ended_s:.1f} s{with_}',
        seen=f'{error["type"]}: {error["message"]}',
        where=where,
        try_=f'look at the values that the launch file gives it{started}',
    )


def _words_of_run(argv: list[str]) -> list[str]:
    """Package and executable of a ``ros2 run package executable`` command line."""
    words = [os.path.basename(argv[0]), *argv[1:]] if argv else []
    return words[2:4] if words[:2] == ['ros2', 'run'] else []

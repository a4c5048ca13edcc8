"""Running a program and reading its lines as they come."""

from __future__ import annotations

from collections import deque
from collections.abc import Iterator, Mapping

from ._program import Command, program

Piece = tuple[bytes | None, bytes | None, int | None]


def execute_process(
    cmd: Command, cwd: str | None = None, env: Mapping[str, str] | None = None, shell: bool = False, emulate_tty: bool = False
) -> Iterator[bytes | int]:
    """Each line of the program's output (standard error too), and at the end its return code.

    :param emulate_tty: programs here print as if in a terminal anyway.
    :raises FileNotFoundError: when there is no such command.
    """
    for out, err, returncode in execute_process_split(cmd, cwd, env, shell, emulate_tty):
        piece = out if out is not None else err
        yield piece if piece is not None else returncode or 0


def execute_process_split(
    cmd: Command, cwd: str | None = None, env: Mapping[str, str] | None = None, shell: bool = False, emulate_tty: bool = False
) -> Iterator[Piece]:
    """As :func:`execute_process`, each as (line of standard output, line of standard error, return code), two of them None."""
    from edulaunch.processes import current_process
    from edulaunch.sim.task import current_task

    process, task = current_process(), current_task()
    pieces: deque[Piece] = deque()
    rest = {'stdout': '', 'stderr': ''}

    def add(stream: str, line: str) -> None:
        data = line.encode()
        pieces.append((data, None, None) if stream == 'stdout' else (None, data, None))

    def on_output(stream: str, text: str) -> None:
        *lines, rest[stream] = (rest[stream] + text).split('\n')
        for line in lines:
            add(stream, f'{line}\n')
        task.wake()

    def on_exit(returncode: int) -> None:
        for stream, text in rest.items():
            if text:
                add(stream, text)
        pieces.append((None, None, returncode))
        task.wake()

    process.host.start(program(process, cmd, cwd, env, shell), on_output=on_output, on_exit=on_exit)
    while True:
        while not pieces:
            task.park()
        piece = pieces.popleft()
        yield piece
        if piece[2] is not None:
            return

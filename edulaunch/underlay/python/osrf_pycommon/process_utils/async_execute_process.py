"""Running programs on an asyncio loop."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import TYPE_CHECKING, Any

from ._program import Command, program

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop, SubprocessProtocol, SubprocessTransport


def get_loop() -> AbstractEventLoop:
    """The asyncio loop of the running task; made, on simulated time, when there is none yet or it is closed."""
    from edulaunch.processes import current_process
    from edulaunch.sim.aio import new_event_loop

    state = current_process().state
    loop: AbstractEventLoop | None = state.get('osrf_pycommon.loop')
    if loop is None or loop.is_closed():
        loop = state['osrf_pycommon.loop'] = new_event_loop()
    return loop


async def async_execute_process(
    protocol_class: Callable[[], SubprocessProtocol],
    cmd: Command,
    cwd: str | None = None,
    env: Mapping[str, str] | None = None,
    shell: bool = False,
    emulate_tty: bool = False,
    stderr_to_stdout: bool = True,
) -> tuple[SubprocessTransport, Any]:
    """Start a program on the running loop; returns its transport and its protocol.

    :param protocol_class: a sub-class of `AsyncSubprocessProtocol`, or whatever makes such a protocol.
    :param emulate_tty: programs here print as if in a terminal anyway.
    :raises FileNotFoundError: when there is no such command.
    """
    import asyncio
    from subprocess import PIPE, STDOUT

    from edulaunch.processes import current_process
    from edulaunch.sim.aio import SimulatedEventLoop

    loop = asyncio.get_running_loop()
    process = current_process()
    spec = program(process, cmd, cwd, env, shell)
    if isinstance(loop, SimulatedEventLoop):
        from .program_transport import ProgramTransport

        protocol = protocol_class()
        return ProgramTransport(loop, protocol, process.host, spec, stderr_to_stdout), protocol
    options: dict[str, Any] = {'cwd': cwd, 'env': spec.env, 'stdout': PIPE, 'stderr': STDOUT if stderr_to_stdout else PIPE}
    if shell:
        return await loop.subprocess_shell(protocol_class, ' '.join(spec.argv), **options)
    return await loop.subprocess_exec(protocol_class, *spec.argv, **options)

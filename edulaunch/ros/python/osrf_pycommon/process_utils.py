"""Functions that find event loops and programs."""

from __future__ import annotations

from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop

_ABSENT = ('AsyncSubprocessProtocol', 'async_execute_process', 'execute_process', 'execute_process_split')


def get_loop() -> AbstractEventLoop:
    """Return the asyncio loop of the running task. If the task has no open loop, create one on simulated time."""
    from edulaunch.engine.processes import current_process
    from edulaunch.engine.sim.aio import new_event_loop

    state = current_process().state
    loop: AbstractEventLoop | None = state.get('osrf_pycommon.loop')
    if loop is None or loop.is_closed():
        loop = state['osrf_pycommon.loop'] = new_event_loop()
    return loop


def which(cmd: str, mode: int = 1, path: str | None = None, **kwargs: object) -> str | None:
    """Return the path of a program, as `shutil.which` does, or None if there is no such program.

    :param path: the search path. The default is the PATH of the running process.
    """
    import shutil

    from edulaunch.engine.processes import current_process

    return shutil.which(cmd, mode, current_process().env.get('PATH') if path is None else path)


def __getattr__(name: str) -> object:
    if name in _ABSENT:
        raise ImportError(
            f'cannot import name {name!r} from {__name__!r}\n'
            '  help: it is not part of edulaunch: use subprocess, or ExecuteProcess in a launch file'
        )
    raise AttributeError(f'module {__name__!r} has no attribute {name!r}')

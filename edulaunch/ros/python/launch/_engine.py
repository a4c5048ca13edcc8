"""The connection of launch to the engine. No other module of launch uses edulaunch's processes.

All data belongs to the running process, so that two simulations in one interpreter are separate.
"""

from __future__ import annotations

import os
from collections.abc import Callable, MutableMapping, Sequence
from functools import lru_cache
from types import ModuleType
from typing import TYPE_CHECKING, Any, Protocol, TypeVar

if TYPE_CHECKING:
    from asyncio import AbstractEventLoop

    from edulaunch.engine.processes import Process, ProcessSpec

T = TypeVar('T')


class OfProcess(Protocol):
    """The part of a launch context that belongs to the process that runs the launch."""

    process_state: dict[str, Any]
    process_counter: list[int]


def running_process() -> Process:
    """Return the process that runs launch: a simulated `ros2 launch`, or the process that represents a plain script."""
    return _current_process()()


@lru_cache(maxsize=1)
def _current_process() -> Callable[[], Process]:
    # Every action calls this function, and an import statement would take as long as the rest of it.
    from edulaunch.engine.processes.current import current_process

    return current_process


def is_plain_script() -> bool:
    """Return whether the running code belongs to a plain script or a notebook cell, and not to a simulated program."""
    from edulaunch.engine.sim.task import AmbientTask, current_task

    return isinstance(current_task(), AmbientTask)


def environment() -> MutableMapping[str, str]:
    """Return the environment variables of the running process as a mutable mapping. Upstream uses `os.environ`."""
    return running_process().env


def inside(path: str | os.PathLike[str]) -> str:
    """Return the path as the running process resolves it, because each terminal of a machine has its own folder."""
    return running_process().path(os.fspath(path))


def process_state(key: str, make: Callable[[], T]) -> T:
    """Return the value stored under `key` in the running process. The first call in each process creates the value with `make`.

    Upstream stores such values in globals.
    """
    state = running_process().state
    if key not in state:
        state[key] = make()
    value: T = state[key]
    return value


def state_of(context: OfProcess) -> dict[str, Any]:
    """Return the state of the process that runs this context.

    A context that a test creates has no such state. In that case, return the state of the running process.
    """
    try:
        return context.process_state
    except AttributeError:
        return running_process().state


def process_counter(context: OfProcess) -> list[int]:
    """Return a list whose only item is the number of the process that was numbered last. All contexts of a process share the
    list.
    """
    try:
        return context.process_counter
    except AttributeError:
        return process_state('launch.process_counter', lambda: [0])


def generated_files() -> dict[str, Any]:
    """Return the files that launch generated for the programs of this simulation, by path; see `Host.generated_files`."""
    return running_process().host.generated_files


def new_event_loop() -> AbstractEventLoop:
    """Return an asyncio loop on simulated time for the running task."""
    from edulaunch.engine.sim.aio import new_event_loop

    return new_event_loop()


def load_module(path: str, module_name: str) -> ModuleType:
    """Execute a Python file with the private modules of the running process."""
    return running_process().loader.run_file(path, module_name)


def import_for_expression(name: str) -> ModuleType:
    """Return a module for a Python expression in a launch file. The simulation's own `time`, `random` and similar modules come
    first.
    """
    return running_process().loader.import_(name, fromlist=('*',))


def assumptions() -> Any:
    """Return what a dry run with missing packages assumes (`edulaunch.advice.plan.assumptions.Assumptions`), otherwise None."""
    return running_process().state.get('launch.assumptions')


def absent_package(package: str) -> str | None:
    """Return the name of the project that a missing well-known package belongs to, such as 'Gazebo'.

    Return None for any other package. In a dry run, always return None, because a dry run must report what is missing.
    """
    process = running_process()
    return None if 'launch.assumptions' in process.state else process.index.absent(package)


def run_command(argv: Sequence[str], *, stderr_to_stdout: bool) -> tuple[int, str, str]:
    """Run a command until it ends. Return its exit code, standard output and standard error.

    A dry run with missing packages may replace the output; see :func:`assumptions`. A command that the simulation has (`ros2
    ...`) runs in the simulation, while launch waits in simulated time. Any other command is a real program. Such a program
    takes no simulated time, so that every run is the same.

    :raises FileNotFoundError: when there is no such command.
    """
    from edulaunch.engine.processes import ProcessSpec

    process = running_process()
    assumed = assumptions()
    text = None if assumed is None else assumed.output_of(argv, process.env.get('PATH'))
    if text is not None:
        return 0, text, ''
    spec = ProcessSpec(argv=tuple(argv), name=os.path.basename(argv[0]), cwd=process.cwd, env=dict(process.env))
    if not process.host.knows(spec):
        return _run_real_command(argv, spec, stderr_to_stdout)
    return _run_known_command(process, spec, stderr_to_stdout)


def _run_known_command(process: Process, spec: Any, stderr_to_stdout: bool) -> tuple[int, str, str]:
    from edulaunch.engine.sim.task import current_task

    task = current_task()
    texts = {'stdout': '', 'stderr': ''}
    codes: list[int] = []

    def on_output(stream: str, text: str) -> None:
        texts['stdout' if stderr_to_stdout else stream] += text

    def on_exit(code: int) -> None:
        codes.append(code)
        task.wake()

    process.host.start_command(spec, on_output, on_exit)
    while not codes:
        task.park()
    return codes[0], texts['stdout'], texts['stderr']


def _run_real_command(argv: Sequence[str], spec: ProcessSpec, stderr_to_stdout: bool) -> tuple[int, str, str]:
    import subprocess

    done = subprocess.run(
        list(argv),
        cwd=spec.cwd,
        env=spec.env,
        text=True,
        stdin=subprocess.DEVNULL,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT if stderr_to_stdout else subprocess.PIPE,
    )
    return done.returncode, done.stdout, done.stderr or ''

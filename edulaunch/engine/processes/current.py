"""Whose code is running."""

from __future__ import annotations

from edulaunch.engine.processes.process import Process
from edulaunch.engine.sim.task import AmbientTask, current_task


def current_process() -> Process:
    """The process whose code runs now.

    Outside any simulation (a plain script, a notebook cell that uses `rclpy` by itself) it is the *ambient* process of this
    thread: made at first use, with a simulation, graph and host of its own; waiting in it runs that simulation in place.
    """
    task = current_task()
    process: Process | None = task.owner
    if process is None:
        process = task.owner = _ambient_process(task)
    return process


def _ambient_process(task: object) -> Process:
    from edulaunch.engine.processes.ambient import make_ambient_process

    assert isinstance(task, AmbientTask)
    return make_ambient_process(task)

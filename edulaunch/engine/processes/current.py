"""The process whose code is running now."""

from __future__ import annotations

from edulaunch.engine import outside
from edulaunch.engine.processes.process import Process
from edulaunch.engine.sim.task import current_task


def current_process() -> Process:
    """Return the process whose code is running now.

    Outside any simulation (a plain script, a notebook cell that uses `rclpy` directly), return the *ambient* process of this
    thread. It is created on first use, with its own simulation, graph and host. When code of this process waits, its
    simulation runs.
    """
    task = current_task()
    process: Process | None = task.owner
    if process is None:
        process = task.owner = outside.make_process(task)
    return process

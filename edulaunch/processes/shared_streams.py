"""`sys.stdout`, `sys.stderr` and `sys.stdin` for modules that all programs share: each call reaches the program that makes it.

A student's own modules see streams of their program through the `sys` view. What the standard library or an installed package
writes (warnings, `help()`, progress bars) goes through the real `sys`, which has these in their place while a simulation runs.
"""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager
from typing import Any

from edulaunch.sim.task import AmbientTask, running_task

NAMES = ('stdin', 'stdout', 'stderr')


class SharedStream:
    """The stream of that name of the program whose code runs; outside any program, and below its own output, the real one."""

    def __init__(self, name: str, real: Any) -> None:
        self._name = name
        self._real = real

    def _here(self) -> Any:
        task = running_task()
        process = None if task is None or isinstance(task, AmbientTask) else task.owner
        return self._real if process is None or process.is_writing else getattr(process, self._name)

    def __getattr__(self, name: str) -> Any:
        return getattr(self._here(), name)

    def __iter__(self) -> Iterator[str]:
        return iter(self._here())


@contextmanager
def streams_of_programs() -> Iterator[None]:
    """Meanwhile what a program writes to the real `sys`, through modules that it shares with others, goes to its own streams."""
    before = {name: getattr(sys, name) for name in NAMES}
    ours = {name: SharedStream(name, stream) for name, stream in before.items()}
    for name in NAMES:
        setattr(sys, name, ours[name])
    try:
        yield
    finally:
        for name in NAMES:
            if getattr(sys, name) is ours[name]:
                setattr(sys, name, before[name])

"""`time` in simulated time: all clocks are the simulation's."""

from __future__ import annotations

import time as real
from calendar import timegm
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names
from edulaunch.sim import sync
from edulaunch.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


def make(view: ModuleType, process: Process) -> ModuleType:
    """Clocks read the simulated time (counted as a poll, so that a loop that only looks is moved on); `sleep` lets it pass."""
    sim = process.sim

    def time_ns() -> int:
        current_task().poll()
        return sim.now_ns

    def monotonic_ns() -> int:
        current_task().poll()
        return sim.now_ns - sim.start_ns

    def seconds(convert: Any) -> Any:
        """The real function with the simulated time as its default argument."""

        def converted(when: float | None = None) -> Any:
            return convert(sim.now_ns / 1e9 if when is None else when)

        return converted

    def strftime(form: str, when: Any = None) -> str:
        return real.strftime(form, real.gmtime(sim.now_ns // 10**9) if when is None else when)

    functions: dict[str, Any] = {
        'time': lambda: time_ns() / 1e9,
        'time_ns': time_ns,
        'monotonic': lambda: monotonic_ns() / 1e9,
        'monotonic_ns': monotonic_ns,
        'perf_counter': lambda: monotonic_ns() / 1e9,
        'perf_counter_ns': monotonic_ns,
        'process_time': lambda: monotonic_ns() / 1e9,
        'process_time_ns': monotonic_ns,
        'thread_time': lambda: monotonic_ns() / 1e9,
        'thread_time_ns': monotonic_ns,
        'clock_gettime_ns': lambda clock, /: time_ns() if clock == real.CLOCK_REALTIME else monotonic_ns(),
        'clock_gettime': lambda clock, /: (time_ns() if clock == real.CLOCK_REALTIME else monotonic_ns()) / 1e9,
        'sleep': _sleep_of(process),
        'mktime': lambda when, /: float(timegm(when)),
        'strftime': strftime,
        'gmtime': seconds(real.gmtime),
        'localtime': seconds(real.gmtime),
        'ctime': seconds(lambda when: real.asctime(real.gmtime(when))),
        'asctime': lambda when=None: real.asctime(real.gmtime(sim.now_ns // 10**9) if when is None else when),
    }
    # as with the real ones, a class that keeps such a function does not turn it into a method
    view.__dict__.update({name: staticmethod(function) for name, function in functions.items()})
    view.__dict__.update(timezone=0, altzone=0, daylight=0, tzname=('UTC', 'UTC'))
    copy_names(view, real)
    return view


def _sleep_of(process: Process) -> Any:
    def sleep(seconds: float, /) -> None:
        if process.on_sleep is not None:
            process.on_sleep(seconds)
        sync.sleep(seconds)

    return sleep

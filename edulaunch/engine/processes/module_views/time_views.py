"""`time` and `datetime` in simulated time: all clocks show the time of the simulation."""

from __future__ import annotations

import datetime as real_datetime
import time
from calendar import timegm
from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.processes.module_views import copy_names
from edulaunch.engine.sim import sync
from edulaunch.engine.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process
    from edulaunch.engine.sim.simulation import Simulation


def make_time(view: ModuleType, process: Process) -> ModuleType:
    """Make all clocks return simulated time, and make `sleep` wait in simulated time.

    Each reading of a clock counts as a poll, so that a loop that only reads the clock does not run forever.
    """
    functions = {**_clocks(process.sim), **_conversions(process.sim), 'sleep': _sleep_of(process)}
    # like the functions of the real module, these do not become methods when a class stores them
    view.__dict__.update({name: staticmethod(function) for name, function in functions.items()})
    view.__dict__.update(timezone=0, altzone=0, daylight=0, tzname=('UTC', 'UTC'))
    copy_names(view, time)
    return view


def _clocks(sim: Simulation) -> dict[str, Any]:
    def time_ns() -> int:
        current_task().poll()
        return sim.now_ns

    def monotonic_ns() -> int:
        current_task().poll()
        return sim.now_ns - sim.start_ns

    return {
        'time': lambda: time_ns() / 1e9,
        'time_ns': time_ns,
        **dict.fromkeys(('monotonic', 'perf_counter', 'process_time', 'thread_time'), lambda: monotonic_ns() / 1e9),
        **dict.fromkeys(('monotonic_ns', 'perf_counter_ns', 'process_time_ns', 'thread_time_ns'), monotonic_ns),
        'clock_gettime_ns': lambda clock, /: time_ns() if clock == time.CLOCK_REALTIME else monotonic_ns(),
        'clock_gettime': lambda clock, /: (time_ns() if clock == time.CLOCK_REALTIME else monotonic_ns()) / 1e9,
    }


def _conversions(sim: Simulation) -> dict[str, Any]:
    """Return the functions that convert a time. The default argument is the simulated time, and the time zone is UTC."""

    def seconds(convert: Any) -> Any:
        """Return a version of the real function whose default argument is the simulated time."""

        def converted(when: float | None = None) -> Any:
            return convert(sim.now_ns / 1e9 if when is None else when)

        return converted

    def now() -> time.struct_time:
        return time.gmtime(sim.now_ns // 10**9)

    def strftime(form: str, when: Any = None) -> str:
        return time.strftime(form, now() if when is None else when)

    return {
        'mktime': lambda when, /: float(timegm(when)),
        'strftime': strftime,
        'gmtime': seconds(time.gmtime),
        'localtime': seconds(time.gmtime),
        'ctime': seconds(lambda when: time.asctime(time.gmtime(when))),
        'asctime': lambda when=None: time.asctime(now() if when is None else when),
    }


def _sleep_of(process: Process) -> Any:
    def sleep(seconds: float, /) -> None:
        if process.on_sleep is not None:
            process.on_sleep(seconds)
        sync.sleep(seconds)

    return sleep


class _RealInstances(type):
    """A metaclass that makes isinstance() accept instances of the real class, too."""

    def __instancecheck__(cls, instance: object) -> bool:
        return isinstance(instance, cls.__mro__[1])


def make_datetime(view: ModuleType, process: Process) -> ModuleType:
    """Make a `datetime` whose local time is UTC, so that a run does not depend on the computer's time zone."""
    sim = process.sim

    def now() -> real_datetime.datetime:
        current_task().poll()
        return real_datetime.datetime(1970, 1, 1) + real_datetime.timedelta(microseconds=sim.now_ns // 1000)

    view.__dict__.update(datetime=_datetime(now), date=_date(now))
    copy_names(view, real_datetime)
    return view


def _datetime(now: Callable[[], real_datetime.datetime]) -> type:
    class datetime(real_datetime.datetime, metaclass=_RealInstances):
        """The simulated `datetime.datetime`."""

        def __reduce_ex__(self, protocol: Any) -> Any:
            return real_datetime.datetime, real_datetime.datetime.__reduce_ex__(self, protocol)[1]

        def __repr__(self) -> str:
            return f'datetime.{super().__repr__()}'

        @classmethod
        def now(cls, tz: real_datetime.tzinfo | None = None) -> Any:
            """Return the simulated time, in the time zone `tz` (default: UTC without a time zone)."""
            return now() if tz is None else now().replace(tzinfo=real_datetime.timezone.utc).astimezone(tz)

        @classmethod
        def fromtimestamp(cls, timestamp: float, tz: real_datetime.tzinfo | None = None) -> Any:
            """Return the time of a timestamp, in the time zone `tz` or without a time zone in UTC."""
            made = super().fromtimestamp(timestamp, tz or real_datetime.timezone.utc)
            return made if tz is not None else made.replace(tzinfo=None)

        @classmethod
        def utcnow(cls) -> Any:
            """Return the simulated time in UTC, without a time zone."""
            return now()

        @classmethod
        def today(cls) -> Any:
            """Return the simulated time in UTC, without a time zone."""
            return now()

    return datetime


def _date(now: Callable[[], real_datetime.datetime]) -> type:
    class date(real_datetime.date, metaclass=_RealInstances):
        """The simulated `datetime.date`."""

        def __reduce_ex__(self, protocol: Any) -> Any:
            return real_datetime.date, real_datetime.date.__reduce_ex__(self, protocol)[1]

        def __repr__(self) -> str:
            return f'datetime.{super().__repr__()}'

        @classmethod
        def today(cls) -> Any:
            """Return the simulated date."""
            return now().date()

        @classmethod
        def fromtimestamp(cls, timestamp: float, /) -> Any:
            """Return the date of a timestamp in UTC."""
            return (real_datetime.datetime(1970, 1, 1) + real_datetime.timedelta(seconds=timestamp)).date()

    return date

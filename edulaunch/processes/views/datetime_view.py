"""`datetime` in simulated time: `now`, `utcnow` and `today` read the simulation's clock."""

from __future__ import annotations

import datetime as real
from collections.abc import Callable
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names
from edulaunch.sim.task import current_task

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class _RealInstances(type):
    """isinstance() with one of our classes accepts what the real class made."""

    def __instancecheck__(cls, instance: object) -> bool:
        return isinstance(instance, cls.__mro__[1])


def make(view: ModuleType, process: Process) -> ModuleType:
    """Local time is UTC, so that a run does not depend on the machine's time zone."""
    sim = process.sim

    def now() -> real.datetime:
        current_task().poll()
        return real.datetime(1970, 1, 1) + real.timedelta(microseconds=sim.now_ns // 1000)

    view.__dict__.update(datetime=_datetime(now), date=_date(now))
    copy_names(view, real)
    return view


def _datetime(now: Callable[[], real.datetime]) -> type:
    class datetime(real.datetime, metaclass=_RealInstances):
        """As `datetime.datetime`."""

        def __reduce_ex__(self, protocol: Any) -> Any:
            return real.datetime, real.datetime.__reduce_ex__(self, protocol)[1]

        def __repr__(self) -> str:
            return f'datetime.{super().__repr__()}'

        @classmethod
        def now(cls, tz: real.tzinfo | None = None) -> Any:
            """The simulated time."""
            return now() if tz is None else now().replace(tzinfo=real.timezone.utc).astimezone(tz)

        @classmethod
        def fromtimestamp(cls, timestamp: float, tz: real.tzinfo | None = None) -> Any:
            """Local time is UTC."""
            made = super().fromtimestamp(timestamp, tz or real.timezone.utc)
            return made if tz is not None else made.replace(tzinfo=None)

        @classmethod
        def utcnow(cls) -> Any:
            """The simulated time."""
            return now()

        @classmethod
        def today(cls) -> Any:
            """The simulated time."""
            return now()

    return datetime


def _date(now: Callable[[], real.datetime]) -> type:
    class date(real.date, metaclass=_RealInstances):
        """As `datetime.date`."""

        def __reduce_ex__(self, protocol: Any) -> Any:
            return real.date, real.date.__reduce_ex__(self, protocol)[1]

        def __repr__(self) -> str:
            return f'datetime.{super().__repr__()}'

        @classmethod
        def today(cls) -> Any:
            """The simulated day."""
            return now().date()

        @classmethod
        def fromtimestamp(cls, timestamp: float, /) -> Any:
            """The day in UTC."""
            return (real.datetime(1970, 1, 1) + real.timedelta(seconds=timestamp)).date()

    return date

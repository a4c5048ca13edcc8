"""An error as plain data: what rules over errors look at. It may come out of a file, so nothing of it is ever executed."""

from __future__ import annotations

from typing import Any, NamedTuple


class Failure(NamedTuple):
    """An exception that ended a program, a launch or a command.

    :ivar type: name of its class.
    :ivar message: its text, as ROS 2 or Python gives it.
    :ivar facts: what the room that raised it knew and the text does not say: names that were known, the nearest one.
    :ivar process: launch name of the program that it ended.
    """

    type: str
    message: str
    file: str | None = None
    line: int | None = None
    time_s: float | None = None
    process: str | None = None
    facts: dict[str, Any] = {}


def failure_of(error: BaseException) -> Failure:
    """An exception that is at hand; what a room knew of it stands in its attribute `edulaunch_facts`."""
    file, line = getattr(error, 'edulaunch_place', None) or (None, None)
    return Failure(type(error).__name__, str(error), file, line, facts=getattr(error, 'edulaunch_facts', {}))

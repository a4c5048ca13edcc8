"""Determine where a launch stops when a user steps through it."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

if TYPE_CHECKING:
    from edulaunch.advice.plan.steps import Step

GO, INTO, NEXT, EVENT, LINE = 'go', 'into', 'next', 'event', 'line'
"""Where to stop next: GO nowhere, INTO before the next action, NEXT after this include or group, EVENT before the next event.
LINE stops before an action that a line of a file creates, directly or by calling a function.


"""


class Stepper:
    """Determines the steps before which a launch stops.

    :ivar at: the step before which the launch waits now, or None.
    """

    def __init__(self) -> None:
        self.way = GO
        self.at: Step | None = None
        self._depth: int | None = None
        self._place: tuple[str, int] | None = None

    def go(self, way: str, place: tuple[str, int] | None = None) -> None:
        """Continue until the stop that `way` names.

        :param way: the kind of stop.
        :param place: for 'line', the file (a name or a path) and the line.
        """
        self.way, self._place = way, place
        self._depth = self.at.depth if way == NEXT and self.at is not None else None

    def stops_before(self, step: Step) -> bool:
        """Return whether to stop before this action."""
        if step.origin is None or self.way in (GO, EVENT):
            return False
        if self.way == LINE:
            assert self._place is not None
            file, line = self._place
            places = {step.origin, step.place or step.origin}
            return any(place.line == line and file in (place.file, os.path.basename(place.file)) for place in places)
        return self._depth is None or step.depth <= self._depth

    def stops_at(self, event: Step) -> bool:
        """Return whether to stop before this event.

        Forget the depth, because actions after an event are not part of an earlier include.
        """
        self._depth = None
        return self.way == EVENT

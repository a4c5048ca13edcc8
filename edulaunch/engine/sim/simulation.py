"""The kernel in one class: simulated time and the agenda."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from heapq import heappop, heappush
from typing import TYPE_CHECKING, Any

from greenlet import getcurrent

from edulaunch.errors import SimulationError

if TYPE_CHECKING:
    import random

EPOCH_NS = 1_700_000_000_000_000_000
"""Where simulated time starts: an even second, so that printed stamps look real and repeat from run to run."""

FAR_NS = 1 << 63
"""Later than any other time. It is not a float infinity, because comparing integers with that is slow."""

Item = list[Any]
"""An agenda item: [time in ns, priority, sequence, callback]. A cancelled or finished item has no callback."""


class Simulation:
    """The time (integer nanoseconds), the agenda and the seed of one simulation. There is no other clock.

    The agenda is a heap of (time, priority, sequence, callback). Items with equal times run in order of their priority, and
    then in the order in which they were scheduled. Items for the current instant with the usual priority 0 are in a queue
    beside the heap, which is much faster. The order is the same, because the heap's items for this instant were scheduled
    earlier.

    Callbacks run on the *hub*, the greenlet that called :meth:`run`; they must not block (a program that blocks is a
    :class:`~edulaunch.engine.sim.task.Task`).

    :param seed: the seed of every random generator of the run.
    :param start_ns: the simulated time at the beginning, in nanoseconds.
    """

    def __init__(self, seed: int = 0, start_ns: int = EPOCH_NS) -> None:
        self.seed = seed
        self.start_ns = start_ns
        self.now_ns = start_ns
        self.hub: Any = None
        self.agenda: list[Item] = []
        self._soon: deque[Item] = deque()
        self.last_number = 0
        self._stopped = False
        self.hands_on = False  # whether a parking task may switch directly to the next task of this instant
        self.keep_up: Callable[[], object] | None = None
        """Advances simulated time to the real clock that a plain script follows. It is called before each reading of the time."""

    @property
    def elapsed_s(self) -> float:
        """The simulated seconds since the start."""
        return (self.now_ns - self.start_ns) / 1e9

    def schedule(self, at_ns: int, callback: Callable[[], object], priority: int = 0) -> Item:
        """Add `callback` to the agenda, and return the new item.

        :param at_ns: the simulated time in nanoseconds.
        :param priority: among items with equal times, the lowest number runs first.
        :raises SimulationError: if `at_ns` has already passed.
        """
        if at_ns < self.now_ns:
            raise SimulationError(f'cannot schedule {self.now_ns - at_ns} ns into the past')
        self.last_number += 1
        item = [at_ns, priority, self.last_number, callback]
        if at_ns == self.now_ns and not priority:
            self._soon.append(item)
        else:
            heappush(self.agenda, item)
        return item

    @staticmethod
    def cancel(item: Item) -> None:
        """Cancel an item of the agenda. Do nothing if the item has already run."""
        item[3] = None

    def next_time_ns(self) -> int | None:
        """Return the simulated time at which the next item is due, or None for an empty agenda."""
        agenda = self.agenda
        while agenda and agenda[0][3] is None:
            heappop(agenda)
        if self._soon:
            return self.now_ns
        return agenda[0][0] if agenda else None

    def step(self) -> bool:
        """Run the next item. Return False if there is no item."""
        self.hub = getcurrent()
        self.hands_on = False
        return self._run_next(FAR_NS)

    def _run_next(self, limit_ns: int) -> bool:
        """Run the next item. Return False if no item is due by `limit_ns`."""
        agenda, soon = self.agenda, self._soon
        while soon or agenda:
            if soon and not (agenda and agenda[0][0] == self.now_ns and agenda[0][1] <= 0):
                callback = soon.popleft()[3]
            else:
                if agenda[0][0] > limit_ns:
                    return False
                at_ns, _, _, callback = heappop(agenda)
                if callback is not None and at_ns > self.now_ns:
                    self.now_ns = at_ns
            if callback is not None:
                callback()
                return True
        return False

    def run(self, until_ns: int | None = None) -> None:
        """Run items until the agenda is empty, the time has reached `until_ns`, or :meth:`stop` is called.

        :param until_ns: a simulated time in nanoseconds, or None for no limit.
        """
        self._stopped = False
        self.hands_on = True
        self.hub = getcurrent()
        limit_ns = FAR_NS if until_ns is None else until_ns
        while not self._stopped and self._run_next(limit_ns):
            pass
        self.hands_on = False
        if until_ns is not None and not self._stopped and self.now_ns < until_ns:
            self.now_ns = until_ns

    def stop(self) -> None:
        """Make :meth:`run` return after the item that runs now."""
        self._stopped = True
        self.hands_on = False

    def suspend(self, go_on: Callable[[], object]) -> None:
        """Make :meth:`run` return, and run `go_on` before all other items when the simulation continues. See
        `Parking.suspend`.
        """
        heappush(self.agenda, [self.now_ns, -FAR_NS, 0, go_on])
        self.stop()

    @property
    def is_suspended(self) -> bool:
        """Whether a task has suspended the simulation."""
        return bool(self.agenda) and self.agenda[0][1] == -FAR_NS and self.agenda[0][3] is not None

    @property
    def was_stopped(self) -> bool:
        """Whether :meth:`stop` ended the last :meth:`run`."""
        return self._stopped

    def leap(self, to_ns: int) -> None:
        """Set the time forward to `to_ns`, and move all items of the agenda by the same amount. A past time has no effect."""
        by_ns = max(0, to_ns - self.now_ns)
        for item in self.agenda:
            item[0] += by_ns
        self.now_ns += by_ns

    def random(self, name: str) -> random.Random:
        """Return a separate random generator for `name`. The same seed and name give the same numbers on every machine."""
        import random

        return random.Random(f'{self.seed}/{name}'.encode('utf-8', 'surrogatepass'))  # a name may have half a character

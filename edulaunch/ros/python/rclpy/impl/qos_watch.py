"""Classes and functions that watch the deadlines and the liveliness of endpoints, in simulated time."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.graph.qos import MANUAL_BY_TOPIC

if TYPE_CHECKING:
    from edulaunch.engine.graph.topics import Publisher, Subscription, WatchedPublisher


class Countdown:
    """Calls a function when no message or assertion has arrived for a period. The first message or assertion starts the
    countdown.

    :param repeat: whether to call the function again after each further period.
    """

    def __init__(self, endpoint: Any, period_ns: int, expired: Callable[[], object], *, repeat: bool = False) -> None:
        self._endpoint = endpoint
        self._period_ns = period_ns
        self._expired = expired
        self._repeat = repeat
        self.due_ns = 0
        self._item: Any = None

    def seen(self) -> None:
        """Restart the countdown, because a message or assertion arrived."""
        sim = self._endpoint.graph.sim
        self.due_ns = sim.now_ns + self._period_ns
        if self._item is None:
            self._item = sim.schedule(self.due_ns, self._check)

    def _check(self) -> None:
        self._item = None
        if self._endpoint.destroyed:
            return
        sim = self._endpoint.graph.sim
        if sim.now_ns < self.due_ns:
            self._item = sim.schedule(self.due_ns, self._check)
            return
        self._expired()
        if self._repeat:
            self.seen()


class Count:
    """Counts the events between two calls of the callback.

    :param make_info: creates the argument of the callback from the total, the change, and the argument of the last `add`.
    :param tell: called after each change of the count.
    """

    def __init__(self, make_info: Callable[..., Any], tell: Callable[[], object]) -> None:
        self._make_info = make_info
        self._tell = tell
        self._total = self._change = 0
        self._last: tuple[Any, ...] = ()

    def add(self, *last: Any) -> None:
        """Count one more event."""
        self._total += 1
        self._change += 1
        self._last = last
        self._tell()

    def take(self) -> Any:
        """Return the info about the counted events, or None if the callback has already received it."""
        info = self._make_info(self._total, self._change, *self._last) if self._change else None
        self._change = 0
        return info


def watch_deadline(endpoint: Any, missed: Callable[[], object]) -> None:
    """Call `missed` whenever an endpoint has sent or received no message for the time of its deadline."""
    if not endpoint.qos.deadline_ns:
        return
    countdown = Countdown(endpoint, endpoint.qos.deadline_ns, missed, repeat=True)
    if endpoint.kind == 'publisher':
        endpoint.on_publish.append(countdown.seen)
        return
    previous = endpoint.on_ready

    def on_ready() -> None:
        previous()
        countdown.seen()

    endpoint.on_ready = on_ready


def watch_lease(publisher: WatchedPublisher, lost: Callable[[], object]) -> None:
    """Call `lost` when a publisher does not assert its liveliness during its lease."""
    if publisher.qos.liveliness == MANUAL_BY_TOPIC and publisher.qos.lease_ns:
        publisher.on_life.append(Countdown(publisher, publisher.qos.lease_ns, lost).seen)


class LivelinessWatch:
    """Tracks which publishers of a subscription are alive.

    A publisher with a lease is alive from its first assertion to the end of the lease. Any other publisher is alive as long as
    it exists.
    """

    def __init__(self, subscription: Subscription, info_class: Any, tell: Callable[[], object]) -> None:
        self._subscription = subscription
        self._info_class = info_class
        self._tell = tell
        self._alive: dict[Publisher, bool] = {}
        self._reported = (0, 0)

    def look(self) -> None:
        """Update the list of publishers, because publishers may have been created or destroyed."""
        present = self._subscription.publishers
        for publisher in [known for known in self._alive if known not in present]:
            del self._alive[publisher]
            self._changed()
        for publisher in present:
            if publisher not in self._alive:
                self._alive[publisher] = False
                self._meet(publisher)

    def _meet(self, publisher: Any) -> None:
        if publisher.qos.liveliness != MANUAL_BY_TOPIC:
            self._set(publisher, True)
            return
        countdown = Countdown(publisher, self._subscription.qos.lease_ns, lambda: self._set(publisher, False))
        publisher.on_life.append(countdown.seen)
        publisher.on_life.append(lambda: self._set(publisher, True))

    def _set(self, publisher: Publisher, alive: bool) -> None:
        if self._alive.get(publisher, alive) is not alive:
            self._alive[publisher] = alive
            self._changed()

    def _changed(self) -> None:
        if not self._subscription.destroyed:
            self._tell()

    def take(self) -> Any:
        """Return how many publishers are alive and not alive, and the changes. Return None if the callback has already received
        them.
        """
        alive = sum(self._alive.values())
        lost = len(self._alive) - alive
        before, self._reported = self._reported, (alive, lost)
        return None if before == self._reported else self._info_class(alive, lost, alive - before[0], lost - before[1])

"""Topics: publishers, subscriptions, and the delivery of messages between them."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.graph.qos import RELIABLE, TRANSIENT_LOCAL, QoS, incompatible_policy

if TYPE_CHECKING:
    from edulaunch.engine.graph.members import Members
    from edulaunch.engine.graph.node_entry import NodeEntry

Sample = tuple[Any, int, 'Publisher', int]
"""An entry in the queue of a subscription: (wire tuple, time of publication in ns, publisher, number of its message, from
1).
"""


class Endpoint:
    """The common base of publishers and subscriptions."""

    kind = 'endpoint'

    def __init__(self, graph: Members, node: NodeEntry, topic_name: str, cls: Any, qos: QoS) -> None:
        self.graph = graph
        self.node = node
        self.topic_name = topic_name
        self.cls = cls
        self.type_name: str = cls.TYPE
        self.qos = qos
        self.index = graph.next_index()
        self.destroyed = False
        self.on_incompatible: Callable[[str], object] | None = None
        self.on_matched: Callable[[int], object] | None = None

    @property
    def name(self) -> str:
        """The name of the topic."""
        return self.topic_name

    def _report_matched(self, change: int) -> None:
        if self.on_matched is not None:
            self.on_matched(change)

    def _report_incompatible(self, policy: str) -> None:
        if self.on_incompatible is not None:
            self.on_incompatible(policy)


class Publisher(Endpoint):
    """One publisher of one node. `index` is its number in the order of creation."""

    kind = 'publisher'

    def __init__(self, graph: Members, node: NodeEntry, topic_name: str, cls: Any, qos: QoS) -> None:
        super().__init__(graph, node, topic_name, cls, qos)
        self._sim = graph.sim
        self.record = graph.tracer.channel(self)
        self.matched: list[Subscription] = []
        self.published = 0
        self.history: deque[Sample] | None = None
        if qos.durability == TRANSIENT_LOCAL:
            self.history = deque(maxlen=qos.queue_length)

    @property
    def subscription_count(self) -> int:
        """The number of subscriptions that are matched with this publisher."""
        return len(self.matched)

    def publish(self, wire: Any) -> None:
        """Record a wire tuple, add it to the queue of each matched subscription, and call `on_ready` of the subscription."""
        now = self._sim.now_ns
        self.published = number = self.published + 1
        self.record((now, self.index, wire))
        if self.history is not None:
            self.history.append((wire, now, self, number))
        for subscription in self.matched:
            subscription.queue.append((wire, now, self, number))
            subscription.on_ready()

    def late_samples(self) -> list[Sample]:
        """Return the stored messages for a subscription that joins late, without messages whose lifespan is over."""
        return [sample for sample in self.history or () if self.is_current(sample[1])]

    def is_current(self, published_ns: int) -> bool:
        """Return whether a message that was published at `published_ns` (simulated time) is younger than the lifespan."""
        return not self.qos.lifespan_ns or self._sim.now_ns < published_ns + self.qos.lifespan_ns

    def destroy(self) -> None:
        """Remove the publisher from the topic; a second call has no effect. Messages that an ending program publishes
        afterwards are not recorded.
        """
        self.record = _forget
        for subscription in list(self.matched):
            disconnect(self, subscription)
        self.graph.remove_end(self)


class WatchedPublisher(Publisher):
    """A publisher with a deadline or a lease. It calls `on_publish` for each message, and `on_life` for each sign of life."""

    def __init__(self, graph: Members, node: NodeEntry, topic_name: str, cls: Any, qos: QoS) -> None:
        super().__init__(graph, node, topic_name, cls, qos)
        self.on_publish: list[Callable[[], object]] = []
        self.on_life: list[Callable[[], object]] = []

    def publish(self, wire: Any) -> None:
        """Implement `Publisher.publish`."""
        super().publish(wire)
        for callback in self.on_publish:
            callback()
        self.show_life()

    def show_life(self) -> None:
        """Report that the publisher is alive, without a message."""
        for callback in self.on_life:
            callback()


class Subscription(Endpoint):
    """One subscription of one node.

    `queue` contains the waiting samples, oldest first. When the queue is full (QoS depth), it drops the oldest sample.
    `on_ready()` is called after each delivery, while the publisher's code runs. This function may only set a mark or wake a
    task.
    """

    kind = 'subscription'

    def __init__(
        self, graph: Members, node: NodeEntry, topic_name: str, cls: Any, qos: QoS, on_ready: Callable[[], object]
    ) -> None:
        super().__init__(graph, node, topic_name, cls, qos)
        self.on_ready = on_ready
        self.queue: deque[Sample] = deque(maxlen=qos.queue_length)
        self.publishers: list[Publisher] = []
        self.may_expire = False

    def drop_expired(self) -> None:
        """Drop the waiting messages that are older than the lifespan of their publisher."""
        if self.graph.sim.keep_up is not None:
            self.graph.sim.keep_up()
        current = [sample for sample in self.queue if sample[2].is_current(sample[1])]
        if len(current) < len(self.queue):
            self.queue.clear()
            self.queue.extend(current)

    @property
    def publisher_count(self) -> int:
        """The number of publishers that are matched with this subscription."""
        return len(self.publishers)

    def take(self) -> Sample | None:
        """Return the oldest waiting sample, or None if no sample is waiting."""
        if self.may_expire:
            self.drop_expired()
        return self.queue.popleft() if self.queue else None

    def destroy(self) -> None:
        """Remove the subscription from the topic, and drop the messages in its queue."""
        for publisher in list(self.publishers):
            disconnect(publisher, self)
        self.queue.clear()
        self.graph.remove_end(self)


def connect(publisher: Publisher, subscription: Subscription) -> None:
    """Match a publisher and a subscription of one topic, or report the policy that makes them incompatible to both."""
    policy = 'TYPE' if publisher.type_name != subscription.type_name else incompatible_policy(publisher.qos, subscription.qos)
    if policy is not None:
        publisher.graph.tracer.incompatible(publisher, subscription, policy)
        if policy != 'TYPE':
            publisher._report_incompatible(policy)
            subscription._report_incompatible(policy)
        return
    publisher.matched.append(subscription)
    subscription.publishers.append(publisher)
    subscription.may_expire |= bool(publisher.qos.lifespan_ns)
    publisher._report_matched(+1)
    subscription._report_matched(+1)
    gets_late = subscription.qos.durability == TRANSIENT_LOCAL and subscription.qos.reliability == RELIABLE
    if gets_late and publisher.history and (kept := publisher.late_samples()):
        subscription.queue.extend(kept)
        subscription.on_ready()


def disconnect(publisher: Publisher, subscription: Subscription) -> None:
    """End the match between a publisher and a subscription. Do nothing if they were not matched."""
    if subscription in publisher.matched:
        publisher.matched.remove(subscription)
        subscription.publishers.remove(publisher)
        publisher._report_matched(-1)
        subscription._report_matched(-1)


def _forget(record: Any) -> None:
    """Record nothing. This function replaces the recording function of a destroyed publisher."""

"""Callbacks for events of an endpoint: incompatible quality of service, matches, missed deadlines, liveliness and lost
messages.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.engine.graph.qos import incompatible_policy
from edulaunch.ros.passed_on import passed_on
from rclpy._rclpy_pybind11 import UnsupportedEventTypeError as UnsupportedEventTypeError
from rclpy.impl.c_enum import CEnum, Pybind11IntEnum
from rclpy.impl.qos_watch import Count, LivelinessWatch, watch_deadline, watch_lease
from rclpy.waitable import NumberOfEntities, Waitable

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.impl.protocols import ExecutorProtocol

EventCallback = Callable[[Any], object]


class rcl_publisher_event_type_t(Pybind11IntEnum):  # noqa: N801
    """The events of a publisher."""

    RCL_PUBLISHER_OFFERED_DEADLINE_MISSED = 0
    RCL_PUBLISHER_LIVELINESS_LOST = 1
    RCL_PUBLISHER_OFFERED_INCOMPATIBLE_QOS = 2
    RCL_PUBLISHER_INCOMPATIBLE_TYPE = 3
    RCL_PUBLISHER_MATCHED = 4


class rcl_subscription_event_type_t(Pybind11IntEnum):  # noqa: N801
    """The events of a subscription."""

    RCL_SUBSCRIPTION_REQUESTED_DEADLINE_MISSED = 0
    RCL_SUBSCRIPTION_LIVELINESS_CHANGED = 1
    RCL_SUBSCRIPTION_REQUESTED_INCOMPATIBLE_QOS = 2
    RCL_SUBSCRIPTION_MESSAGE_LOST = 3
    RCL_SUBSCRIPTION_INCOMPATIBLE_TYPE = 4
    RCL_SUBSCRIPTION_MATCHED = 5


QoSPublisherEventType, QoSSubscriptionEventType = rcl_publisher_event_type_t, rcl_subscription_event_type_t


class CountInfo(NamedTuple):
    """The number of occurrences of an event, in total and since the last call."""

    total_count: int
    total_count_change: int


QoSOfferedDeadlineMissedInfo = QoSRequestedDeadlineMissedInfo = QoSLivelinessLostInfo = CountInfo
QoSMessageLostInfo = IncompatibleTypeInfo = CountInfo  # for events that do not occur in the simulation


class QoSLivelinessChangedInfo(NamedTuple):
    """How many publishers of a subscription are alive and not alive, and the changes since the last call."""

    alive_count: int
    not_alive_count: int
    alive_count_change: int
    not_alive_count_change: int


class IncompatibleInfo(NamedTuple):
    """The number of endpoints with incompatible quality of service.

    For a publisher, these are the subscriptions that require more than the publisher offers. For a subscription, these are the
    publishers that offer less than the subscription requires.
    """

    total_count: int
    total_count_change: int
    last_policy_kind: CEnum


QoSOfferedIncompatibleQoSInfo = QoSRequestedIncompatibleQoSInfo = IncompatibleInfo


class MatchedInfo(NamedTuple):
    """The number of endpoints with which this endpoint is connected, and the changes of that number."""

    total_count: int
    total_count_change: int
    current_count: int
    current_count_change: int


PublisherMatchedInfo = QoSPublisherMatchedInfo = MatchedInfo
QoSSubscriptionMatchedInfo = MatchedInfo


class EventHandler(Waitable):
    """A waitable that passes an event to its callback. The executor calls the callback with the changes since the last call."""

    def __init__(self, callback_group: CallbackGroup, callback: EventCallback, take: Callable[[], Any]) -> None:
        super().__init__(callback_group)
        self.callback = callback
        self._take_info = take

    def get_num_entities(self) -> NumberOfEntities:
        """Return the number of entities of each kind that belong to this handler."""
        return NumberOfEntities(num_events=1)

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        self.queued = False
        info = self._take_info()
        if info is not None and not self.destroyed:
            self.callback(info)
        return None

    rcl_is_async = False

    def rcl_ready_changed(self) -> None:
        """Record an event and make the executor call the callback."""
        if not self.destroyed:
            self.rcl_signal()

    def destroy(self) -> None:
        """Stop calling the callback."""
        self.destroyed = True


QoSEventHandler = EventHandler


class _MatchCount:
    """Counts matches between two calls of the callback."""

    def __init__(self, current: int) -> None:
        self.total = self.total_change = self.current = self.current_change = current

    def add(self, change: int) -> None:
        self.total += max(change, 0)
        self.total_change += max(change, 0)
        self.current += change
        self.current_change += change

    def take(self) -> MatchedInfo | None:
        info = MatchedInfo(self.total, self.total_change, self.current, self.current_change)
        changed = self.total_change or self.current_change
        self.total_change = self.current_change = 0
        return info if changed else None


class _EventCallbacks:
    """The common part of the event callbacks of publishers and subscriptions. By default, `incompatible_qos` logs a warning."""

    _warning: str

    def __init__(
        self,
        *,
        deadline: EventCallback | None = None,
        liveliness: EventCallback | None = None,
        incompatible_qos: EventCallback | None = None,
        incompatible_type: EventCallback | None = None,
        matched: EventCallback | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        self.deadline = deadline
        self.liveliness = liveliness
        self.incompatible_qos = incompatible_qos
        self.incompatible_type = incompatible_type
        self.matched = matched
        self.use_default_callbacks = use_default_callbacks

    def rcl_attach(self, node: Any, entity: Any, impl: Any, group: CallbackGroup) -> None:
        """Watch a new endpoint. The endpoints with which it was connected at its creation also count."""
        incompatible_qos = self.incompatible_qos or (self._warn_of(node, entity) if self.use_default_callbacks else None)
        if incompatible_qos is not None:
            self._watch_incompatible(node, entity, impl, group, incompatible_qos)
        incompatible_type = self.incompatible_type or (_never_called if self.use_default_callbacks else None)
        for callback in (getattr(self, 'message_lost', None), incompatible_type):
            if callback is not None:
                _added(node, entity, EventHandler(group, callback, lambda: None))
        if self.matched is not None:
            self._watch_matched(node, entity, impl, group, self.matched)
        if self.deadline is not None:
            watch_deadline(impl, _counted(node, entity, group, self.deadline, CountInfo).add)
        if self.liveliness is not None:
            self._watch_liveliness(node, entity, impl, group, self.liveliness)

    def _warn_of(self, node: Any, entity: Any) -> EventCallback:
        """Return the default callback for incompatible quality of service, which writes a warning to the node's log."""

        def warn_of(info: Any) -> None:
            from rclpy.qos_compatibility import qos_policy_name_from_kind

            policy = qos_policy_name_from_kind(info.last_policy_kind)
            node.get_logger().warning(self._warning.format(entity.topic, policy))

        return warn_of

    def _watch_liveliness(self, node: Any, entity: Any, impl: Any, group: CallbackGroup, callback: EventCallback) -> None:
        """Watch the liveliness of the publisher, or of the publishers of the subscription."""
        raise TypeError(f'{type(self).__name__} is neither of a publisher nor of a subscription')

    def _watch_incompatible(self, node: Any, entity: Any, impl: Any, group: CallbackGroup, callback: EventCallback) -> None:
        on_incompatible = impl.on_incompatible = _counted(node, entity, group, callback, _incompatible_info).add
        for policy in _incompatible_partners(impl):
            on_incompatible(policy)

    def _watch_matched(self, node: Any, entity: Any, impl: Any, group: CallbackGroup, callback: EventCallback) -> None:
        count = _MatchCount(impl.subscription_count if impl.kind == 'publisher' else impl.publisher_count)
        handler = _added(node, entity, EventHandler(group, callback, count.take))

        def on_matched(change: int) -> None:
            count.add(change)
            handler.rcl_ready_changed()

        impl.on_matched = on_matched
        if count.current:
            handler.rcl_ready_changed()


def _never_called(info: Any) -> None:
    """Do nothing. This is the default callback for a different type on the topic, which Fast DDS does not report."""


def _counted(node: Any, entity: Any, group: CallbackGroup, callback: EventCallback, make_info: Callable[..., Any]) -> Count:
    """Return a counter. After a change, the executor passes the counted events to the callback."""
    count = Count(make_info, lambda: handler.rcl_ready_changed())
    handler = _added(node, entity, EventHandler(group, callback, count.take))
    return count


def _incompatible_info(total: int, change: int, policy: str) -> IncompatibleInfo:
    from rclpy.qos_compatibility import PolicyKindOfEvent

    return IncompatibleInfo(total, change, PolicyKindOfEvent[f'RMW_QOS_POLICY_{policy}'])


def _added(node: Any, entity: Any, handler: EventHandler) -> EventHandler:
    entity.event_handlers.append(handler)
    node.add_waitable(handler)
    return handler


def _incompatible_partners(impl: Any) -> list[str]:
    """Return the incompatible policies of the endpoints on this topic that existed before this endpoint."""
    if impl.kind == 'publisher':
        pairs = [(impl, other) for other in impl.graph.subscriptions.get(impl.topic_name, ())]
    else:
        pairs = [(other, impl) for other in impl.graph.publishers.get(impl.topic_name, ())]
    policies = [
        incompatible_policy(publisher.qos, subscription.qos)
        for publisher, subscription in pairs
        if publisher.type_name == subscription.type_name
    ]
    return [policy for policy in policies if policy is not None]


class PublisherEventCallbacks(_EventCallbacks):
    """The event callbacks of a publisher. Each callback receives one of the info classes of this module.

    :param deadline: called when the publisher has published nothing for the time of its deadline.
    :param liveliness: called when a publisher with MANUAL_BY_TOPIC has not asserted its liveliness during its lease.
    :param incompatible_qos: called when a subscription requires more than the publisher offers; by default, a warning is logged.
    :param matched: called when a matching subscription was created or destroyed.
    """

    _warning = (
        "New subscription discovered on topic '{}', requesting incompatible QoS. No messages will be sent to it. "
        'Last incompatible policy: {}'
    )

    def _watch_liveliness(self, node: Any, entity: Any, impl: Any, group: CallbackGroup, callback: EventCallback) -> None:
        watch_lease(impl, _counted(node, entity, group, callback, CountInfo).add)


class SubscriptionEventCallbacks(_EventCallbacks):
    """The event callbacks of a subscription. Each callback receives one of the info classes of this module.

    :param deadline: called when no message has arrived for the time of the deadline, counted from the first message.
    :param liveliness: called when a publisher became alive, ended, or did not assert its liveliness during its lease. Without a
        lease, it is never called.
    :param incompatible_qos: called when a publisher offers less than the subscription requires; by default, a warning is logged.
    :param message_lost: never called, because the simulation loses no messages.
    :param matched: called when a matching publisher was created or destroyed.
    """

    _warning = (
        "New publisher discovered on topic '{}', offering incompatible QoS. No messages will be received from it. "
        'Last incompatible policy: {}'
    )

    def __init__(
        self,
        *,
        deadline: EventCallback | None = None,
        incompatible_qos: EventCallback | None = None,
        liveliness: EventCallback | None = None,
        message_lost: EventCallback | None = None,
        incompatible_type: EventCallback | None = None,
        matched: EventCallback | None = None,
        use_default_callbacks: bool = True,
    ) -> None:
        super().__init__(
            deadline=deadline,
            liveliness=liveliness,
            incompatible_qos=incompatible_qos,
            incompatible_type=incompatible_type,
            matched=matched,
            use_default_callbacks=use_default_callbacks,
        )
        self.message_lost = message_lost

    def _watch_liveliness(self, node: Any, entity: Any, impl: Any, group: CallbackGroup, callback: EventCallback) -> None:
        watch = LivelinessWatch(impl, QoSLivelinessChangedInfo, lambda: handler.rcl_ready_changed())
        handler = _added(node, entity, EventHandler(group, callback, watch.take))
        if not impl.qos.lease_ns:
            return  # Fast DDS ignores the liveliness of publishers that need not assert it
        counted = impl.on_matched

        def on_matched(change: int) -> None:
            if counted is not None:
                counted(change)
            watch.look()

        impl.on_matched = on_matched
        watch.look()


__getattr__ = passed_on(__name__)

"""The methods of a node that create and destroy its entities."""

from __future__ import annotations

from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.engine.graph.names import expand_name, full_topic_name_problem, fully_qualified_name, topic_name_problem
from edulaunch.engine.processes.frame_owner import student_line
from rclpy._rclpy_pybind11 import InvalidHandle, RCLError
from rclpy.client import Client
from rclpy.constants import S_TO_NS
from rclpy.guard_condition import GuardCondition
from rclpy.impl.new_end_checks import check_new_service_end, check_new_topic_end
from rclpy.impl.own_names import FOR_TIMERS, check_own_names
from rclpy.node_parts.core import NodeCore, core_of
from rclpy.publisher import Publisher
from rclpy.qos import QoSProfile, engine_qos, qos_profile_services_default, validate_qos
from rclpy.service import Service
from rclpy.subscription import Subscription
from rclpy.timer import Rate, Timer
from rclpy.type_support import check_is_valid_msg_type, check_is_valid_srv_type
from rclpy.waitable import Waitable

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.clock import Clock
    from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks
    from rclpy.qos_overriding_options import QoSOverridingOptions

SHORT_NS, LONG_NS = 100_000, 45_000_000_000
"""The limits of plausible periods of timers."""


class NodeEntities:
    """The part of `Node` that creates and destroys publishers, subscriptions, clients, services, timers and similar entities."""

    _rclpy: NodeCore

    @property
    def publishers(self) -> Iterator[Publisher]:
        """All publishers of the node."""
        yield from self._rclpy.publishers

    @property
    def subscriptions(self) -> Iterator[Subscription]:
        """All subscriptions of the node."""
        yield from self._rclpy.subscriptions

    @property
    def clients(self) -> Iterator[Client]:
        """All clients of the node."""
        yield from self._rclpy.clients

    @property
    def services(self) -> Iterator[Service]:
        """All services of the node."""
        yield from self._rclpy.services

    @property
    def timers(self) -> Iterator[Timer]:
        """All timers of the node."""
        yield from self._rclpy.timers

    @property
    def guards(self) -> Iterator[GuardCondition]:
        """All guard conditions of the node."""
        yield from self._rclpy.guards

    @property
    def waitables(self) -> Iterator[Waitable]:
        """All waitables of the node."""
        yield from self._rclpy.waitables

    def add_waitable(self, waitable: Waitable) -> None:
        """Add a waitable. The node's executor then waits for it."""
        core = self._rclpy
        waitable.ready_list = core.ready_list
        waitable.order = core.next_number()
        core.waitables.append(waitable)
        if type(waitable).is_ready is not Waitable.is_ready:
            core.ready_list.asked.append(waitable)
            core.ready_list.notify()
        elif waitable.queued:
            waitable.queued = False
            waitable.rcl_signal()

    def remove_waitable(self, waitable: Waitable) -> None:
        """Remove a waitable, so that the executor no longer waits for it."""
        waitable.destroyed = True
        for waitables in (self._rclpy.waitables, self._rclpy.ready_list.asked):
            if waitable in waitables:
                waitables.remove(waitable)

    def create_publisher(
        self,
        msg_type: Any,
        topic: str,
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: PublisherEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        publisher_class: type[Publisher] = Publisher,
    ) -> Publisher:
        """Create a publisher.

        :param msg_type: the message class.
        :param topic: the topic name: absolute, relative to the namespace, or private (`~/x`).
        :param qos_profile: a QoSProfile, or the depth as an int.
        :raises InvalidTopicNameException: for a name that breaks the rules.
        :raises RCLError: after shutdown, or when this program uses the topic with another type.
        """
        core = self._rclpy
        profile = validate_qos(qos_profile)
        check_is_valid_msg_type(msg_type)
        name = core.resolve(topic, 'topic')
        profile = _overridden(self, qos_overriding_options, profile, name, 'publisher')
        check_new_topic_end(core, name, msg_type, 'publisher')
        impl = core.graph.create_publisher(core.entry, name, msg_type, engine_qos(profile))
        publisher = publisher_class(impl, msg_type, topic, profile, core.context)
        core.publishers.append(publisher)
        _watch_events(self, publisher, impl, event_callbacks, callback_group, 'publisher')
        return publisher

    def create_subscription(
        self,
        msg_type: Any,
        topic: str,
        callback: Callable[..., Any],
        qos_profile: QoSProfile | int,
        *,
        callback_group: CallbackGroup | None = None,
        event_callbacks: SubscriptionEventCallbacks | None = None,
        qos_overriding_options: QoSOverridingOptions | None = None,
        raw: bool = False,
    ) -> Subscription:
        """Create a subscription.

        :param callback: called with each message, or with (message, info).
        :param raw: whether the callback receives serialized bytes in place of a message.
        :raises InvalidTopicNameException: for a name that breaks the rules.
        :raises RCLError: after shutdown, or when this program uses the topic with another type.
        :raises RuntimeError: when the callback takes neither one nor two arguments.
        """
        core = self._rclpy
        profile = validate_qos(qos_profile)
        check_is_valid_msg_type(msg_type)
        name = core.resolve(topic, 'topic')
        profile = _overridden(self, qos_overriding_options, profile, name, 'subscription')
        group = callback_group or core.default_callback_group
        check_new_topic_end(core, name, msg_type, 'subscription')
        subscription = Subscription(core.ready_list, msg_type, topic, callback, group, profile, raw, core.next_number())
        group.add_entity(subscription)
        qos = engine_qos(profile, 'subscription')
        impl = core.graph.create_subscription(core.entry, name, msg_type, qos, subscription.rcl_signal)
        subscription.rcl_connect(impl)
        core.subscriptions.append(subscription)
        _watch_events(self, subscription, impl, event_callbacks, callback_group, 'subscription')
        return subscription

    def create_client(
        self,
        srv_type: Any,
        srv_name: str,
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Client:
        """Create a client of a service.

        :raises InvalidServiceNameException: for a name that breaks the rules.
        :raises RCLError: after shutdown, or when this program uses the service with another type.
        """
        core = self._rclpy
        check_is_valid_srv_type(srv_type)
        name = core.resolve(srv_name, 'service')
        group = callback_group or core.default_callback_group
        check_new_service_end(core, name, srv_type, 'client')
        client = Client(core.context, core.ready_list, srv_type, srv_name, qos_profile, group, core.next_number())
        client.rcl_connect(core.graph.create_client(core.entry, name, srv_type, engine_qos(qos_profile), client.rcl_signal))
        group.add_entity(client)
        core.clients.append(client)
        return client

    def create_service(
        self,
        srv_type: Any,
        srv_name: str,
        callback: Callable[[Any, Any], Any],
        *,
        qos_profile: QoSProfile = qos_profile_services_default,
        callback_group: CallbackGroup | None = None,
    ) -> Service:
        """Create a service. `callback(request, response)` returns the response.

        :raises InvalidServiceNameException: for a name that breaks the rules.
        :raises RCLError: after shutdown, or when this program uses the service with another type.
        """
        core = self._rclpy
        check_is_valid_srv_type(srv_type)
        _check_callback(core, callback, 'create_service')
        name = core.resolve(srv_name, 'service')
        group = callback_group or core.default_callback_group
        check_new_service_end(core, name, srv_type, 'service')
        service = Service(core.ready_list, srv_type, srv_name, callback, group, qos_profile, core.next_number())
        service.rcl_connect(core.graph.create_service(core.entry, name, srv_type, engine_qos(qos_profile), service.rcl_signal))
        group.add_entity(service)
        core.services.append(service)
        return service

    def create_timer(
        self,
        timer_period_sec: float,
        callback: Callable[[], Any] | None,
        callback_group: CallbackGroup | None = None,
        clock: Clock | None = None,
        autostart: bool = True,
    ) -> Timer:
        """Create a timer. Its callback is first called one period from now.

        :param clock: the clock of the timer; None means the node's clock.
        :param autostart: if False, the timer is cancelled until `reset()` is called.
        """
        _check_callback(self._rclpy, callback, 'create_timer')
        check_own_names(self, FOR_TIMERS)  # type: ignore[arg-type]  # a Node inherits this class
        return _new_timer(self._rclpy, timer_period_sec, callback, callback_group, clock, autostart)

    def create_rate(self, frequency: float, clock: Clock | None = None) -> Rate:
        """Create a rate of `frequency` hertz. Raise ValueError unless `frequency` is positive."""
        if frequency <= 0:
            raise ValueError('frequency must be > 0')
        from rclpy.callback_groups import MutuallyExclusiveCallbackGroup

        timer = _new_timer(self._rclpy, 1.0 / frequency, None, MutuallyExclusiveCallbackGroup(), clock, True)
        rate = Rate(timer, context=self._rclpy.context)
        self._rclpy.rates.append(rate)
        return rate

    def create_guard_condition(self, callback: Callable[[], Any], callback_group: CallbackGroup | None = None) -> GuardCondition:
        """Create a guard condition."""
        core = self._rclpy
        core.check_context('failed to create guard_condition')
        group = callback_group or core.default_callback_group
        guard = GuardCondition(callback, group, core.context, ready_list=core.ready_list, number=core.next_number())
        group.add_entity(guard)
        core.guards.append(guard)
        return guard

    def destroy_publisher(self, publisher: Publisher) -> bool:
        """Destroy a publisher. Return whether it belonged to this node."""
        return _destroy(self._rclpy.publishers, publisher)

    def destroy_subscription(self, subscription: Subscription) -> bool:
        """Destroy a subscription. Return whether it belonged to this node."""
        return _destroy(self._rclpy.subscriptions, subscription)

    def destroy_client(self, client: Client) -> bool:
        """Destroy a client. Return whether it belonged to this node."""
        return _destroy(self._rclpy.clients, client)

    def destroy_service(self, service: Service) -> bool:
        """Destroy a service. Return whether it belonged to this node."""
        return _destroy(self._rclpy.services, service)

    def destroy_timer(self, timer: Timer) -> bool:
        """Destroy a timer. Return whether it belonged to this node."""
        return _destroy(self._rclpy.timers, timer)

    def destroy_guard_condition(self, guard: GuardCondition) -> bool:
        """Destroy a guard condition. Return whether it belonged to this node."""
        return _destroy(self._rclpy.guards, guard)

    def destroy_rate(self, rate: Rate) -> bool:
        """Destroy a rate. Return True."""
        if rate in self._rclpy.rates:
            self._rclpy.rates.remove(rate)
        if rate.timer in self._rclpy.timers:
            self._rclpy.timers.remove(rate.timer)
        rate.destroy()
        return True

    def resolve_topic_name(self, topic: str, *, only_expand: bool = False) -> str:
        """Return the absolute, remapped form of a topic name. Raise RCLError if the name breaks the rules."""
        return _resolved(self._rclpy, topic, 'topic', only_expand)

    def resolve_service_name(self, service: str, *, only_expand: bool = False) -> str:
        """Return the absolute, remapped form of a service name. Raise RCLError if the name breaks the rules."""
        return _resolved(self._rclpy, service, 'service', only_expand)

    def get_name(self) -> str:
        """Return the node's own name. Raise InvalidHandle if the node was destroyed."""
        self._rclpy.check_alive()
        return self._rclpy.name

    def get_namespace(self) -> str:
        """Return the namespace, which is '/' for the root. Raise InvalidHandle if the node was destroyed."""
        self._rclpy.check_alive()
        return self._rclpy.namespace

    def get_fully_qualified_name(self) -> str:
        """Return the node's namespace and name as one string. Raise InvalidHandle if the node was destroyed."""
        return fully_qualified_name(self.get_namespace(), self.get_name())


def _resolved(core: NodeCore, name: str, kind: str, only_expand: bool) -> str:
    """Return the name that `core.resolve` returns. Raise RCLError for an invalid name, as rclpy's methods do that only resolve
    names.
    """
    try:
        problem = topic_name_problem(name)
        if problem is None:
            problem = full_topic_name_problem(expand_name(name, core.name, core.namespace))
        reason = None if problem is None else problem[0]
    except ValueError as unknown_substitution:
        reason = str(unknown_substitution).rpartition(' is invalid: ')[2]
    if reason is not None:
        raise RCLError(f'failed to resolve name: {reason}')
    return core.resolve(name, kind, only_expand)


def _destroy(entities: list[Any], entity: Any) -> bool:
    if entity not in entities:
        return False
    entities.remove(entity)
    try:
        entity.destroy()
    except InvalidHandle:
        return False
    return True


def _new_timer(
    core: NodeCore,
    period_s: float,
    callback: Callable[[], Any] | None,
    group: CallbackGroup | None,
    clock: Clock | None,
    autostart: bool,
) -> Timer:
    period_ns = int(float(period_s) * S_TO_NS)
    if period_ns >= 2**63:
        raise TypeError(f'__init__(): incompatible constructor arguments: a period must fit into 64 bits, not {period_ns} ns')
    if period_ns < 0:
        raise RCLError('failed to create timer: timer period must be non-negative')
    core.check_context('failed to create timer')
    group = group or core.default_callback_group
    timer = Timer(
        callback,
        group,
        period_ns,
        clock or core.clock,
        context=core.context,
        autostart=autostart,
        ready_list=core.ready_list,
        number=core.next_number(),
    )
    group.add_entity(timer)
    core.timers.append(timer)
    if not SHORT_NS <= period_ns <= LONG_NS:
        _note_period(core, timer)
    if len(core.timers) % MANY_TIMERS == 0:
        _note_many(core, timer)
    return timer


MANY_TIMERS = 12
"""The number of timers at which a node checks whether one line creates them again and again."""


def _note_many(core: NodeCore, timer: Timer) -> None:
    """Record that many running timers of a node call the function of the newest timer."""
    from rclpy.impl.facts import callback_name

    name = callback_name(timer)
    same = sum(callback_name(one) == name and not one.is_canceled() for one in core.timers)
    if same > MANY_TIMERS // 2:
        data = {'node': core.full_name, 'callback': name, 'count': same}
        core.process.fact('timers pile up', (core.entry.index, name), {**data, **student_line()})


def _note_period(core: NodeCore, timer: Timer) -> None:
    """Record an improbable period: 0, or minutes where the program probably means milliseconds."""
    from rclpy.impl.facts import callback_name

    data = {'node': core.full_name, 'callback': callback_name(timer), 'period_s': timer.timer_period_ns / 1e9}
    core.process.fact('timer period', (core.entry.index, timer.order), {**data, **student_line()})


def _check_callback(core: NodeCore, callback: Any, function: str) -> None:
    """Record that a program passed the result of `self.tick()` in place of `self.tick`. ROS 2 does not report this mistake."""
    if callback is not None:
        return
    line = student_line()
    data = {'node': core.full_name, 'function': function, 'file': line.get('file'), 'line': line.get('line')}
    core.process.fact('callback missing', (core.entry.index, core.next_number()), data)


def _watch_events(node: Any, entity: Any, impl: Any, callbacks: Any, group: CallbackGroup | None, side: str) -> None:
    from rclpy.event_handler import PublisherEventCallbacks, SubscriptionEventCallbacks

    if callbacks is None:
        callbacks = PublisherEventCallbacks() if side == 'publisher' else SubscriptionEventCallbacks()
    callbacks.rcl_attach(node, entity, impl, group or core_of(node).default_callback_group)


def _overridden(node: Any, options: QoSOverridingOptions | None, profile: QoSProfile, topic: str, side: str) -> QoSProfile:
    if options is None or not options.policy_kinds:
        return profile
    from rclpy.qos_overriding_options import declare_qos_parameters

    return declare_qos_parameters(node, side, topic, profile, options)

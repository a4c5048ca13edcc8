"""The common part of publishers, subscriptions, timers, clients and services.

Each entity has a handle and an endpoint in the graph, and notifies the executor. When an entity becomes ready, it adds itself
to its node's ready list, once.
"""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, Any

from rclpy.impl.refusals import after_shutdown, invalid_handle

if TYPE_CHECKING:
    from edulaunch.engine.sim.task import Task as SimTask
    from rclpy.callback_groups import CallbackGroup
    from rclpy.impl.protocols import ClockProtocol, ContextProtocol, ExecutorProtocol
    from rclpy.qos import QoSProfile
    from rclpy.service_introspection import ServiceIntrospectionState


class Handle:
    """The `handle` of an entity. Entering `with entity.handle:` checks that the entity exists. As in ROS 2, `as` gives None.

    All other attributes are those of the object that owns the handle.
    """

    def __init__(self, held: Any, is_destroyed: Callable[[], bool] = lambda: False) -> None:
        self._held = held
        self._is_destroyed = is_destroyed

    def __enter__(self) -> None:
        if self._is_destroyed():
            raise invalid_handle()

    def __exit__(self, *_: object) -> None:
        """Do nothing, because entering the handle acquires nothing."""

    def __getattr__(self, name: str) -> Any:
        return getattr(self._held, name)


def check_alive(endpoint: Any) -> None:
    """Raise InvalidHandle if an endpoint was destroyed."""
    if endpoint.destroyed:
        raise invalid_handle()


def check_endpoint(endpoint: Any, context: ContextProtocol, what: str) -> None:
    """Raise the error of ROS 2 if the endpoint is destroyed, or if ROS 2 is shut down.

    :param what: the beginning of the error message up to the colon, followed by the kind of endpoint, such as
        'failed to ...: publisher'.
    :raises InvalidHandle: when the endpoint was destroyed.
    :raises RCLError: when ROS 2 was shut down.
    """
    check_alive(endpoint)
    if not context.alive:
        raise after_shutdown(what)


WAITABLE, TIMER, SUBSCRIPTION, GUARD, CLIENT, SERVICE = range(6)
"""The order in which the ready entities of one wait are executed. Waitables of all nodes come before all other entities."""

NEVER_NS = 1 << 63


class ReadyList:
    """The data of one node that an executor checks: the ready entities, the timers, and `due_ns`, the time at which the first
    timer is due.

    :ivar asked: the program's own waitables. The executor checks them in each wait.
    :ivar waiting: the simulated threads that are parked in the executor.
    """

    __slots__ = ('entities', 'timers', 'asked', 'executor', 'waiting', 'due_ns')

    def __init__(self) -> None:
        self.entities: list[Entity] = []
        self.timers: list[TimedEntity] = []
        self.asked: list[Any] = []
        self.executor: ExecutorProtocol | None = None
        self.waiting: list[SimTask] = []
        self.due_ns = NEVER_NS

    def plan(self) -> None:
        """Compute the time at which the first timer is due, and store it in `due_ns`."""
        timers = self.timers
        if len(timers) == 1:
            self.due_ns = timers[0].rcl_due_ns
        else:
            self.due_ns = min([timer.rcl_due_ns for timer in timers], default=NEVER_NS)

    def notify(self) -> None:
        """Wake the waiting executor, because an entity is ready or a due time has changed."""
        for task in self.waiting:
            task.wake()


class Entity:
    """The base class of the entities that executors run. An entity has a callback, a group, and a flag for a pending event.

    `_order` sorts the entities of one wait by category, then by creation. `rcl_is_async` is True if a run returns a coroutine.
    """

    rcl_category = WAITABLE
    rcl_is_async = False

    def __init__(self, ready_list: ReadyList, callback_group: CallbackGroup, number: int) -> None:
        self.callback_group = callback_group
        self.ready_list = ready_list
        self.order = self.rcl_category << 32 | number
        self.queued = False
        self.destroyed = False

    def rcl_signal(self) -> None:
        """Record an event: add this entity to the ready list and wake the executor."""
        if not self.queued:
            self.queued = True
            ready_list = self.ready_list
            ready_list.entities.append(self)
            for task in ready_list.waiting:
                task.wake()

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        """Call the callback with the pending data. The executor has already removed the entity from the ready list. If this
        method returns a coroutine, the executor runs it.
        """
        raise TypeError(f'{type(self).__name__} cannot be executed')


class TimedEntity(Entity):
    """An entity that becomes ready at a certain time.

    :ivar rcl_due_ns: the time at which the entity becomes ready, in simulated nanoseconds; `NEVER_NS` while it is unknown.
    """

    rcl_due_ns: int = NEVER_NS


class GraphEnd:
    """An entity with an endpoint in the graph. :meth:`rcl_connect` sets the endpoint."""

    endpoint: Any

    def rcl_connect(self, impl: Any) -> None:
        """Set this entity's endpoint in the graph."""
        self.endpoint = impl

    @property
    def logger_name(self) -> str:
        """The name of the logger of the entity's node. Raise InvalidHandle after destroy."""
        check_alive(self.endpoint)
        name: str = self.endpoint.node.logger_name
        return name

    @property
    def handle(self) -> Handle:
        """The object that owns the endpoint in the graph."""
        impl = self.endpoint
        return Handle(impl, lambda: impl.destroyed)


class TopicEnd(GraphEnd):
    """A publisher or a subscription."""

    @property
    def topic_name(self) -> str:
        """The absolute name of the topic, after remapping. Raise InvalidHandle after destroy."""
        check_alive(self.endpoint)
        name: str = self.endpoint.topic_name
        return name


class ServiceEnd(GraphEnd):
    """A client or a service."""

    srv_type: Any
    _introspection: Any = None

    @property
    def service_name(self) -> str:
        """The absolute name of the service, after remapping. Raise InvalidHandle after destroy."""
        check_alive(self.endpoint)
        name: str = self.endpoint.service_name
        return name

    def configure_introspection(
        self, clock: ClockProtocol, service_event_qos_profile: QoSProfile, introspection_state: ServiceIntrospectionState
    ) -> None:
        """Publish the requests and replies of this client or service on `<service>/_service_event`."""
        from rclpy.service_introspection import Introspection, ServiceIntrospectionState

        kind = type(introspection_state).__name__
        if kind != ServiceIntrospectionState.__name__:
            needed = 'introspection_state must be a ServiceIntrospectionState'
            raise TypeError(f'configure_introspection(): incompatible function arguments: {needed}, not {kind}')
        if self._introspection is not None:
            self._introspection.stop()
        self._introspection = None
        if introspection_state is not ServiceIntrospectionState.OFF:
            self._introspection = Introspection(
                self.endpoint, self.srv_type.Event, clock, service_event_qos_profile, introspection_state
            )

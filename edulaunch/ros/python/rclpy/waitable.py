"""Custom objects for which an executor can wait."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from rclpy.impl.entity import WAITABLE, Entity, ReadyList

if TYPE_CHECKING:
    from rclpy.callback_groups import CallbackGroup
    from rclpy.impl.protocols import ExecutorProtocol
    from rclpy.task import Future


class NumberOfEntities:
    """How many entities of each kind belong to a waitable."""

    __slots__ = ('num_subscriptions', 'num_guard_conditions', 'num_timers', 'num_clients', 'num_services', 'num_events')

    def __init__(
        self,
        num_subs: int = 0,
        num_gcs: int = 0,
        num_timers: int = 0,
        num_clients: int = 0,
        num_services: int = 0,
        num_events: int = 0,
    ) -> None:
        self.num_subscriptions = num_subs
        self.num_guard_conditions = num_gcs
        self.num_timers = num_timers
        self.num_clients = num_clients
        self.num_services = num_services
        self.num_events = num_events

    def __add__(self, other: NumberOfEntities) -> NumberOfEntities:
        return NumberOfEntities(*(getattr(self, slot) + getattr(other, slot) for slot in self.__slots__))

    def __repr__(self) -> str:
        return '<NumberOfEntities({})>'.format(', '.join(str(getattr(self, slot)) for slot in self.__slots__))


class WaitSet:
    """The argument of `add_to_wait_set` and `is_ready`. It has no C handles."""

    def __getattr__(self, name: str) -> Any:
        raise with_facts(AttributeError(f'{type(self).__name__!r} object has no attribute {name!r}'), 'programs.wait-set')


class Waitable(Entity):
    """The base class of waitables. A subclass overrides `is_ready`, `take_data`, `execute`, `get_num_entities` and
    `add_to_wait_set`.

    An executor checks waitables only when a wait begins or ends, so another event (a timer, a message) must end a wait.
    """

    rcl_category = WAITABLE
    rcl_is_async = True

    def __init__(self, callback_group: CallbackGroup) -> None:
        super().__init__(ReadyList(), callback_group, 0)
        callback_group.add_entity(self)
        self._futures: list[Future] = []

    def __enter__(self) -> Waitable:
        return self

    def __exit__(self, *_: Any) -> None:
        """Do nothing, because entering the waitable acquires nothing."""

    def is_ready(self, wait_set: Any) -> bool:
        """Return whether there is work to do."""
        raise NotImplementedError('Must be implemented by subclass')

    def take_data(self) -> Any:
        """Return the data for `execute`."""
        raise NotImplementedError('Must be implemented by subclass')

    async def execute(self, taken_data: Any) -> None:
        """Process the data from `take_data`. Subclasses implement it."""
        raise NotImplementedError('Must be implemented by subclass')

    def get_num_entities(self) -> NumberOfEntities:
        """Return the number of entities of each kind that belong to this waitable."""
        raise NotImplementedError('Must be implemented by subclass')

    def add_to_wait_set(self, wait_set: Any) -> None:
        """Prepare a wait. The executor calls this method before each wait. Subclasses implement it."""
        raise NotImplementedError('Must be implemented by subclass')

    def add_future(self, future: Future) -> None:
        """Store a future."""
        self._futures.append(future)

    def remove_future(self, future: Future) -> None:
        """Remove a future."""
        self._futures.remove(future)

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        self.queued = False
        return self.execute(self.take_data())

    def rcl_ask(self) -> bool:
        """Return the result of `is_ready` for a wait. Do not call `is_ready` again while the callback waits for its turn."""
        if not self.queued:
            self.get_num_entities()
            self.add_to_wait_set(WAIT_SET)
            self.queued = bool(self.is_ready(WAIT_SET))
        return self.queued


WAIT_SET = WaitSet()

"""Subscriptions to topics."""

from __future__ import annotations

from collections.abc import Callable
from enum import Enum
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.ros.passed_on import passed_on
from rclpy.impl.entity import SUBSCRIPTION, Entity, ReadyList, TopicEnd, check_alive
from rclpy.task import is_coroutine_function

if TYPE_CHECKING:
    from edulaunch.engine.graph.topics import Sample
    from edulaunch.engine.graph.topics import Subscription as GraphSubscription
    from rclpy.callback_groups import CallbackGroup
    from rclpy.impl.protocols import ExecutorProtocol
    from rclpy.qos import QoSProfile


class Subscription(TopicEnd, Entity):
    """A subscription to a topic, created by `Node.create_subscription`. Each message is a new object."""

    rcl_category = SUBSCRIPTION
    endpoint: GraphSubscription

    class CallbackType(Enum):
        """The arguments that the callback accepts."""

        MessageOnly = 0
        WithMessageInfo = 1

    def __init__(
        self,
        ready_list: ReadyList,
        msg_type: Any,
        topic: str,
        callback: Callable[..., Any],
        callback_group: CallbackGroup,
        qos_profile: QoSProfile,
        raw: bool,
        number: int,
    ) -> None:
        super().__init__(ready_list, callback_group, number)
        self.msg_type = msg_type
        self.topic = topic
        self.qos_profile = qos_profile
        self.raw = raw
        self.event_handlers: list[Any] = []
        self.callback = callback
        self._from_wire = self._to_bytes if raw else msg_type.from_wire

    def rcl_connect(self, impl: GraphSubscription) -> None:
        """Set this subscription's endpoint in the graph."""
        self.endpoint = impl
        self._queue = impl.queue

    @property
    def callback(self) -> Callable[..., Any]:
        """The function that is called with each message."""
        return self._callback

    @callback.setter
    def callback(self, value: Callable[..., Any]) -> None:
        self._callback = value
        self._callback_type = callback_type(value)
        self._simple = self._callback_type is Subscription.CallbackType.MessageOnly
        self._wire_callback: Callable[[Any], object] | None = None
        self.rcl_is_async = is_coroutine_function(value)

    def rcl_run_callback(self, executor: ExecutorProtocol) -> Any:
        self.queued = False
        queue = self._queue
        if self.endpoint.may_expire:
            self.endpoint.drop_expired()
        if not queue:
            return None
        taken = queue.popleft()
        if queue:
            self.rcl_signal()
        if self._simple:
            return self._callback(self._from_wire(taken[0]))
        if self._wire_callback is not None:
            return self._wire_callback(taken[0])
        return self._callback(self._from_wire(taken[0]), self._info(taken))

    def rcl_take_wires(self, callback: Callable[[Any], object]) -> None:
        """Call `callback` with the wire tuple of each message, in place of the current callback.

        Both callbacks must have the same effect. Built-in programs that only copy values use this method, because it creates
        no message object. Assigning another callback switches back to message objects.
        """
        self._wire_callback = callback
        self._simple = False

    def _info(self, taken: Sample) -> dict[str, Any]:
        return {
            'source_timestamp': taken[1],
            'received_timestamp': taken[1],
            'publication_sequence_number': taken[3],
            'reception_sequence_number': None,
        }

    def _to_bytes(self, wire: Any) -> bytes:
        from edulaunch.ros.serialization.cdr import encode

        return encode(self.msg_type, wire)

    def get_publisher_count(self) -> int:
        """Return the number of publishers of the topic. Raise InvalidHandle after destroy."""
        check_alive(self.endpoint)
        return self.endpoint.publisher_count

    def destroy(self) -> None:
        """Destroy the subscription. Prefer `Node.destroy_subscription`."""
        self.destroyed = True
        for handler in self.event_handlers:
            handler.destroy()
        self.endpoint.destroy()


def callback_type(callback: Any) -> Subscription.CallbackType:
    """Return whether a callback accepts only the message, or the message and its info.

    :raises RuntimeError: when the callback accepts neither one nor two arguments.
    """
    if _accepts(callback, 1):
        return Subscription.CallbackType.MessageOnly
    if _accepts(callback, 2):
        return Subscription.CallbackType.WithMessageInfo
    raise with_facts(
        RuntimeError(
            'Subscription.__init__(): callback should be either be callable with one argument'
            '(to get only the message) or two (to get message and message info)'
        ),
        'programs.callback-none' if callback is None else 'programs.callback-arguments',
        text=callback if isinstance(callback, str) else None,
    )


_VARIADIC = 0x04


def _accepts(callback: Any, count: int) -> bool:
    """Return whether `callback` can be called with `count` positional arguments."""
    function = getattr(callback, '__func__', callback)
    code = getattr(function, '__code__', None)
    if code is not None and not hasattr(function, '__wrapped__') and not code.co_kwonlyargcount:
        count += function is not callback
        least = code.co_argcount - len(function.__defaults__ or ())
        return least <= count and (count <= code.co_argcount or bool(code.co_flags & _VARIADIC))
    from inspect import signature

    try:
        signature(callback).bind(*[None] * count)
    except TypeError:
        return False
    except ValueError:  # a built-in function without a signature
        return count == 1
    return True


__getattr__ = passed_on(__name__)

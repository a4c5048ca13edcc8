"""Filters for messages: a subscription as a source, a cache of recent messages, and synchronizers.

A synchronizer matches the messages of several topics by their stamps.
"""

from __future__ import annotations

from collections.abc import Callable, Sequence
from itertools import product
from typing import Any

from rclpy.clock import ROSClock
from rclpy.logging import get_logger
from rclpy.time import Time

from edulaunch.engine.sim.sync import Lock


class SimpleFilter:
    """Stores callbacks. `signalMessage` calls them in the order of their registration."""

    def __init__(self) -> None:
        self.callbacks: dict[int, tuple[Callable[..., Any], tuple[Any, ...]]] = {}

    def registerCallback(self, cb: Callable[..., Any], *args: Any) -> int:
        """Register `cb(message ..., *args)` for messages that pass the filter. Return the number of the registration."""
        number = len(self.callbacks)
        self.callbacks[number] = (cb, args)
        return number

    def signalMessage(self, *msg: Any) -> None:
        """Call all callbacks. A filter of one topic passes one message; a synchronizer passes one message of each topic."""
        for callback, args in list(self.callbacks.values()):
            callback(*msg, *args)


NO_STAMP = (
    'can not use message filters for messages without timestamp infomation when "allow_headerless" is disabled. '
    'auto assign ROSTIME to headerless messages once enabling constructor option of "allow_headerless".'
)


def stamp_of(message: Any, allow_headerless: bool, logger_name: str) -> Time | None:
    """Return the stamp in the header of a message.

    Without a header, return the current time if that is allowed. Otherwise, log ROS 2's warning and return None.
    """
    stamp = getattr(getattr(message, 'header', None), 'stamp', None)
    if stamp is None:
        if allow_headerless:
            return ROSClock().now()
        get_logger(logger_name).warning(NO_STAMP)
        return None
    return stamp if hasattr(stamp, 'nanoseconds') else Time.from_msg(stamp)


class Subscriber(SimpleFilter):
    """A subscription as a filter: `Subscriber(node, MessageType, 'topic')`.

    All further arguments are passed to `Node.create_subscription`. The default of `qos_profile` is 10.
    """

    def __init__(self, *args: Any, **kwargs: Any) -> None:
        super().__init__()
        self.node = args[0]
        self.topic: str = args[2]
        kwargs.setdefault('qos_profile', 10)
        self.sub = self.node.create_subscription(*args[1:], self.callback, **kwargs)

    def callback(self, msg: Any) -> None:
        """Pass a message to the callbacks."""
        self.signalMessage(msg)

    def getTopic(self) -> str:
        """Return the topic that was passed to the constructor."""
        return self.topic

    def __getattr__(self, key: str) -> Any:
        """Return an attribute of the subscription."""
        if key == 'sub':
            raise AttributeError(key)
        return getattr(self.sub, key)


class Cache(SimpleFilter):
    """Stores the last `cache_size` messages of the filter `f` in order of arrival, and passes every message on.

    The times in arguments are rclpy Times of ROS time.

    :param allow_headerless: whether a message without a header gets the time of arrival as its stamp; otherwise, it is
        dropped.
    """

    def __init__(self, f: SimpleFilter | None = None, cache_size: int = 1, allow_headerless: bool = False) -> None:
        super().__init__()
        self.cache_size = cache_size
        self.allow_headerless = allow_headerless
        self.cache_msgs: list[Any] = []
        self.cache_times: list[Time] = []
        if f is not None:
            self.connectInput(f)

    def connectInput(self, f: SimpleFilter) -> None:
        """Receive the messages of another filter."""
        self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Store one message. If there are then more than `cache_size` messages, drop the oldest message."""
        stamp = stamp_of(msg, self.allow_headerless, 'message_filters_cache')
        if stamp is None:
            return
        self.cache_times.append(stamp)
        self.cache_msgs.append(msg)
        if len(self.cache_msgs) > self.cache_size:
            self.cache_times.pop(0)
            self.cache_msgs.pop(0)
        self.signalMessage(msg)

    def getInterval(self, from_stamp: Time, to_stamp: Time) -> list[Any]:
        """Return the messages from `from_stamp` to `to_stamp`, including both times."""
        assert from_stamp <= to_stamp
        return [msg for msg, time in zip(self.cache_msgs, self.cache_times, strict=True) if from_stamp <= time <= to_stamp]

    def getElemAfterTime(self, stamp: Time) -> Any:
        """Return the first message that is not older than `stamp`, or None if there is no such message."""
        for msg, time in zip(self.cache_msgs, self.cache_times, strict=True):
            if time >= stamp:
                return msg
        return None

    def getElemBeforeTime(self, stamp: Time) -> Any:
        """Return the last message that is not newer than `stamp`, or None if there is no such message."""
        older = [msg for msg, time in zip(self.cache_msgs, self.cache_times, strict=True) if time <= stamp]
        return older[-1] if older else None

    def getLastestTime(self) -> Time | None:
        """Return the stamp of the message that arrived last, or None for an empty cache. The spelling of the name is that of
        ROS 2.
        """
        return self.cache_times[-1] if self.cache_times else None

    def getLatestTime(self) -> Time | None:
        """Return the same time as :meth:`getLastestTime`. Later releases of ROS 2 use this spelling."""
        return self.getLastestTime()

    def getOldestTime(self) -> Time | None:
        """Return the stamp of the message that arrived first, or None for an empty cache."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        """Return the first message whose stamp is not older than the stamp of the last arrival, or None for an empty cache."""
        latest = self.getLastestTime()
        return None if latest is None else self.getElemAfterTime(latest)


Queue = dict[int, Any]
"""The messages of one topic by their stamp in nanoseconds."""


class TimeSynchronizer(SimpleFilter):
    """Calls its callbacks with one message of each topic if all messages have exactly the same stamp.

    :param fs: the filters (usually Subscribers), in the order of the callback's arguments.
    :param queue_size: the number of messages of each topic that wait for matching messages. If there are more, the oldest message
        is dropped.
    """

    def __init__(self, fs: Sequence[SimpleFilter], queue_size: int) -> None:
        super().__init__()
        self.queue_size = queue_size
        self.lock = Lock()
        self.connectInput(fs)

    def connectInput(self, fs: Sequence[SimpleFilter]) -> None:
        """Receive the messages of these filters."""
        self.queues: list[Queue] = [{} for _ in fs]
        self.input_connections = [
            f.registerCallback(self.add, queue, index) for index, (f, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Store one message. If each topic has a message with its stamp, pass these messages on."""
        with self.lock:
            self._keep(msg, Time.from_msg(msg.header.stamp).nanoseconds, my_queue)
            complete = [stamp for stamp in self.queues[0] if all(stamp in queue for queue in self.queues)]
            for stamp in sorted(complete):
                self._pass([stamp] * len(self.queues))

    def _keep(self, msg: Any, stamp_ns: int, queue: Queue) -> None:
        queue[stamp_ns] = msg
        while len(queue) > self.queue_size:
            del queue[min(queue)]

    def _pass(self, stamps: Sequence[int]) -> None:
        """Pass on one message of each queue, selected by its stamp, and remove these messages from the queues."""
        chosen = list(zip(self.queues, stamps, strict=True))
        self.signalMessage(*(queue[stamp] for queue, stamp in chosen))
        for queue, stamp in chosen:
            del queue[stamp]


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Calls its callbacks with one message of each topic if their stamps differ by less than `slop`.

    :param slop: the limit of the difference, in seconds.
    :param allow_headerless: whether a message without a header gets the time of arrival as its stamp; otherwise, it is
        dropped.
    """

    def __init__(self, fs: Sequence[SimpleFilter], queue_size: int, slop: float, allow_headerless: bool = False) -> None:
        super().__init__(fs, queue_size)
        self.slop_ns = int(slop * 1e9)
        self.allow_headerless = allow_headerless

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Store one message. If messages of all topics are near enough, pass on the nearest set."""
        stamp = stamp_of(msg, self.allow_headerless, 'message_filters_approximate')
        if stamp is None:
            return
        stamp_ns = stamp.nanoseconds
        with self.lock:
            self._keep(msg, stamp_ns, my_queue)
            for stamps in product(*(self._near(queue, stamp_ns, queue is my_queue) for queue in self.queues)):
                if max(stamps) - min(stamps) < self.slop_ns and all(
                    one in queue for queue, one in zip(self.queues, stamps, strict=True)
                ):
                    self._pass(stamps)
                    break

    def _near(self, queue: Queue, stamp_ns: int, is_own: bool) -> list[int]:
        """Return the stamps of a queue that are near enough to `stamp_ns`, nearest first. For the message's own queue, return
        only `stamp_ns`.
        """
        if is_own:
            return [stamp_ns]
        return sorted(
            (stamp for stamp in queue if abs(stamp - stamp_ns) <= self.slop_ns), key=lambda stamp: abs(stamp - stamp_ns)
        )

"""The last messages of a topic, found again by their stamps."""

from __future__ import annotations

from typing import Any

from rclpy.time import Time

from message_filters.simple_filter import SimpleFilter
from message_filters.stamps import stamp_of


class Cache(SimpleFilter):
    """Keeps the last `cache_size` messages of the filter `f`, in the order in which they came, and lets all of them pass.

    Questions are asked with rclpy Times of ROS time.

    :param allow_headerless: messages without a header count as made when they come; else they are dropped.
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
        """Take the messages that pass another filter."""
        self.incoming_connection = f.registerCallback(self.add)

    def add(self, msg: Any) -> None:
        """Keep one message; the oldest goes when there are too many."""
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
        """The messages from one time to another, both included."""
        assert from_stamp <= to_stamp
        return [msg for msg, time in zip(self.cache_msgs, self.cache_times, strict=True) if from_stamp <= time <= to_stamp]

    def getElemAfterTime(self, stamp: Time) -> Any:
        """The first message not older than `stamp`, or None."""
        for msg, time in zip(self.cache_msgs, self.cache_times, strict=True):
            if time >= stamp:
                return msg
        return None

    def getElemBeforeTime(self, stamp: Time) -> Any:
        """The last message not newer than `stamp`, or None."""
        older = [msg for msg, time in zip(self.cache_msgs, self.cache_times, strict=True) if time <= stamp]
        return older[-1] if older else None

    def getLastestTime(self) -> Time | None:
        """The stamp of the message that came last (spelled as ROS 2 spells it), or None."""
        return self.cache_times[-1] if self.cache_times else None

    def getLatestTime(self) -> Time | None:
        """The same, under the name that later releases have."""
        return self.getLastestTime()

    def getOldestTime(self) -> Time | None:
        """The stamp of the message that came first, or None."""
        return self.cache_times[0] if self.cache_times else None

    def getLast(self) -> Any:
        """The first message that is not older than the one that came last, or None."""
        latest = self.getLastestTime()
        return None if latest is None else self.getElemAfterTime(latest)

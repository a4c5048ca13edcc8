"""A filter that delays messages until tf has a transform for their frame. ROS 2 has this filter only in C++."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from rclpy.duration import Duration
from rclpy.time import Time

from message_filters.filters import SimpleFilter

if TYPE_CHECKING:
    from rclpy.node import Node


class FilterFailureReason(IntEnum):
    """The reasons why a message was dropped, with the numbers of tf2_ros."""

    Unknown = 0
    OutTheBack = 1
    EmptyFrameID = 2
    NoTransformFound = 3
    QueueFull = 4


_WORDS = {
    FilterFailureReason.OutTheBack: 'the timestamp on the message is earlier than all the data in the transform cache',
    FilterFailureReason.EmptyFrameID: 'the frame id of the message is empty',
    FilterFailureReason.QueueFull: 'discarding message because the queue is full',
}


class MessageFilter(SimpleFilter):
    """Passes a stamped message on as soon as the message can be transformed, like `tf2_ros::MessageFilter` in C++.

    :param buffer: a `tf2_ros.Buffer` that a listener fills.
    :param target_frame: one frame, or several frames to each of which a transform must exist.
    :param queue_size: the number of messages that wait. If there are more, the oldest message is dropped. 0 means no limit.
    :param node: the node whose logger reports dropped messages.
    :param f: the filter (usually a Subscriber) that provides the messages.
    """

    def __init__(
        self, buffer: Any, target_frame: str | Sequence[str], queue_size: int, node: Node, f: SimpleFilter | None = None
    ) -> None:
        super().__init__()
        self.buffer = buffer
        self.queue_size = queue_size
        self.node = node
        self._waiting: list[Any] = []
        self._failure_callbacks: list[Callable[[Any, FilterFailureReason], Any]] = []
        self._tolerance_ns = 0
        self.setTargetFrame(target_frame)
        buffer.new_data_callbacks.append(self._look_again)
        if f is not None:
            self.connectInput(f)

    def connectInput(self, f: SimpleFilter) -> None:
        """Receive the messages of another filter."""
        f.registerCallback(self.add)

    def setTargetFrame(self, target_frame: str | Sequence[str]) -> None:
        """Set the frame or frames to which a transform must exist."""
        self.target_frames = [target_frame] if isinstance(target_frame, str) else list(target_frame)

    def setTolerance(self, tolerance: Duration) -> None:
        """Require a transform at the stamp of a message, and a second transform at a time that is later by `tolerance`."""
        self._tolerance_ns = tolerance.nanoseconds

    def registerFailureCallback(self, cb: Callable[[Any, FilterFailureReason], Any]) -> None:
        """Call `cb(message, reason)` for each message that is dropped."""
        self._failure_callbacks.append(cb)

    def add(self, msg: Any) -> None:
        """Pass a message on, store it until it can be transformed, or drop it."""
        if not msg.header.frame_id:
            self._drop(msg, FilterFailureReason.EmptyFrameID)
        else:
            self._pass_wait_or_drop(msg)
            if self.queue_size and len(self._waiting) > self.queue_size:
                self._drop(self._waiting.pop(0), FilterFailureReason.QueueFull)

    def clear(self) -> None:
        """Drop all stored messages."""
        self._waiting.clear()

    def _look_again(self) -> None:
        waiting, self._waiting = self._waiting, []
        for msg in waiting:
            self._pass_wait_or_drop(msg)

    def _pass_wait_or_drop(self, msg: Any) -> None:
        problem = self._problem(msg)
        if problem is None:
            self.signalMessage(msg)
        elif 'extrapolation into the past' in problem:
            self._drop(msg, FilterFailureReason.OutTheBack)
        else:
            self._waiting.append(msg)

    def _problem(self, msg: Any) -> str | None:
        """Return tf2's reason why the message cannot be transformed, or None."""
        stamp = Time.from_msg(msg.header.stamp)
        times = [stamp, stamp + Duration(nanoseconds=self._tolerance_ns)] if self._tolerance_ns else [stamp]
        for frame in self.target_frames:
            for time in times:
                possible, reason = self.buffer.can_transform(frame, msg.header.frame_id, time, return_debug_tuple=True)
                if not possible:
                    return str(reason)
        return None

    def _drop(self, msg: Any, reason: FilterFailureReason) -> None:
        stamp = msg.header.stamp
        self.node.get_logger().info(
            f"Message Filter dropping message: frame '{msg.header.frame_id}' at time {stamp.sec + stamp.nanosec / 1e9:.3f} "
            f"for reason '{_WORDS[reason]}'"
        )
        for callback in list(self._failure_callbacks):
            callback(msg, reason)

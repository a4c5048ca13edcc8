"""Messages of several topics with equal stamps."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any

from rclpy.time import Time

from edulaunch.sim.sync import Lock
from message_filters.simple_filter import SimpleFilter

Queue = dict[int, Any]
"""Messages of one topic by their stamp in nanoseconds."""


class TimeSynchronizer(SimpleFilter):
    """Calls back with one message of each topic when all have exactly the same stamp.

    :param fs: the filters (mostly Subscribers), in the order of the callback's arguments.
    :param queue_size: how many messages of each topic wait for their partners; the oldest is dropped.
    """

    def __init__(self, fs: Sequence[SimpleFilter], queue_size: int) -> None:
        super().__init__()
        self.queue_size = queue_size
        self.lock = Lock()
        self.connectInput(fs)

    def connectInput(self, fs: Sequence[SimpleFilter]) -> None:
        """Take the messages that pass these filters."""
        self.queues: list[Queue] = [{} for _ in fs]
        self.input_connections = [
            f.registerCallback(self.add, queue, index) for index, (f, queue) in enumerate(zip(fs, self.queues, strict=True))
        ]

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Let one message wait, and let pass what is complete."""
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
        """Give out one message of each queue, by their stamps, and forget them afterwards."""
        chosen = list(zip(self.queues, stamps, strict=True))
        self.signalMessage(*(queue[stamp] for queue, stamp in chosen))
        for queue, stamp in chosen:
            del queue[stamp]

"""Messages of several topics with nearly equal stamps."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import product
from typing import Any

from message_filters.simple_filter import SimpleFilter
from message_filters.stamps import stamp_of
from message_filters.time_synchronizer import Queue, TimeSynchronizer


class ApproximateTimeSynchronizer(TimeSynchronizer):
    """Calls back with one message of each topic when their stamps differ by less than `slop`.

    :param slop: seconds.
    :param allow_headerless: messages without a header count as made when they come; else they are dropped.
    """

    def __init__(self, fs: Sequence[SimpleFilter], queue_size: int, slop: float, allow_headerless: bool = False) -> None:
        super().__init__(fs, queue_size)
        self.slop_ns = int(slop * 1e9)
        self.allow_headerless = allow_headerless

    def add(self, msg: Any, my_queue: Queue, my_queue_index: int | None = None) -> None:
        """Let one message wait, or pass with the best partners that there are."""
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
        """The stamps of a queue that are near enough, nearest first; of the message's own queue only its own stamp."""
        if is_own:
            return [stamp_ns]
        return sorted(
            (stamp for stamp in queue if abs(stamp - stamp_ns) <= self.slop_ns), key=lambda stamp: abs(stamp - stamp_ns)
        )

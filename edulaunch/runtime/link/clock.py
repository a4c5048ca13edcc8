"""One agenda in two processes.

Each peer has its own items. Only the peer with the *token* runs, and only while its next item comes before the other peer's
next item. So the two peers together run the same items as one process would, in the same order. The *keys* of two items determine
their order:

* in the heap: (time, priority, 0, sequence);
* in the queue for the present instant: (now, 0, 1, number). This first-in, first-out queue has no sequence numbers. Whenever
    the other peer may have scheduled something in between, a *mark* with the next number enters the queue. The number of an item
    is that of the mark before it.

Both peers share the count of sequence numbers, which is sent with the token.
"""

from __future__ import annotations

from collections.abc import Callable
from heapq import heappop

from greenlet import getcurrent

from edulaunch.engine.sim.simulation import EPOCH_NS, FAR_NS, Simulation

Key = tuple[int, int, int, int]
NEVER: Key = (FAR_NS, 0, 0, 0)
BEFORE_ALL = -FAR_NS  # a priority before all items, for the key of the end of a run
IS_MARK = -1  # the value that represents a mark, in place of the priority of a queued item
FOR_THE_OTHER = 1 << 16  # count of numbers reserved for the items that a frame causes in the other peer


class PeerSimulation(Simulation):
    """The clock and agenda of one peer.

    :ivar other: the key of the other peer's next item, as far as this peer knows it.
    :ivar pass_token: a function that passes the token and the key of this peer's next item to the other peer, and waits until
        the token returns.
    """

    def __init__(self, seed: int = 0, start_ns: int = EPOCH_NS) -> None:
        super().__init__(seed, start_ns)
        self.other = NEVER
        self.pass_token: Callable[[Key], object] = lambda key: None
        self._number = 0

    def mark(self) -> None:
        """Sort all later items of this peer after the items that the other peer has scheduled so far."""
        self.last_number += 1
        soon = self._soon
        if soon and soon[-1][1] == IS_MARK:
            soon[-1][2] = self.last_number
        else:
            soon.append([self.now_ns, IS_MARK, self.last_number, None])

    def sequence(self) -> int:
        """Return the sequence number that was assigned last."""
        return self.last_number

    def continue_from(self, number: int) -> None:
        """Record that the other peer has assigned sequence numbers up to this one."""
        self.last_number = number
        self.mark()

    def number_for_the_other(self) -> int:
        """Reserve a sequence number for items that a frame causes in the other peer. Later items of this peer sort after them."""
        number = self.last_number + 1
        self.last_number = number + FOR_THE_OTHER
        self.mark()
        self.other = min(self.other, (self.now_ns, 0, 1, number))
        return number

    def is_marked(self) -> bool:
        """Return whether no item was scheduled since the last mark."""
        soon = self._soon
        return bool(soon) and soon[-1][1] == IS_MARK and soon[-1][2] == self.last_number

    def head(self) -> Key:
        """Return the key of this peer's next item."""
        agenda, soon = self.agenda, self._soon
        while agenda and agenda[0][3] is None:
            heappop(agenda)
        if agenda and agenda[0][0] == self.now_ns and agenda[0][1] <= 0:
            return (self.now_ns, agenda[0][1], 0, agenda[0][2])
        number = self._number
        for item in soon:
            if item[3] is not None:
                return (self.now_ns, 0, 1, number)
            if item[1] == IS_MARK:
                number = item[2]
        return (agenda[0][0], agenda[0][1], 0, agenda[0][2]) if agenda else NEVER

    def run(self, until_ns: int | None = None) -> None:
        """Run the simulation as in one process. A peer without `until_ns` runs until the other peer ends it."""
        self._stopped = False
        self.hub = getcurrent()
        end: Key = NEVER if until_ns is None else (until_ns + 1, BEFORE_ALL, 0, 0)
        while not self._stopped:
            key = self.head()
            if self.other < key and self.other < end:
                self.pass_token(min(key, end))
            elif key < end:
                self._run_one(key)
            elif until_ns is None:
                self.pass_token(key)
            else:
                break
        if until_ns is not None:
            self.now_ns = max(self.now_ns, until_ns)

    def _run_one(self, key: Key) -> None:
        if key[2]:
            item = self._soon.popleft()
            while item[3] is None:
                if item[1] == IS_MARK:
                    self._number = item[2]
                item = self._soon.popleft()
        else:
            item = heappop(self.agenda)
            self.now_ns = item[0]
        item[3]()

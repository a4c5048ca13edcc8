"""Without the cyclic garbage collector, where much is made that stays."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

MANY = 10_000
MOST_UNSEEN = 500_000
"""So much may be made in pauses before the collector looks at all of it: two plans of a thousand nodes."""


class _Unseen:
    """What was made in pauses since the collector looked."""

    things = 0


@contextmanager
def collector_paused() -> Iterator[None]:
    """No garbage collection inside; afterwards what was made counts as old.

    A launch file makes many objects that all stay: to look at them again and again doubles the time of reading it. To look at
    all of them once, at the end of a plan of 1000 nodes, still took a fifth of it (332 ms, without 263 ms).
    """
    if not gc.isenabled():
        yield
        return
    gc.disable()
    try:
        yield
    finally:
        _let_age()
        gc.enable()


def _let_age() -> None:
    """Make many young objects old without looking at each; but not for ever, for there may be garbage among them. A process that
    shares frozen objects with others keeps them so: it lets the collector look.
    """
    made = gc.get_count()[0]
    if made < MANY or gc.get_freeze_count():
        return
    _Unseen.things += made
    if _Unseen.things > MOST_UNSEEN:
        _Unseen.things = 0
        gc.collect()
    else:
        gc.freeze()
        gc.unfreeze()

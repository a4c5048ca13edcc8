"""Pauses the cyclic garbage collector while code creates many long-lived objects."""

from __future__ import annotations

import gc
from collections.abc import Iterator
from contextlib import contextmanager

MANY = 10_000
MOST_UNSEEN = 500_000
"""The number of objects that may be created in pauses before a collection examines all of them: two plans of a thousand nodes."""


class _Unseen:
    """The number of objects that were created in pauses since the last collection, and whether there are frozen objects."""

    things = 0
    has_frozen = False


@contextmanager
def collector_paused() -> Iterator[None]:
    """Prevent garbage collection inside the block. At the end of the block, all new objects are moved to the old generation.

    A launch file creates many long-lived objects, and repeated collections double the time of reading the file. A single
    collection at the end of a plan of 1000 nodes still took 69 ms of 332 ms.
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
    """Move many young objects to the old generation without examining each one. From time to time, collect instead, because there
    may be garbage among them. In a process that shares frozen objects with other processes, the objects stay frozen, and the
    collector runs.
    """
    made = gc.get_count()[0]
    if made >= MANY and not _Unseen.has_frozen:
        _Unseen.has_frozen = gc.get_freeze_count() > 0  # Python counts them one by one: 24 ms for a million
    if made < MANY or _Unseen.has_frozen:
        return
    _Unseen.things += made
    if _Unseen.things > MOST_UNSEEN:
        _Unseen.things = 0
        gc.collect()
    else:
        gc.freeze()
        gc.unfreeze()

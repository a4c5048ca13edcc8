"""The same addresses of objects in each new process, so that what is ordered by them (a set of actions) repeats."""

from __future__ import annotations

import sys
from collections.abc import Iterator
from contextlib import contextmanager

ADDR_NO_RANDOMIZE = 0x0040000
ASK = 0xFFFFFFFF


@contextmanager
def same_addresses() -> Iterator[None]:
    """Programs that are started inside get no random addresses, where the system allows it (Linux; not in every container)."""
    if not sys.platform.startswith('linux'):
        yield
        return
    import ctypes

    personality = ctypes.CDLL(None).personality
    personality.argtypes = [ctypes.c_ulong]
    before = personality(ASK)
    personality(before | ADDR_NO_RANDOMIZE)
    try:
        yield
    finally:
        personality(before)

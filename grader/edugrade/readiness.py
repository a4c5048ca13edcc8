"""Waits for one descriptor. `select.select` does not support descriptors above 1023, which a process with many open files
has.
"""

from __future__ import annotations

import selectors
from typing import Any


def is_readable(end: Any, seconds: float) -> bool:
    """Return whether a descriptor, or an object that has one, becomes readable within some seconds.

    :raises ValueError: when it is closed.
    """
    with selectors.DefaultSelector() as selector:
        selector.register(end, selectors.EVENT_READ)
        return bool(selector.select(seconds))

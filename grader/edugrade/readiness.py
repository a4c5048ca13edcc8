"""Waits until one descriptor is readable.

`select.select` does not support descriptors above 1023, but a process with many open files has such descriptors.
"""

from __future__ import annotations

import selectors
from typing import Any


def is_readable(end: Any, seconds: float) -> bool:
    """Return whether a descriptor, or an object that has one, becomes readable within `seconds` real seconds.

    :raises ValueError: if the descriptor is closed.
    """
    with selectors.DefaultSelector() as selector:
        selector.register(end, selectors.EVENT_READ)
        return bool(selector.select(seconds))

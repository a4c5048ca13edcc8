"""Waiting for one descriptor. `select.select` knows no descriptor above 1023, and a process with many files has such ones."""

from __future__ import annotations

import selectors
from typing import Any


def is_readable(end: Any, seconds: float) -> bool:
    """Return whether a descriptor, or an object that has one, can be read within some seconds.

    :raises ValueError: when it is closed.
    """
    with selectors.DefaultSelector() as selector:
        selector.register(end, selectors.EVENT_READ)
        return bool(selector.select(seconds))

"""The base class of events."""

from __future__ import annotations

from ._bases import StableRepr


class Event(StableRepr):
    """An event of a running launch: something has happened, or something was requested."""

    name = 'launch.Event'

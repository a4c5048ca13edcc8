"""The base class of events."""

from __future__ import annotations

from ._stable_repr import StableRepr


class Event(StableRepr):
    """Something that happened, or that somebody wants to happen, in a running launch."""

    name = 'launch.Event'

"""The base class of events."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._bases import StableRepr

if TYPE_CHECKING:
    pass


class Event(StableRepr):
    """Something that happened, or that code requests, in a running launch."""

    name = 'launch.Event'

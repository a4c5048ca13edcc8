"""The base class of events."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._bases import StableRepr

if TYPE_CHECKING:
    pass


class Event(StableRepr):
    """An event of a running launch: something has happened or was requested."""

    name = 'launch.Event'

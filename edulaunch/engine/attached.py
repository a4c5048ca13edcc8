"""What a low room calls of a higher one without knowing it: the facade, which knows all rooms, tells where it is."""

from __future__ import annotations

from importlib import import_module

TYPE_CHECKING = False  # as `typing.TYPE_CHECKING`, without loading `typing`
if TYPE_CHECKING:
    from typing import Any

PLACES: dict[str, tuple[str, str]] = {}
"""Name -> its module and its name there."""


def attached(name: str) -> Any:
    """What goes by that name; its module is loaded now."""
    module, there = PLACES[name]
    return getattr(import_module(module), there)

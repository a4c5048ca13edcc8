"""Questions about classes and instances."""

from __future__ import annotations

from typing import Any


def isclassinstance(obj: Any) -> bool:
    """Whether `obj` is an instance of a class, which everything is; kept for code of Python 2's time."""
    return hasattr(obj, '__class__')


def is_a(obj: Any, entity_type: Any) -> bool:
    """Whether `obj` is an instance of exactly `entity_type` (or of a sub-class)."""
    return isinstance(obj, entity_type)


def is_a_subclass(obj: Any, entity_type: Any) -> bool:
    """Whether `obj` is an instance of `entity_type`, or a class derived from it."""
    return isinstance(obj, entity_type) or (isinstance(obj, type) and issubclass(obj, entity_type))

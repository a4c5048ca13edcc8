"""What the formats need to know about data types."""

from __future__ import annotations

from typing import Any

from .entity import Entities, Entity


def check_is_list_entity(data_type: Any) -> bool:
    """Whether the data type is `List[Entity]` (or of a kind of entity)."""
    if data_type is Entities:
        return True
    if getattr(data_type, '__origin__', None) is not list:
        return False
    item_type = (data_type.__args__ or (None,))[0]
    return isinstance(item_type, type) and issubclass(item_type, Entity)

"""Entities as a flat list."""

from __future__ import annotations

from collections.abc import Iterable
from typing import Any

from ..launch_description_entity import LaunchDescriptionEntity
from ..some_entities_type import SomeEntitiesType


def normalize_to_list_of_entities(entities: SomeEntitiesType) -> list[LaunchDescriptionEntity]:
    """One entity, or a possibly nested iterable of entities, as a flat list.

    :raises TypeError: for anything else.
    """
    return list(_flat(entities))


def _flat(entities: Any) -> Iterable[LaunchDescriptionEntity]:
    if isinstance(entities, LaunchDescriptionEntity):
        yield entities
        return
    for entity in entities:
        if isinstance(entity, str):
            raise TypeError(
                f"Failed to normalize given item of type '{type(entity)}', when only "
                "'launch.LaunchDescriptionEntity' was expected."
            )
        yield from _flat(entity)

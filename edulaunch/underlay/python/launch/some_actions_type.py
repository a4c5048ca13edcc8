"""The name that ROS 2 Humble uses for :mod:`launch.some_entities_type`."""

from __future__ import annotations

from .some_entities_type import SomeEntitiesType as SomeActionsType
from .some_entities_type import SomeEntitiesType_types_tuple as SomeActionsType_types_tuple

__all__ = ['SomeActionsType', 'SomeActionsType_types_tuple']

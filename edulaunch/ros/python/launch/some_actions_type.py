"""`SomeActionsType`, the name of `SomeEntitiesType` in ROS 2 Humble."""

from .launch_description_entity import SomeEntitiesType as SomeActionsType
from .launch_description_entity import SomeEntitiesType_types_tuple as SomeActionsType_types_tuple

__all__ = ['SomeActionsType', 'SomeActionsType_types_tuple']

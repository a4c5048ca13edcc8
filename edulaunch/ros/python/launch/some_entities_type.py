"""`SomeEntitiesType`, importable from the same path as in ROS 2."""

from .launch_description_entity import SomeEntitiesType as SomeEntitiesType
from .launch_description_entity import SomeEntitiesType_types_tuple as SomeEntitiesType_types_tuple

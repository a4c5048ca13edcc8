"""`SomeSubstitutionsType`, importable from the same path as in ROS 2."""

from .substitution import SomeSubstitutionsType as SomeSubstitutionsType
from .substitution import SomeSubstitutionsType_types_tuple as SomeSubstitutionsType_types_tuple

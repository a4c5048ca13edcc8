"""`is_a`, `is_a_subclass` and `isclassinstance`, importable from the same path as in ROS 2."""

from .type_utils import is_a as is_a
from .type_utils import is_a_subclass as is_a_subclass
from .type_utils import isclassinstance as isclassinstance

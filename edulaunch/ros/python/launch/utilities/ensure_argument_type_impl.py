"""`ensure_argument_type`, importable from the same path as in ROS 2."""

from .type_utils import ensure_argument_type as ensure_argument_type

"""`ensure_argument_type` at its path in ROS 2."""

from .type_utils import ensure_argument_type as ensure_argument_type

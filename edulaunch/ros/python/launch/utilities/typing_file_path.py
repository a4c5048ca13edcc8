"""`FilePath`, importable from the same path as in ROS 2."""

from .type_utils import FilePath as FilePath

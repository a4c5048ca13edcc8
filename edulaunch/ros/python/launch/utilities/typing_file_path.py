"""`FilePath` at its path in ROS 2."""

from .type_utils import FilePath as FilePath

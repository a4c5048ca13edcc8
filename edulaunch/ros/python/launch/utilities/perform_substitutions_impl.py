"""`perform_substitutions`, importable from the same path as in ROS 2."""

from .texts import perform_substitutions as perform_substitutions

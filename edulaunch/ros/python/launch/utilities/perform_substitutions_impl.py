"""`perform_substitutions` at its path in ROS 2."""

from .texts import perform_substitutions as perform_substitutions

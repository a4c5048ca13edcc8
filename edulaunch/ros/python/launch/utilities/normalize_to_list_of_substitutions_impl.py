"""`normalize_to_list_of_substitutions` at its path in ROS 2."""

from .texts import normalize_to_list_of_substitutions as normalize_to_list_of_substitutions

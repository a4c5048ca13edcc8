"""`normalize_to_list_of_substitutions`, importable from the same path as in ROS 2."""

from .texts import normalize_to_list_of_substitutions as normalize_to_list_of_substitutions

"""`normalize_to_list_of_entities`, importable from the same path as in ROS 2."""

from .entities import normalize_to_list_of_entities as normalize_to_list_of_entities

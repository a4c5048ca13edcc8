"""`check_is_list_entity`, importable from the same path as in ROS 2."""

from .entity import check_is_list_entity as check_is_list_entity

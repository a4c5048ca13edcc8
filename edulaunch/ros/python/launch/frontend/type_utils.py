"""`check_is_list_entity` at its path in ROS 2."""

from .entity import check_is_list_entity as check_is_list_entity

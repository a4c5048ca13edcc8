"""The action `SetUseSimTime`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly
from launch.action import Action
from launch.utilities.type_utils import normalize_typed_substitution, perform_typed_substitution

from ..ros_adapters import get_ros_node

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class SetUseSimTime(Action):
    """Set `use_sim_time` of launch's own node, whose clock ROSTimer uses.

    :param value: a bool, a string that contains a bool, or substitutions that give a bool.
    """

    def __init__(self, value: Any, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__value = normalize_typed_substitution(value, bool)

    value: ReadOnly[Any] = ReadOnly('The value, which may contain substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Set the parameter `use_sim_time` of launch's own node."""
        from rclpy.parameter import Parameter

        value = perform_typed_substitution(context, self.__value, bool)
        get_ros_node(context).set_parameters([Parameter('use_sim_time', Parameter.Type.BOOL, value)])

"""SetUseSimTime changes the parameter of launch's own node, if its condition allows it."""

from __future__ import annotations

from typing import Any

import pytest
from launch import LaunchContext
from launch.actions import OpaqueFunction
from launch.conditions import IfCondition
from launch.substitutions import TextSubstitution
from launch_ros.actions import SetUseSimTime
from launch_ros.ros_adapters import get_ros_node


@pytest.mark.parametrize(
    ('value', 'condition', 'after'),
    [
        (True, None, True),
        ([TextSubstitution(text='tr'), TextSubstitution(text='ue')], None, True),
        (False, None, False),
        (True, IfCondition('false'), False),
        (True, IfCondition('true'), True),
    ],
)
def test_the_parameter_is_set_in_the_order_of_the_actions(run: Any, value: Any, condition: Any, after: bool) -> None:
    log: list[Any] = []

    def look(context: LaunchContext) -> None:
        log.append(get_ros_node(context).get_parameter('use_sim_time').value)

    run(OpaqueFunction(function=look), SetUseSimTime(value, condition=condition), OpaqueFunction(function=look))
    assert log == [False, after]


def test_a_string_is_refused() -> None:
    with pytest.raises(TypeError, match="value='true' is not an instance of <class 'bool'>"):
        SetUseSimTime('true')

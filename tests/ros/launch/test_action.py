"""What all actions have: conditions, completion, the line they were made on."""

from __future__ import annotations

import sys
from typing import Any

import pytest
from launch import Action, LaunchContext, LaunchDescription
from launch.actions import DeclareLaunchArgument, GroupAction, LogInfo, OpaqueFunction, RegisterEventHandler
from launch.conditions import IfCondition, UnlessCondition
from launch.event_handlers import OnExecutionComplete


def line() -> int:
    return sys._getframe(1).f_lineno


class OwnAction(Action):
    """What a student may write."""

    def __init__(self, **kwargs: Any) -> None:
        super().__init__(**kwargs)


def test_an_action_knows_the_line_that_made_it() -> None:
    action, here = LogInfo(msg='x'), line()
    assert action.origin == (__file__, here)


def test_the_line_is_that_of_the_call_not_of_an_own_constructor() -> None:
    action, here = OwnAction(), line()
    assert action.origin == (__file__, here)


def test_an_action_without_its_base_constructor_has_no_line() -> None:
    assert OwnAction.__new__(OwnAction).origin is None


def test_an_exception_knows_the_innermost_action() -> None:
    inner = OpaqueFunction(function=lambda context: 1 / 0)
    with pytest.raises(ZeroDivisionError) as error:
        for action in GroupAction([inner]).visit(LaunchContext()) or ():
            action.visit(LaunchContext()) if action is inner else None
    assert error.value.edulaunch_origin == inner.origin  # type: ignore[attr-defined]
    assert error.value.edulaunch_entity == 'OpaqueFunction'  # type: ignore[attr-defined]


@pytest.mark.parametrize(
    ('condition', 'executed'),
    [(None, True), (IfCondition(' TRUE '), True), (IfCondition('0'), False), (UnlessCondition('False'), True)],
)
def test_conditions_decide(condition: Any, executed: bool) -> None:
    calls: list[int] = []
    OpaqueFunction(function=lambda context: calls.append(1), condition=condition).visit(LaunchContext())
    assert bool(calls) is executed


def test_a_false_condition_means_no_completion(launch_it: Any) -> None:
    lines = launch_it(
        RegisterEventHandler(
            OnExecutionComplete(
                target_action=lambda action: isinstance(action, OpaqueFunction), on_completion=LogInfo(msg='done')
            )
        ),
        OpaqueFunction(function=lambda context: None),
        OpaqueFunction(function=lambda context: None, condition=IfCondition('0')),
    )[1]
    assert lines == ['[INFO] [launch.user]: done']


def test_completion_is_told_even_after_an_error(launch_it: Any) -> None:
    lines = launch_it(
        RegisterEventHandler(OnExecutionComplete(on_completion=LogInfo(msg='done'), handle_once=True)),
        OpaqueFunction(function=lambda context: 1 / 0),
    )[1]
    assert lines[-1] == '[INFO] [launch.user]: done'


def test_sub_entities_are_conditional_when_the_action_is() -> None:
    inside = LogInfo(msg='x')
    plain, conditional = (GroupAction([inside], scoped=False), GroupAction([inside], scoped=False, condition=IfCondition('1')))
    assert (plain.describe_sub_entities(), plain.describe_conditional_sub_entities()) == ([inside], [])
    assert conditional.describe_sub_entities() == []
    assert conditional.describe_conditional_sub_entities() == [
        ('Conditionally included by <launch.actions.group_action.GroupAction object at 0x>', [inside])
    ]


def test_descriptions_of_objects_have_no_address() -> None:
    assert repr(LogInfo(msg='x')) == '<launch.actions.log_info.LogInfo object at 0x>'


def test_parse_of_an_action_gives_the_arguments_of_its_element() -> None:
    from io import StringIO

    from launch.frontend import Parser

    class MyArgument(DeclareLaunchArgument):
        pass

    root, parser = Parser.load(StringIO('<launch><arg name="a" if="true"/></launch>'))
    made, kwargs = MyArgument.parse(root.children[0], parser)
    assert (made, kwargs['name'], type(kwargs['condition'])) == (MyArgument, 'a', IfCondition)
    assert set(Action.parse(root.children[0], parser)[1]) == {'condition'}


def test_items_of_a_description_are_checked_when_visited() -> None:
    description = LaunchDescription(['x'])  # type: ignore[list-item]
    assert description.visit(LaunchContext()) == ['x']

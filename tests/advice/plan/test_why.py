"""Why something has its value: each step with its origin and its place, and which one counts."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

from edulaunch.advice.plan import rehearse
from edulaunch.advice.plan.why import argument_chain, branches, name_of, nodes_named, parameter_chain
from edulaunch.errors import UnusableInput
from edulaunch.runtime.session import index_for

HEAD = """
from launch import LaunchDescription
from launch.actions import *
from launch.substitutions import *
from launch_ros.actions import *

def generate_launch_description():
"""
BODY = """
    return LaunchDescription([
        DeclareLaunchArgument('gain', default_value='2.0'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim', namespace='left',
             parameters=[{'background_r': 1}, {'background_r': 2}, {'gain': LaunchConfiguration('gain')}]),
        Node(package='turtlesim', executable='draw_square'),
    ])
"""

Outline = Callable[..., Any]


@pytest.fixture
def outline(tmp_path: Path) -> Outline:
    def make(body: str = BODY, **given: str) -> Any:
        path = tmp_path / 'my.launch.py'
        path.write_text(HEAD + body)
        return rehearse(path, given, index_for([]), {}).outline

    return make


def short(steps: list[dict[str, Any]]) -> list[tuple[Any, str, int | None, bool]]:
    return [(step['value'], step['origin'], step['line'], step['counts']) for step in steps]


def test_branches_are_those_of_all_depths_in_order(outline: Outline) -> None:
    kinds = [branch.item['kind'] for branch in branches(outline()) if branch.item is not None]
    assert [kind for kind in kinds if kind == 'node'] == ['node', 'node']


def test_a_node_is_found_by_its_full_name_or_by_its_executable(outline: Outline) -> None:
    made = outline()
    assert [name_of(each) for each in nodes_named(made, 'left/sim')] == ['/left/sim']
    assert [name_of(each) for each in nodes_named(made, '/draw_square/')] == ['/draw_square']


@pytest.mark.parametrize(('name', 'help'), [('/left/sin', '/left/sim'), ('/quite_another', 'it starts /draw_square, /left/sim')])
def test_a_node_that_is_not_started_is_named_with_those_that_are(outline: Outline, name: str, help: str) -> None:
    with pytest.raises(UnusableInput, match=f"the launch file starts no node '{name}'") as caught:
        nodes_named(outline(), name)
    assert help in str(caught.value)
    with pytest.raises(UnusableInput, match='it starts no node'):
        nodes_named(outline('\n    return LaunchDescription([])\n'), name)


def test_of_several_values_of_a_parameter_the_last_one_counts(outline: Outline) -> None:
    (node,) = nodes_named(outline(), 'left/sim')
    steps = parameter_chain(node, 'background_r', {'value': 69, 'origin': 'default', 'line': None, 'counts': False})
    assert [(step['value'], step['counts']) for step in steps] == [(69, False), (1, False), (2, True)]
    assert parameter_chain(node, 'background_g') == []


def test_a_parameter_from_an_argument_has_the_steps_of_the_argument(outline: Outline) -> None:
    (node,) = nodes_named(outline(gain='3.5'), 'left/sim')
    (step,) = parameter_chain(node, 'gain')
    assert (step['value'], step['counts']) == (3.5, True) and step['origin'] == 'launch argument gain'
    assert [(below['value'], below['counts']) for below in step['argument']] == [('2.0', False), ('3.5', True)]
    (node,) = nodes_named(outline(), 'left/sim')
    (step,) = parameter_chain(node, 'gain')
    assert short(step['argument']) == [('2.0', 'default', 10, True)]


def test_an_argument_has_its_default_and_what_was_given(outline: Outline) -> None:
    assert short(argument_chain(outline(), 'gain')) == [('2.0', 'default', 10, True)]
    default, given = argument_chain(outline(gain='3.5'), 'gain')
    assert (default['value'], default['counts'], given['value'], given['counts']) == ('2.0', False, '3.5', True)


@pytest.mark.parametrize(('name', 'help'), [('gian', 'gain'), ('quite_another', 'its arguments are gain')])
def test_an_argument_that_nobody_declares(outline: Outline, name: str, help: str) -> None:
    with pytest.raises(UnusableInput, match=f"there is no launch argument '{name}'") as caught:
        argument_chain(outline(), name)
    assert help in str(caught.value)
    with pytest.raises(UnusableInput, match='it declares no argument'):
        argument_chain(outline('\n    return LaunchDescription([])\n'), name)

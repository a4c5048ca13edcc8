"""Launch files that look like a mistake and are none."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.advice import judge_plan
from edulaunch.advice.plan import rehearse
from edulaunch.runtime.session import index_for

HEAD = """
import os
from launch import LaunchDescription
from launch.actions import *
from launch.conditions import *
from launch.substitutions import *
from launch_ros.actions import *

sim = Node(package='turtlesim', executable='turtlesim_node', name='sim')

def generate_launch_description():
"""


@pytest.fixture
def rules(tmp_path: Path):
    """The rules that speak of a launch file with this body."""
    edulaunch.source()

    def judged(body: str, **files: str) -> list[str]:
        for name, text in files.items():
            (tmp_path / name.replace('_', '.')).write_text(text)
        path = tmp_path / 'my.launch.py'
        path.write_text(HEAD + body)
        return [finding.rule for finding in judge_plan(rehearse(path, {}, index_for([]), {}))]

    return judged


@pytest.mark.parametrize(
    'body',
    [
        # performed: a text, which may be compared
        """
    def choose(context):
        mode = LaunchConfiguration('mode').perform(context)
        return [sim] if mode == 'draw' else []
    return LaunchDescription([DeclareLaunchArgument('mode', default_value='draw'), OpaqueFunction(function=choose)])""",
        # one name, two meanings
        """
    mode = LaunchConfiguration('mode')
    mode = 'draw'
    if mode == 'draw':
        pass
    return LaunchDescription([sim])""",
        # whether there is one at all
        """
    mode = None or LaunchConfiguration('mode', default='x')
    if mode is not None:
        pass
    return LaunchDescription([sim, LogInfo(msg=mode)])""",
        # added later, and by another function
        """
    ld = LaunchDescription()
    ld.add_action(sim)
    later = TimerAction(period=1.0, actions=[LogInfo(msg='x')])
    def add():
        ld.add_action(later)
    add()
    return ld""",
        # an argument that only an included file reads
        """
    return LaunchDescription([DeclareLaunchArgument('red', default_value='1'), IncludeLaunchDescription(
        os.path.join(os.path.dirname(__file__), 'other.launch.xml'))])""",
        # an argument that only a condition reads, which is not asked
        """
    never = GroupAction([LogInfo(msg='', condition=IfCondition(LaunchConfiguration('gui')))], condition=IfCondition('false'))
    return LaunchDescription([DeclareLaunchArgument('gui', default_value='true'), never, sim])""",
        # a remapping whose name comes from an argument, and is the same for once
        """
    topic = LaunchConfiguration('topic')
    return LaunchDescription([DeclareLaunchArgument('topic', default_value='a'),
        Node(package='turtlesim', executable='turtlesim_node', remappings=[('a', topic)]), sim])""",
        # a value, not an option with its value
        """
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node', arguments=['--title', 'my turtle', '-'])])""",
        # nothing is started because a condition says so
        """
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node', condition=IfCondition('false'))])""",
        # a shell replaces it
        """
    return LaunchDescription([sim, ExecuteProcess(cmd=['echo $(env)'], shell=True)])""",
    ],
)
def test_no_rule_speaks_of_what_only_looks_like_a_mistake(rules: Any, body: str) -> None:
    xml = '<launch><node pkg="turtlesim" exec="turtlesim_node" name="sim"><param name="background_r" value="$(var red)"/></node></launch>'
    assert rules(body, other_launch_xml=xml) == []


FILE = "[os.path.join(os.path.dirname(__file__), 'p.yaml')]"


@pytest.mark.parametrize(
    ('keys', 'expected'),
    [
        (('/sim',), []),
        (('/**',), []),
        (('/*',), []),
        (('/other', '/sim'), []),
        (('/other', '/another'), ['launch.key-for-no-node']),
        (('/left/sim',), ['launch.key-for-no-node']),
    ],
)
def test_a_file_for_several_nodes_is_fine_when_one_key_means_the_node(rules: Any, keys: Any, expected: list[str]) -> None:
    text = ''.join(f'{key}:\n  ros__parameters:\n    background_r: 1\n' for key in keys)
    body = f"""
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters={FILE})])"""
    assert rules(body, p_yaml=text) == expected


def test_a_node_whose_name_only_the_program_knows_is_not_judged_by_keys(rules: Any) -> None:
    body = f"""
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node', parameters={FILE})])"""
    assert rules(body, p_yaml='/turtlesim:\n  ros__parameters:\n    background_r: 1\n') == []


@pytest.mark.parametrize(
    ('test', 'outcome'),
    [
        ("mode == 'draw'", 'False'),
        ("LaunchConfiguration('mode') != 'draw'", 'True'),
        ('mode', 'True'),
        ('not mode', 'False'),
        ("os.sep and mode == 'draw'", 'False'),
    ],
)
def test_a_python_if_says_how_it_always_comes_out(tmp_path: Path, test: str, outcome: str) -> None:
    path = tmp_path / 'my.launch.py'
    path.write_text(
        f"{HEAD}    mode = LaunchConfiguration('mode')\n    more = [LogInfo(msg='x')] if {test} else []\n"
        "    return LaunchDescription([DeclareLaunchArgument('mode', default_value='draw'), sim, *more])\n"
    )
    (finding,) = judge_plan(rehearse(path, {}, index_for([]), {}))
    assert (finding.rule, finding.facts['outcome'], finding.facts['argument']) == ('launch.python-if', outcome, 'mode')


def test_an_action_that_was_taken_out_by_a_comment_is_no_mistake(rules: Any) -> None:
    body = (
        "    other = Node(package='turtlesim', executable='mimic')\n    return LaunchDescription([\n        sim,\n{line}    ])\n"
    )
    assert rules(body.format(line='')) == ['launch.not-added']
    assert rules(body.format(line='        # other,  # not today\n')) == []


def test_a_file_for_the_other_nodes_is_no_mistake(rules: Any, tmp_path: Path) -> None:
    file = tmp_path / 'both.yaml'
    body = f"    return LaunchDescription([\n        Node(package='turtlesim', executable='turtlesim_node', name=one, parameters=[{str(file)!r}])\n        for one in ('a', 'b')])\n"
    file.write_text('a: {ros__parameters: {background_r: 1}}\n')
    assert rules(body) == []
    file.write_text('x: {ros__parameters: {background_r: 1}}\n')
    assert set(rules(body)) == {'launch.key-for-no-node'}


def test_a_component_container_hands_its_parameters_on(rules: Any, tmp_path: Path) -> None:
    file = tmp_path / 'nav.yaml'
    file.write_text('amcl: {ros__parameters: {a: 1}}\n')
    node = "Node(package='rclcpp_components', executable='component_container', name='box', parameters=[" + repr(str(file)) + '])'
    assert rules(f'    return LaunchDescription([{node}])\n') == []


def test_an_element_that_another_package_brings_is_no_mistake(tmp_path: Path) -> None:
    path = tmp_path / 'a.launch.xml'
    path.write_text('<launch>\n  <gz_server world_sdf_file="empty.sdf"/>\n</launch>\n')
    found = judge_plan(rehearse(path, {}, index_for([]), {}))
    assert [(one.rule, one.facts['package'], one.line) for one in found] == [('launch.needs-elsewhere', 'ros_gz_sim', 2)]

"""Unit tests of launch files bring contexts of their own, which have just what upstream's code asks for."""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

import pytest
from launch.actions import DeclareLaunchArgument, GroupAction, SetEnvironmentVariable, SetLaunchConfiguration
from launch.descriptions import Executable
from launch.substitutions import (
    AnonName,
    EqualsSubstitution,
    FindExecutable,
    LaunchConfiguration,
    PythonExpression,
    TextSubstitution,
)
from launch.utilities import perform_substitutions
from launch_ros.actions import Node, PushROSNamespace, SetParameter, SetParametersFromFile, SetRemap
from launch_ros.substitutions import ExecutableInPackage, FindPackageShare


class Context:
    """A stand-in for a launch context."""

    def __init__(self) -> None:
        self.launch_configurations: dict[str, Any] = {'here': 'set'}
        self.environment = os.environ

    def perform_substitution(self, substitution: Any) -> str:
        text: str = substitution.perform(self)
        return text


@pytest.mark.parametrize(
    'substitution',
    [
        LaunchConfiguration('here'),
        FindExecutable(name='sh'),
        PythonExpression('1'),
        AnonName('a'),
        EqualsSubstitution('1', '1'),
        FindPackageShare('turtlesim'),
        ExecutableInPackage('turtlesim_node', 'turtlesim'),
    ],
    ids=lambda one: type(one).__name__,
)
def test_substitutions_ask_for_no_more(substitution: Any) -> None:
    assert substitution.perform(Context())


@pytest.mark.parametrize(
    'action',
    [
        SetLaunchConfiguration('a', 'b'),
        DeclareLaunchArgument('a', default_value='b'),
        GroupAction([]),
        SetEnvironmentVariable('EDULAUNCH_TEST', '1'),
        SetParameter('a', 1),
        SetRemap('a', 'b'),
        PushROSNamespace('n'),
    ],
    ids=lambda one: type(one).__name__,
)
def test_actions_ask_for_no_more(action: Any) -> None:
    context: Any = Context()
    context.would_handle_event = lambda event: False
    action.visit(context)


def test_command_line_of_a_node_is_made_without_a_launch(tmp_path: Path) -> None:
    context: Any = Context()
    file = tmp_path / 'all.yaml'
    file.write_text('/**:\n  ros__parameters:\n    a: 1\n')
    for action in (SetParameter('p', 'v'), SetParametersFromFile(str(file)), SetRemap('a', 'b')):
        action.execute(context)
    node: Any = Node(package='turtlesim', executable='turtlesim_node', name='n', remappings=[('c', 'd')])
    node._perform_substitutions(context)
    words = [perform_substitutions(context, word) for word in node.cmd if type(word[0]) is TextSubstitution]
    assert words[-8:] == ['-p', 'p:=v', '--params-file', str(file), '-r', 'a:=b', '-r', 'c:=d']
    assert node.expanded_remapping_rules == [('a', 'b'), ('c', 'd')]


def test_executable_is_prepared_without_a_launch() -> None:
    executable = Executable(cmd=['ls', '-l'], additional_env={'A': 'b'})
    executable.prepare(Context(), None)  # type: ignore[arg-type]
    assert executable.final_cmd == ['ls', '-l'] and executable.final_env is not None and executable.final_env['A'] == 'b'

"""SetParameter, SetParametersFromFile, SetRemap, SetROSLogDir: settings for all nodes that follow."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from launch.actions import GroupAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import (
    Node,
    PushROSNamespace,
    PushRosNamespace,
    SetParameter,
    SetParametersFromFile,
    SetRemap,
    SetROSLogDir,
)
from launch_ros.substitutions import Parameter


def drive(**arguments: Any) -> Node:
    return Node(package='robo', executable='drive', **arguments)


@pytest.mark.parametrize(
    ('value', 'word'), [(1, 'p:=1'), ('text', 'p:=text'), (True, 'p:=True'), ([1, 2], 'p:=(1, 2)'), ('', 'p:='), (1.0, 'p:=1.0')]
)
def test_a_global_parameter_is_written_as_ros_writes_it(run: Any, value: Any, word: str) -> None:
    assert run(SetParameter('p', value), drive()).words == ['--ros-args', '-p', word]


def test_global_settings_come_before_the_nodes_own(run: Any, tmp_path: Path) -> None:
    file = tmp_path / 'p.yaml'
    file.write_text('{}', encoding='utf-8')
    settings = [SetRemap('x', 'y'), SetParameter('p', 1), SetParametersFromFile(str(file))]
    assert run(*settings, drive(parameters=[{'q': 2}], remappings=[('a', 'b')])).words == [
        '--ros-args',
        '-p',
        'p:=1',
        '--params-file',
        str(file),
        '--params-file',
        'PARAMS',
        '-r',
        'x:=y',
        '-r',
        'a:=b',
    ]


def test_a_group_ends_a_setting_unless_one_was_made_before_it(run: Any) -> None:
    scoped = GroupAction([SetParameter('p', 1)])
    assert run(scoped, drive()).words == ['--ros-args']
    leaking = GroupAction([SetParameter('p', 1)])
    assert run(SetParameter('o', 0), leaking, drive()).words == ['--ros-args', '-p', 'o:=0', '-p', 'p:=1']


def test_a_missing_file_fails_when_a_node_comes(run: Any) -> None:
    launched = run(SetParametersFromFile('/no/such.yaml'), drive())
    assert launched.specs == []
    assert launched.logs[0][2].startswith('Caught exception in launch')


def test_global_parameters_can_be_read_back(run: Any, context: Any) -> None:
    made = context()
    made.launch_configurations['global_params'] = [('p', 1), ('p', 2)]
    assert Parameter('p').perform(made) == '2'
    assert Parameter('q', default=LaunchConfiguration('x', default='d')).perform(made) == 'd'
    with pytest.raises(RuntimeError, match="parameter 'q' not found"):
        Parameter('q').perform(made)


def test_the_log_folder_of_nodes_is_set_in_the_environment_relative_to_the_one_before(context: Any) -> None:
    made = context()
    for folder in ('/logs', 'deeper', ['$', 'x']):
        SetROSLogDir(folder).visit(made)
    assert made.environment.pop('ROS_LOG_DIR') == '/logs/deeper/$x'


def test_a_namespace_that_cannot_be_is_refused(run: Any) -> None:
    assert PushRosNamespace is PushROSNamespace
    assert (
        run(PushRosNamespace('a-b'))
        .logs[0][2]
        .endswith("The resulting namespace is invalid: [previous_namespace='None', pushed_namespace='a-b']")
    )

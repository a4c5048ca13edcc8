"""`edulaunch plan`: what would start, without starting anything."""

from __future__ import annotations

import json
import os
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.cli.main import main

TEXT = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, TimerAction
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('red', default_value='69'),
        Node(package='turtlesim', executable='turtlesim_node', name='sim',
             parameters=[{'background_r': LaunchConfiguration('red')}], remappings=[('a', 'b')]),
        TimerAction(period=2.0, actions=[Node(package='PACKAGE', executable='talker', name='late')]),
    ])
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / 'my.launch.py'
    path.write_text(TEXT.replace('PACKAGE', 'demo_nodes_cpp'))
    return path


def test_nodes_come_with_their_parameters_remaps_and_timers(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['plan', str(file), 'red:=7']) == 0
    assert capsys.readouterr().out.splitlines()[1:] == [
        "├── argument red = '7'  <my.launch.py:9>",
        '├── node /sim: turtlesim turtlesim_node  <my.launch.py:10>',
        '│   ├── parameter background_r = 7  (launch argument red)',
        '│   └── remap a -> b',
        '└── timer after 2 s  <my.launch.py:12>',
        '    └── node /late: demo_nodes_cpp talker  <my.launch.py:12>',
        'nodes: 2, other processes: 0, reason of the shutdown: idle',
    ]


def test_as_json_it_is_plan_format_1(file: Path, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['plan', str(file), '--json']) == 0
    plan = json.loads(capsys.readouterr().out)
    assert (plan['format'], plan['error'], [item['kind'] for item in plan['items']]) == (
        1,
        None,
        ['include', 'argument', 'node', 'timer', 'node'],
    )


def test_missing_packages_are_an_error_unless_assumed(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / 'my.launch.py'
    path.write_text(TEXT.replace('PACKAGE', 'my_robot').replace("'turtlesim'", "'my_robot'"))
    assert main(['plan', str(path)]) == 1
    err = capsys.readouterr().err
    assert "package 'my_robot' not found" in err and f'{path}:10' in err and '  help: ' in err
    assert main(['plan', str(path), '--assume-packages']) == 0
    shown = capsys.readouterr()
    assert '── node /sim: my_robot turtlesim_node' in shown.out
    assert shown.err == 'missing packages, with placeholders instead: my_robot\n'


def test_parameter_files_that_are_not_there_stand_below_their_node(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / 'my.launch.xml'
    path.write_text(
        '<launch><node pkg="my_robot" exec="a"><param from="$(find-pkg-share my_robot)/a.yaml"/>'
        '<param from="/none/b.yaml"/></node></launch>'
    )
    assert main(['plan', str(path), '--assume-packages']) == 0
    assert capsys.readouterr().out.splitlines()[2:4] == [
        '    ├── parameter file my_robot/a.yaml is missing',
        '    └── parameter file /none/b.yaml is missing',
    ]


def test_configurations_that_outlive_a_reset_are_shown(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    path = tmp_path / 'my.launch.xml'
    path.write_text('<launch><group forwarding="false"><keep name="mode" value="slow"/></group></launch>')
    assert main(['plan', str(path)]) == 0
    assert capsys.readouterr().out.splitlines()[-3:-1] == ['    └── reset configurations', "        └── but mode = 'slow'"]


def test_a_terminal_without_line_drawing_gets_a_plain_tree(file: Path) -> None:
    run = subprocess.run(
        [sys.executable, '-m', 'edulaunch', 'plan', str(file)],
        capture_output=True,
        check=True,
        env={**os.environ, 'PYTHONIOENCODING': 'ascii'},
    )
    assert b'\n`-- timer after 2 s' in run.stdout


def test_a_package_without_a_file_gets_the_names_of_its_launch_files(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['plan', 'turtlesim']) == 2
    assert capsys.readouterr().err.endswith('help: name a launch file of turtlesim: multisim.launch.py\n')

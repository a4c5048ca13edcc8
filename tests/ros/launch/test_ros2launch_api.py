"""What `ros2 launch` is made of."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.conditions import IfCondition
from launch.substitutions import LaunchConfiguration
from ros2launch.api.api import (
    arguments_text,
    is_launch_file,
    launch_a_launch_file,
    parse_launch_arguments,
    print_a_launch_file,
    print_arguments_of_launch_file,
)

GOLDEN = """\
Arguments (pass arguments as '<name>:=<value>'):

    'x':
        an x
        (default: '3')

    'who':
        no description given
        (default: LaunchConfig('x') + '_w')

    'cond':*
        no description given
        (default: 'q')

* argument(s) which are only used if specific conditions occur"""


def test_the_list_of_arguments() -> None:
    assert (
        arguments_text(
            LaunchDescription(
                [
                    DeclareLaunchArgument('x', default_value='3', description='an x'),
                    DeclareLaunchArgument('who', default_value=[LaunchConfiguration('x'), '_w']),
                    DeclareLaunchArgument('cond', default_value='q', condition=IfCondition('true')),
                ]
            )
        )
        == GOLDEN
    )


def test_no_arguments() -> None:
    assert arguments_text(LaunchDescription()) == "Arguments (pass arguments as '<name>:=<value>'):\n\n  No arguments."


def test_arguments_are_split_at_the_first_sign_and_the_last_wins() -> None:
    assert parse_launch_arguments(['a:=1', 'b:=x:=y', 'a:=2']) == [('a', '2'), ('b', 'x:=y')]


@pytest.mark.parametrize('text', ['mode=zz', ':=x', 'x:='])
def test_malformed_arguments(text: str) -> None:
    with pytest.raises(RuntimeError) as error:
        parse_launch_arguments([text])
    assert str(error.value) == f"malformed launch argument '{text}', expected format '<name>:=<value>'"


@pytest.fixture
def file(tmp_path: Path) -> str:
    path = tmp_path / 'a.launch.py'
    path.write_text(
        'from launch import LaunchDescription\nfrom launch.actions import *\n'
        'from launch.substitutions import *\ndef generate_launch_description():\n'
        "    return LaunchDescription([DeclareLaunchArgument('x'), LogInfo(msg=LaunchConfiguration('x'))])\n"
    )
    return str(path)


def test_a_file_is_shown_and_launched(file: str, capsys: Any) -> None:
    print_arguments_of_launch_file(launch_file_path=file)
    assert capsys.readouterr().out.splitlines()[2:] == ["    'x':", '        no description given']
    print_a_launch_file(launch_file_path=file)
    assert "└── LogInfo(LaunchConfig('x'))" in capsys.readouterr().out
    assert launch_a_launch_file(launch_file_path=file, launch_file_arguments=['x:=hello']) == 0
    assert capsys.readouterr().out.splitlines()[-1] == '[INFO] [launch.user]: hello'


def test_a_missing_argument_of_the_file_itself(file: str, capsys: Any) -> None:
    assert launch_a_launch_file(launch_file_path=file, launch_file_arguments=[]) == 1
    out = capsys.readouterr().out
    assert "missing required argument 'x' (description: 'no description given'), given: []" in out
    assert 'pass x:=..., or add default_value=... to its DeclareLaunchArgument' in out


def test_what_a_launch_file_is_called(file: str, tmp_path: Path) -> None:
    (tmp_path / 'a.txt').touch()
    (tmp_path / 'a.launch.xml').touch()
    assert [is_launch_file(str(tmp_path / name)) for name in ('a.launch.py', 'a.launch.xml', 'a.txt', 'b.py')] == [
        True,
        True,
        False,
        False,
    ]

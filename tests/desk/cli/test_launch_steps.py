"""`edulaunch launch --step`: what the prompt answers, and that the run stays what it is."""

from __future__ import annotations

import io
from pathlib import Path
from typing import Any

import pytest

from edulaunch.desk.cli.main import main
from edulaunch.engine.recording import Recording

FILE = """
from launch import LaunchDescription
from launch.actions import *
from launch_ros.actions import Node, PushRosNamespace
def generate_launch_description():
    return LaunchDescription([
        DeclareLaunchArgument('who', default_value='me'),
        GroupAction([
            PushRosNamespace('a'),
            Node(package='demo_nodes_py', executable='talker', name='one'),
        ]),
        TimerAction(period=1.0, actions=[LogInfo(msg='late')]),
    ])
"""


@pytest.fixture
def file(tmp_path: Path) -> Path:
    path = tmp_path / 'a.launch.py'
    path.write_text(FILE)
    return path


@pytest.fixture
def step(file: Path, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]) -> Any:
    def run(*lines: str) -> list[str]:
        monkeypatch.setattr('sys.stdin', io.StringIO('\n'.join([*lines, ''])))
        record = file.with_suffix('.rec')
        assert main(['launch', str(file), '--fast', '--for', '2', '--step', '--quiet', '--record', str(record)]) == 0
        said = capsys.readouterr().out
        return [
            line.removeprefix('(launch) ') for line in said.splitlines() if '->' in line or line.startswith(('(launch)', ' '))
        ]

    return run


def stops(lines: list[str]) -> list[str]:
    return [
        line.split(maxsplit=4)[4] if '.py' in line.split()[3] else line.split(maxsplit=3)[3] for line in lines if '->' in line
    ]


def test_enter_goes_from_action_to_action(step: Any) -> None:
    assert stops(step('', '', '', '', '', '', 'g')) == [
        'DeclareLaunchArgument who',
        'group',
        'PushROSNamespace',
        'Node talker',
        'TimerAction',
        "LogInfo 'late'",
    ]


def test_over_a_group_to_an_event_and_to_a_line(step: Any) -> None:
    assert stops(step('n', 'n', 'e', 'l a.launch.py:12')) == [
        'DeclareLaunchArgument who',
        'group',
        'TimerAction',
        'talker-1 started',
        "LogInfo 'late'",
    ]


def test_back_and_the_context_there(step: Any) -> None:
    lines = step('', '', '', 'c', 'b', 'b', 'c', 'b', 'b', 'f', 'w', 'x', 'l nothing', 'g')
    assert "  namespace: '/a'" in lines
    assert sum(line == "  who: 'me'" for line in lines) == 2
    assert 'this is the first action' in lines
    assert any(line.startswith('  here') and 'Node talker' not in line for line in lines)
    assert any('go to the next event that launch processes' in line for line in lines)
    assert 'give a file and a line, such as: l demo.launch.py:12' in lines


def test_stepping_changes_nothing_in_the_run(step: Any, file: Path) -> None:
    step(*[''] * 20)
    stepped = Recording.load(file.with_suffix('.rec')).digest()
    plain = file.with_suffix('.plain')
    assert main(['launch', str(file), '--fast', '--for', '2', '--quiet', '--record', str(plain)]) == 0
    assert Recording.load(plain).digest() == stepped


def test_q_shuts_the_launch_down(step: Any, file: Path) -> None:
    step('', '', '', '', 'q')
    assert Recording.load(file.with_suffix('.rec')).duration_s < 1


def test_the_first_stop_tells_the_answers_and_a_wrong_answer_is_named(step: Any, capsys: pytest.CaptureFixture[str]) -> None:
    lines = step('jump', '?', 'g')
    assert any(line.startswith('jump is no answer') for line in lines)
    assert sum('go to the next event' in line for line in lines) == 2
    assert not any('? is no answer' in line for line in lines)

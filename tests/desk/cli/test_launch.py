"""`edulaunch launch`: the console of `ros2 launch`."""

from __future__ import annotations

import os
import signal
import subprocess
import sys
from pathlib import Path

import pytest

from tests.house import ROOT

from .conftest import HEAD, describe


def test_the_console_is_that_of_ros2_launch(run) -> None:
    code, out, err = run(describe("LogInfo(msg='hello')", "Node(package='demo_nodes_cpp', executable='talker', output='screen')"))
    lines = out.splitlines()
    assert lines[:3] == [
        '[INFO] [launch]: Default logging verbosity is set to INFO',
        '[INFO] [launch.user]: hello',
        '[INFO] [talker-1]: process started with pid [1002]',
    ]
    assert lines[3] == "[talker-1] [INFO] [1700000001.000000000] [talker]: Publishing: 'Hello World: 1'"
    assert '[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)' in lines
    assert lines[-1] == '[INFO] [talker-1]: process has finished cleanly [pid 1002]'
    assert (code, err) == (0, '')


@pytest.mark.parametrize(
    ('text', 'said', 'where', 'tried'),
    [
        ('x = 1\n', "does not contain the required function 'generate_launch_description()'", '', ''),
        (
            HEAD + 'def generate_launch_description():\n    LaunchDescription([])\n',
            "'NoneType' object has no attribute",
            '',
            'return',
        ),
        (
            HEAD + 'def generate_launch_description():\n    return [LogInfo(msg="x")]\n',
            "'list' object has no attribute",
            '',
            'LaunchDescription',
        ),
        (HEAD + 'def generate_launch_description(:\n', 'SyntaxError: invalid syntax', 'my.launch.py:4', ''),
        (
            HEAD + 'def generate_launch_description():\n    return 1 / 0\n',
            'ZeroDivisionError: division by zero',
            'my.launch.py:5',
            '',
        ),
        (
            describe("Node(package='turtlesm', executable='turtlesim_node')"),
            "package 'turtlesm' not found, searching:",
            'my.launch.py:5',
            'turtlesim',
        ),
        (
            describe("Node(package='turtlesim', executable='turtle')"),
            "executable 'turtle' not found on the libexec directory",
            'my.launch.py:5',
            'turtle',
        ),
        (describe("DeclareLaunchArgument('n', default_value=3)"), "'int' object is not iterable", 'my.launch.py:5', "'3'"),
        (describe("DeclareLaunchArgument('needed')"), "missing required argument 'needed'", '', ''),
    ],
)
def test_a_launch_file_that_cannot_work_is_explained(run, text: str, said: str, where: str, tried: str) -> None:
    code, out, err = run(text)
    assert said in out and where in out and tried in out
    assert code == 1 and 'Traceback' not in out + err


@pytest.mark.parametrize(
    ('text', 'said'),
    [
        ('robot: [1, 2\n', "Couldn't parse params file"),
        ('robot:\n  radius: 1\n', "Couldn't parse params file"),
        ('just text\n', "Couldn't parse params file"),
    ],
)
def test_a_parameter_file_that_cannot_be_read_is_explained(run, tmp_path: Path, text: str, said: str) -> None:
    (tmp_path / 'p.yaml').write_text(text)
    code, out, err = run(
        describe(f"Node(package='demo_nodes_cpp', executable='talker', parameters=[{str(tmp_path / 'p.yaml')!r}])")
    )
    assert said in out and '@/p.yaml' in out
    assert code == 0 and '[talker-1]   help: ' in out and not err


@pytest.mark.processes
def test_ctrl_c_in_real_time_shuts_down_as_ros_does() -> None:
    """The whole command in a process of its own, interrupted by a real signal as soon as it talks."""
    command = [sys.executable, '-m', 'edulaunch', 'launch', 'demo_nodes_cpp', 'talker_listener_launch.py']
    with subprocess.Popen(
        command,
        cwd=ROOT,
        stdout=subprocess.PIPE,
        stderr=subprocess.STDOUT,
        text=True,
        env={**os.environ, 'PYTHONUNBUFFERED': '1'},
    ) as child:
        assert child.stdout is not None
        lines = []
        for line in child.stdout:
            lines.append(line.rstrip())
            if 'process started with pid' in line and len(lines) >= 3:
                child.send_signal(signal.SIGINT)
        assert child.wait(20) == 0
    assert '[WARNING] [launch]: user interrupted with ctrl-c (SIGINT)' in lines
    assert sum('process has finished cleanly' in line for line in lines) == 2


def test_a_program_reads_its_keyboard_from_a_file(run, tmp_path: Path) -> None:
    (tmp_path / 'keys').write_text('Ada\n')
    (tmp_path / 'ask.py').write_text("print('hello', input('name? '))\n")
    ask = f"ExecuteProcess(cmd=['python3', {str(tmp_path / 'ask.py')!r}], name='ask', output='screen')"
    code, out, err = run(describe(ask), '--stdin', f'ask={tmp_path / "keys"}', '--stdin', f'nobody={tmp_path / "keys"}')
    assert '[ask-1] name? hello Ada' in out.splitlines()
    assert (code, err) == (0, 'warning: --stdin nobody: the launch file started no program of this name\n')


def test_output_comes_before_the_line_about_the_end(run, tmp_path: Path) -> None:
    (tmp_path / 'count.py').write_text('for i in range(3): print(i)\nraise SystemExit(3)\n')
    code, out, err = run(describe(f"ExecuteProcess(cmd=['python3', {str(tmp_path / 'count.py')!r}], output='screen')"))
    assert out.splitlines()[1:] == [
        '[INFO] [python3-1]: process started with pid [1002]',
        '[python3-1] 0',
        '[python3-1] 1',
        '[python3-1] 2',
        "[ERROR] [python3-1]: process has died [pid 1002, exit code 3, cmd 'python3 @/count.py'].",
    ]


def test_a_program_that_cannot_be_started_is_explained_without_our_frames(run) -> None:
    code, out, err = run(describe("ExecuteProcess(cmd=['echo hi'])"))
    assert out.splitlines()[1:4] == [
        '[ERROR] [echo hi-1]: exception occurred while executing process:',
        "FileNotFoundError: [Errno 2] No such file or directory: 'echo hi'",
        "  help: @/my.launch.py:5: there is no program 'echo hi' on the PATH; write each argument as an item of cmd of its own, or "
        'shell=True',
    ]


def test_a_command_in_one_text_is_explained(run) -> None:
    code, out, err = run(describe("ExecuteProcess(cmd='zz -a')"))
    assert out.splitlines()[2:4] == [
        "FileNotFoundError: [Errno 2] No such file or directory: 'z'",
        '  help: @/my.launch.py:5: cmd is one text, of which each letter became a word: put it into a list, cmd=[[...]] with shell=True',
    ]


def test_the_heading_of_the_arguments_comes_before_what_an_included_file_says(run, tmp_path: Path) -> None:
    inner = tmp_path / 'inner.launch.py'
    inner.write_text(f'print("inner is read")\n{describe()}')
    _, out, _ = run(describe("DeclareLaunchArgument('speed')", f"IncludeLaunchDescription('{inner}')"), '-s')
    assert out.splitlines()[:4] == ["Arguments (pass arguments as '<name>:=<value>'):", 'inner is read', '', "    'speed':"]


def test_the_run_can_be_looked_at_afterwards(run, tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.chdir(tmp_path)
    _, _, err = run(describe("Node(package='turtlesim', executable='turtlesim_node')"), '--view')
    assert err == 'view: my.html\n'
    assert (tmp_path / 'my.html').read_text().startswith('<!DOCTYPE html>')

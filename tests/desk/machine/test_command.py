"""The command `ros2` beside a real one.

The live page that a command in a terminal brings with it.
"""

from __future__ import annotations

import os
import re
import signal
import subprocess
import sys
import urllib.error
import urllib.request
from pathlib import Path

import pytest

from edulaunch.desk.machine.command import tab_of
from tests.desk.machine.shells import PATIENCE_S, ROS2, Desk, Shell


@pytest.fixture
def real(tmp_path: Path) -> Path:
    """A folder with what stands for the `ros2` of a real ROS 2."""
    place = tmp_path / 'opt' / 'bin'
    place.mkdir(parents=True)
    for name in ('ros2', 'rosdep'):
        (place / name).write_text(f'#!/bin/sh\necho real {name} "$@"\nexit 7\n')
        (place / name).chmod(0o755)
    return place


def run(desk: Desk, *words: str, program: list[str] = ROS2, **env: str) -> subprocess.CompletedProcess[str]:
    return subprocess.run(
        [*program, *words], env={**desk.env, **env}, cwd=desk.folder, capture_output=True, text=True, timeout=PATIENCE_S
    )


@pytest.mark.parametrize('sign', ['ROS_DISTRO', 'AMENT_PREFIX_PATH'])
def test_it_steps_aside_for_a_real_one_that_is_sourced(desk: Desk, real: Path, sign: str) -> None:
    path = f'{real}{os.pathsep}{desk.env["PATH"]}'
    done = run(desk, 'topic', 'list', PATH=path, **{sign: 'jazzy'})
    assert (done.returncode, done.stdout, done.stderr) == (7, 'real ros2 topic list\n', '')


@pytest.mark.skipif(not os.path.exists('/dev/full'), reason='no such device')
@pytest.mark.parametrize(
    ('line', 'said'),
    [
        ([*ROS2, 'topic', 'list'], 'cannot write the output of the command: No space left on device\n'),
        ([sys.executable, '-m', 'edulaunch', 'explain', 'turtlesim', 'multisim.launch.py'], 'error: No space left on device: '),
        ([sys.executable, '-m', 'edugrade', 'doctor'], 'edugrade: the report cannot be written: No space left on device\n'),
    ],
)
def test_a_full_disk_is_told(desk: Desk, line: list[str], said: str) -> None:
    with open('/dev/full', 'w') as full:
        done = subprocess.run(
            line, env=desk.env, cwd=desk.folder, stdout=full, stderr=subprocess.PIPE, text=True, timeout=PATIENCE_S
        )
    assert done.returncode in (1, 2) and 'Traceback' not in done.stderr and said in done.stderr


def test_verbose_says_so(desk: Desk, real: Path) -> None:
    done = run(desk, '--verbose', 'topic', 'list', PATH=str(real), ROS_DISTRO='jazzy')
    assert done.stdout == 'real ros2 topic list\n' and f'so {real}/ros2 runs' in done.stderr


def test_one_that_is_not_sourced_is_not_meant(desk: Desk, real: Path) -> None:
    assert run(desk, 'topic', 'list', PATH=f'{real}{os.pathsep}{desk.env["PATH"]}').stdout == '/parameter_events\n/rosout\n'


def test_none_that_is_ours_counts_as_real(desk: Desk, real: Path) -> None:
    (real / 'ros2').write_text('#!/usr/bin/python\nfrom edulaunch.desk.machine.command import ros2\n')
    done = run(desk, 'topic', 'list', PATH=f'{real}{os.pathsep}{desk.env["PATH"]}', ROS_DISTRO='jazzy')
    assert done.stdout == '/parameter_events\n/rosout\n'


def test_edulaunch_ros2_always_means_ours(desk: Desk, real: Path) -> None:
    program = [sys.executable, '-m', 'edulaunch', 'ros2']
    done = run(desk, 'topic', 'list', program=program, PATH=f'{real}{os.pathsep}{desk.env["PATH"]}', ROS_DISTRO='jazzy')
    assert done.stdout == '/parameter_events\n/rosout\n'


def test_rosdep_is_the_real_one_or_the_verb(desk: Desk, real: Path) -> None:
    program = [sys.executable, '-c', 'import sys; from edulaunch.desk.cli.rosdep import command; sys.exit(command())']
    assert run(desk, 'check', program=program, PATH=str(real)).stdout == 'real rosdep check\n'
    assert 'edulaunch rosdep' in run(desk, '--help', program=program, PATH='').stdout


def test_exit_codes_and_streams_are_those_of_the_command(desk: Desk) -> None:
    done = run(desk, 'run', 'turtlesim', 'turtlesim_nod')
    assert (done.returncode, done.stdout) == (1, '') and "write 'turtlesim_node'" in done.stderr
    assert run(desk, 'nonsense').returncode == 2


def test_words_to_the_machine(desk: Desk) -> None:
    machine = [sys.executable, '-m', 'edulaunch', 'machine']
    done = run(desk, program=machine)
    assert done.returncode == 1 and 'no machine is running in ROS_DOMAIN_ID 0' in done.stderr
    talker = desk.ros2('run demo_nodes_py talker')
    talker.until('Publishing')
    assert 'terminal 1: ros2 run demo_nodes_py talker (2 programs)' in run(desk, 'status', program=machine).stdout
    assert run(desk, 'speed', '4', program=machine).stdout == 'speed: 4 simulated seconds per second\n'
    assert run(desk, 'speed', 'much', program=machine).returncode == 2
    assert 'time is paused' in run(desk, 'pause', program=machine).stdout
    assert 'paused' in run(desk, program=machine).stdout
    assert 'time continues' in run(desk, 'resume', program=machine).stdout
    assert run(desk, 'stop', program=machine).stdout == 'stopping the machine\n'
    assert talker.end() == 1


def test_each_domain_has_a_machine_of_its_own(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker', ROS_DOMAIN_ID='7').until('Publishing')
    assert desk.said('node list') == '' and desk.said('node list', ROS_DOMAIN_ID='7') == '/talker\n'


def test_of_many_that_come_first_one_starts_the_machine(desk: Desk) -> None:
    shells = [desk.ros2(f'run demo_nodes_py talker --ros-args -r __node:=talker_{number}') for number in range(6)]
    for shell in shells:
        shell.until('Publishing')
    assert desk.said('node list').split() == [f'/talker_{number}' for number in range(6)]
    assert len(list(desk.place.glob('0-*'))) == 1


pytest.importorskip('tornado')


def address(shell: Shell) -> str:
    shell.until(lambda output: re.search(r'the live view is at (http://\S+)\r?\n', output))
    found = re.search(r'the live view is at (http://\S+)', shell.output)
    assert found
    return found[1]


def page(url: str) -> str | None:
    """What is there; None when nobody serves it."""
    try:
        with urllib.request.urlopen(url, timeout=PATIENCE_S) as answer:
            return str(answer.read().decode())
    except urllib.error.URLError:
        return None


def test_a_launch_brings_its_page_which_goes_with_it(desk: Desk) -> None:
    shell = desk.ros2('launch turtlesim multisim.launch.py --view', BROWSER='true')
    url = address(shell)
    assert 'openDesk' in (page(url) or '')
    shell.until('Spawning turtle')
    shell.type('\x03')
    assert shell.end() == 0
    assert page(url) is None


def test_the_page_goes_when_the_terminal_is_killed(desk: Desk) -> None:
    shell = desk.ros2('launch turtlesim multisim.launch.py --view', BROWSER='true')
    url = address(shell)
    shell.send(signal.SIGKILL)
    shell.wait_for(lambda: page(url) is None)


def test_a_tool_with_a_window_is_the_page_at_its_tab(desk: Desk) -> None:
    shell = desk.ros2('run rqt_plot rqt_plot', BROWSER='true')
    assert 'tab: "plot"' in (page(address(shell)) or '')
    shell.type('\x03')
    assert shell.end() == 0


def test_the_shell_function_opens_it_too(desk: Desk) -> None:
    program = [sys.executable, '-m', 'edulaunch', 'env', '--answer']
    shell = Shell('rviz2', cwd=desk.folder, env={**desk.env, 'BROWSER': 'true'}, program=program)
    desk.shells.append(shell)
    assert 'tab: "frames"' in (page(address(shell)) or '')


@pytest.mark.parametrize(
    ('line', 'tab'),
    [
        ('launch a b --view', 'graph'),
        ('launch a b', None),
        ('topic list', None),
        ('run', None),
        ('run rviz2 rviz2', None),  # nobody sits at the terminal of a test
    ],
)
def test_who_wants_a_page(line: str, tab: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('os.isatty', lambda number: False)
    assert tab_of(line.split()) == tab


@pytest.mark.parametrize(
    ('line', 'tab'), [('run rviz2 rviz2', 'frames'), ('run rqt_graph rqt_graph', 'graph'), ('run rqtx x', None)]
)
def test_who_opens_a_window(line: str, tab: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('os.isatty', lambda number: True)
    assert tab_of(line.split()) == tab

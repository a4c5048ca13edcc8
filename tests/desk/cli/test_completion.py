"""`edulaunch completion`: what the Tab key offers."""

from __future__ import annotations

import shutil
import subprocess
import sys
from pathlib import Path

import pytest

from edulaunch.desk.cli.candidates import candidates
from edulaunch.desk.cli.completion import SCRIPTS
from edulaunch.desk.cli.main import main

FILE = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument

def generate_launch_description():
    return LaunchDescription([DeclareLaunchArgument('shape', default_value='round', choices=['round', 'square']),
                              DeclareLaunchArgument('size', default_value='1')])
"""


@pytest.fixture
def here(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    (tmp_path / 'my.launch.py').write_text(FILE)
    (tmp_path / 'notes.txt').write_text('')
    (tmp_path / 'maps').mkdir()
    monkeypatch.chdir(tmp_path)
    return tmp_path


@pytest.mark.parametrize(
    ('line', 'offered'),
    [
        ('edulaunch la', ['launch']),
        ('edulaunch launch turtles', ['turtlesim']),
        ('edulaunch launch turtlesim mult', ['multisim.launch.py']),
        ('edulaunch launch ./m', ['./maps/', './my.launch.py']),
        ('edulaunch launch --show-a', ['--show-all-subprocesses-output', '--show-args', '--show-arguments']),
        ('edulaunch launch my.launch.py ', ['shape:=', 'size:=']),
        ('edulaunch plan my.launch.py shape:=s', ['shape:=square']),
        ('edulaunch launch my.launch.py --seed 3 si', ['size:=']),
        ('edulaunch completion b', ['bash']),
        ('edulaunch launch --workspace m', ['maps/']),
        ('edulaunch course class --o', ['--out']),
        ('edugrade schema m', ['maps/', 'my.launch.py']),
        ('edulaunch nonsense ', []),
        ('edulaunch launch broken"', []),
    ],
)
def test_the_tab_key_offers(here: Path, line: str, offered: list[str]) -> None:
    assert candidates(line, break_words=False) == offered


def test_bash_gets_only_what_follows_the_sign_at_which_it_breaks_words(here: Path) -> None:
    assert candidates('edulaunch launch my.launch.py shape:=s', break_words=True) == ['square']


def test_a_launch_file_that_cannot_be_loaded_offers_nothing(here: Path) -> None:
    (here / 'my.launch.py').write_text('1 / 0')
    assert candidates('edulaunch launch my.launch.py ', break_words=False) == []


@pytest.mark.parametrize('shell', sorted(SCRIPTS))
def test_the_script_is_valid_for_its_shell(shell: str) -> None:
    if shutil.which(shell) is None:
        pytest.skip(f'{shell} is not installed')
    subprocess.run([shell, '-n'], input=SCRIPTS[shell], text=True, check=True)


def test_bash_completes_a_line_through_the_script(here: Path) -> None:
    program = here / 'edulaunch'
    program.write_text(f'#!/bin/sh\nexec {sys.executable} -m edulaunch "$@"\n')
    program.chmod(0o755)
    line = 'edulaunch launch my.launch.py sha'
    script = (
        f'PATH="{here}:$PATH"; {SCRIPTS["bash"]}\ncompopt() {{ :; }}\nCOMP_LINE="{line}"; COMP_POINT={len(line)}\n'
        '_edulaunch; printf "%s\\n" "${COMPREPLY[@]}"'
    )
    assert subprocess.run(['bash', '-c', script], text=True, capture_output=True, check=True).stdout == 'shape:=\n'


def test_the_script_is_what_the_command_prints(capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['completion', 'zsh']) == 0
    assert capsys.readouterr().out == SCRIPTS['zsh']


LISTS = {
    'topic list': ['/chatter', '/turtle1/cmd_vel', '/turtle1/pose'],
    'topic type /turtle1/cmd_vel': ['geometry_msgs/msg/Twist'],
    'node list': ['/sim'],
    'param list /sim': ['  background_b', '  background_g'],
    'service list': ['/spawn'],
    'interface list -m': ['Messages:', '    std_msgs/msg/String', '    std_msgs/msg/Empty'],
}


@pytest.mark.parametrize(
    ('line', 'offered'),
    [
        ('', ['topic', 'run', 'wtf']),
        ('topic ', ['echo', 'pub', 'list']),
        ('topic echo /tu', ['/turtle1/cmd_vel', '/turtle1/pose']),
        ('topic echo --once --qos-depth 3 /', ['/chatter']),
        ('topic echo --qos-reliability ', ['reliable', 'best_effort']),
        ('topic hz --w', ['--window', '--wall-time']),
        ('topic pub /turtle1/cmd_vel ', ['geometry_msgs/msg/Twist']),
        ('topic pub /new std', ['std_msgs/msg/String', 'std_msgs/msg/Empty']),
        ('param get /', ['/sim']),
        ('param set /sim ', ['background_b', 'background_g']),
        ('service call ', ['/spawn']),
        ('run turtles', ['turtlesim']),
        ('run turtlesim ', ['draw_square', 'mimic', 'turtle_teleop_key', 'turtlesim_node']),
        ('pkg xml ', ['turtlesim']),
        ('daemon ', ['start', 'status', 'stop']),
        ('nonsense ', []),
        ('topic nonsense ', []),
    ],
)
def test_ros2_offers_verbs_packages_and_what_is_on_the_machine(line: str, offered: list[str]) -> None:
    from edulaunch.desk.cli.candidates import ros2_candidates as ros2
    from edulaunch.engine.packages import Index

    *words, typed = line.split(' ')
    found = [word for word in ros2(words, typed, Index, lambda command: LISTS.get(command, [])) if word.startswith(typed)]
    assert [word for word in offered if word not in found] == []
    assert bool(found) == bool(offered)


@pytest.mark.parametrize('start', ['ros2', 'edulaunch ros2', '/some/where/ros2'])
def test_both_ways_to_type_ros2_are_completed(here: Path, start: str) -> None:
    assert candidates(f'{start} topic ec', break_words=False) == ['echo']
    assert candidates(f'{start} launch turtlesim mult', break_words=False) == ['multisim.launch.py']
    assert candidates(f'{start} launch --show-arg', break_words=False) == ['--show-args', '--show-arguments']


@pytest.mark.processes
def test_without_a_machine_there_are_no_names_to_offer(here: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (here / 'run').mkdir(mode=0o700)
    monkeypatch.setenv('XDG_RUNTIME_DIR', str(here / 'run'))
    assert candidates('ros2 topic echo ', break_words=False) == []

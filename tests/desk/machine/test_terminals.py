"""Several real terminals on one machine."""

from __future__ import annotations

import signal
import termios

import pytest

from tests.desk.machine.shells import Desk

UP = '\x1b[A'


def test_what_one_terminal_starts_the_others_see(desk: Desk) -> None:
    launch = desk.ros2('launch turtlesim multisim.launch.py')
    launch.until('[turtlesim_node-2]: process started with pid')
    assert desk.said('node list') == '/turtlesim1/turtlesim\n/turtlesim2/turtlesim\n'


def test_arrow_keys_drive_the_turtle(desk: Desk) -> None:
    desk.ros2('run turtlesim turtlesim_node').until('Spawning turtle [turtle1]')
    teleop = desk.ros2('run turtlesim turtle_teleop_key')
    teleop.until("'Q' to quit.")
    echo = desk.ros2('topic echo /turtle1/cmd_vel')
    while 'linear' not in echo.output:
        teleop.type(UP)
        echo.read(0.1)
    assert echo.until('---').replace('\r', '').startswith('linear:\n  x: 2.0\n')
    assert not teleop.mode() & (termios.ICANON | termios.ECHO)
    teleop.type('q')
    assert teleop.end() == 0
    assert teleop.mode() & termios.ICANON and teleop.mode() & termios.ECHO


def test_ctrl_c_reaches_the_programs_of_its_terminal_only(desk: Desk) -> None:
    launch = desk.ros2('launch turtlesim multisim.launch.py')
    other = desk.ros2('run demo_nodes_py talker')
    other.until('Publishing: "Hello World: 1"')
    launch.until('[turtlesim_node-2]: process started with pid')
    launch.type('\x03')
    launch.until('process has finished cleanly')
    assert launch.end() == 0
    before = other.output.count('Publishing')
    other.until(lambda output: output.count('Publishing') > before)
    assert desk.said('node list') == '/talker\n'


@pytest.mark.parametrize('signum', [signal.SIGKILL, signal.SIGHUP])
def test_a_closed_terminal_ends_its_programs(desk: Desk, signum: int) -> None:
    desk.ros2('run demo_nodes_py talker').until('Publishing')
    launch = desk.ros2('launch turtlesim multisim.launch.py')
    launch.until('[turtlesim_node-2]: process started with pid')
    launch.send(signum)
    launch.end()
    assert desk.said('node list') == '/talker\n'


def test_what_a_command_said_of_its_own_end_is_not_said_again(desk: Desk) -> None:
    launch = desk.ros2('launch turtlesim multisi.launch.py')
    assert launch.end() == 1
    assert launch.output.replace('\r', '').splitlines()[1:] == ["  help: did you mean 'multisim.launch.py'?"]


def test_a_launch_argument_that_nobody_reads_is_told_at_the_end(desk: Desk) -> None:
    launch = desk.ros2('launch turtle_tf2_py turtle_tf2_demo.launch.py targetframe:=turtle1')
    launch.until('Successfully spawned')
    launch.type('\x03')
    assert launch.end() == 0
    told = launch.output.replace('\r', '').partition('warning: ')[2]
    assert told.startswith("no launch file declares the argument 'targetframe', so its value has no effect (at ")
    assert told.endswith("  help: write 'target_frame:=' instead of 'targetframe:='\n")


def test_help_of_a_command_is_in_the_language_of_its_own_terminal(desk: Desk) -> None:
    desk.ros2('run demo_nodes_py talker', LC_ALL='de_DE.UTF-8').until('Publishing')
    english, german = (desk.said('run turtlesm turtlesim_node', LC_ALL=one) for one in ('en_US.UTF-8', 'de_DE.UTF-8'))
    assert 'help: the package turtlesm does not exist' in english and 'help: das Package turtlesm gibt es nicht' in german
    assert 'opens no window' not in english, 'nothing was started'


def test_mistakes_are_told_behind_the_end_in_the_language_of_the_terminal(desk: Desk) -> None:
    file = desk.folder / 'two.launch.py'
    file.write_text(
        'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\ndef generate_launch_description():\n'
        "    return LaunchDescription([Node(package='demo_nodes_py', executable='talker') for _ in 'ab'])\n"
    )
    launch = desk.ros2('launch two.launch.py')
    launch.until('process started with pid')
    launch.until('Publishing')
    launch.type('\x03')
    assert launch.end() == 0
    told = launch.output.replace('\r', '').partition('warning: ')[2]
    assert told.startswith('two nodes have the name /talker: one in talker-1 and one in talker-2 (two.launch.py:6, at ')
    silent = desk.ros2('launch --quiet two.launch.py')
    silent.until('Publishing')
    silent.type('\x03')
    assert silent.end() == 0 and 'warning: ' not in silent.output


def test_the_first_program_with_a_window_says_once_where_it_is_shown(desk: Desk) -> None:
    launch = desk.ros2('launch turtlesim multisim.launch.py')
    launch.until('note: turtlesim_node opens no window here; `edulaunch view --tab graph` shows it in a browser')
    other = desk.ros2('run turtlesim turtlesim_node')
    other.until('Spawning turtle [turtle1]')
    launch.until(lambda output: output.count('Spawning turtle') == 2)
    assert launch.output.count('opens no window') == 1 and 'opens no window' not in other.output


def test_a_launch_says_at_once_that_its_teleop_gets_no_keys(desk: Desk) -> None:
    (desk.folder / 'keys.launch.py').write_text(
        'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n\n\ndef generate_launch_description():\n'
        "    return LaunchDescription([Node(package='turtlesim', executable='turtle_teleop_key', output='screen')])\n"
    )
    launch = desk.ros2('launch keys.launch.py')
    launch.until(
        'note: turtle_teleop_key cannot read keys when a launch file starts it; type `ros2 run turtlesim turtle_teleop_key`'
    )
    launch.until("'Q' to quit.")
    assert launch.output.count('cannot read keys') == 1

"""One simulated machine behind a notebook."""

from __future__ import annotations

import signal
from typing import Any

import pytest

from edulaunch.errors import LaunchFileError, UnusableInput


def test_a_launch_prints_its_console_and_returns_the_recording(desk: Any) -> None:
    recording = desk.ros2('launch sim.launch.py --for 2')
    assert recording.duration_s == 2.0 and [node.name for node in recording.nodes] == ['/sim']
    assert desk.said[1] == '[INFO] [turtlesim_node-1]: process started with pid [1002]\n'


def test_further_commands_run_beside_what_still_runs(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('node list')
    assert desk.output == '/sim\n'
    desk.ros2('param get /sim background_r')
    assert desk.output == 'Integer value is: 30\n'
    desk.ros2('topic list')
    assert '/turtle1/pose\n' in desk.said or '/turtle1/pose' in desk.output.split()


def test_a_command_takes_only_the_simulated_time_that_it_needs(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('topic echo /turtle1/pose --once')
    assert desk.output.startswith('x: 5.54') and desk.terminal.recording().duration_s == pytest.approx(1.016, abs=0.02)


def test_ctrl_c_is_pressed_when_the_time_is_up(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('topic hz /turtle1/pose --for 3')
    assert desk.output.count('average rate: 62.5') == 2
    assert desk.terminal.recording().duration_s == 4.0
    assert '^C' not in desk.output


def test_without_a_time_the_terminal_says_that_it_pressed_ctrl_c(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('topic echo /turtle1/pose --field x')
    assert desk.said[-1] == '^C (edulaunch pressed it at t = 2.00 s; set the time with --for SECONDS)\n'


def test_tf_tools_run_in_the_same_machine(desk: Any) -> None:
    desk.ros2('launch turtle_tf2_py turtle_tf2_demo.launch.py --for 3')
    desk.ros2('run tf2_ros tf2_echo world turtle1 --for 2')
    assert '- Translation: [5.544, 5.544, 0.000]' in desk.output


def test_an_ampersand_leaves_the_program_running(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('run turtlesim draw_square &')
    assert desk.output == '[1]  1003  Running   ros2 run turtlesim draw_square\n'
    desk.ros2('topic echo /turtle1/cmd_vel --once')
    assert 'linear:' in desk.output
    desk.ros2('node list')
    assert desk.output == '/draw_square\n/sim\n'


def test_a_recording_is_a_snapshot(desk: Any) -> None:
    first = desk.ros2('launch sim.launch.py --for 1')
    before = (first.digest(), len(first.nodes))
    desk.ros2('run turtlesim draw_square --for 2')
    assert (first.digest(), len(first.nodes)) == before
    assert [node.name for node in desk.terminal.recording().nodes][:2] == ['/sim', '/draw_square']


def test_the_recording_of_a_launch_equals_that_of_the_command(desk: Any) -> None:
    import edulaunch

    assert desk.ros2('launch sim.launch.py --for 2').digest() == edulaunch.run('sim.launch.py', duration_s=2.0).digest()


def test_each_launch_starts_a_new_machine(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('node list')
    assert desk.output == '/sim\n'


def test_showing_arguments_starts_nothing(desk: Any) -> None:
    assert desk.ros2('launch turtlesim multisim.launch.py -s') is None
    assert desk.output.startswith('Arguments (pass arguments as')


def test_a_mistake_in_the_launch_file_is_told_with_file_and_line(desk: Any) -> None:
    desk.write('oops.launch.py', LAUNCH_OOPS)
    with pytest.raises(LaunchFileError) as caught:
        desk.ros2('launch oops.launch.py')
    assert f'at {desk.folder}/oops.launch.py:7' in str(caught.value)


LAUNCH_OOPS = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_nod'),
    ])
"""


@pytest.mark.parametrize(
    ('line', 'message'),
    [
        ('launch', 'no launch file is named'),
        ('topic echo "/x', 'cannot read this command: No closing quotation'),
        ('launch sim.launch.py --for soon', "--for needs a number from 0 to 1000000, not 'soon'"),
        ('launch sim.launch.py --for', "--for needs a number from 0 to 1000000, not 'nothing'"),
        ('launch simm.launch.py', "launch file 'simm.launch.py' does not exist."),
        ('launch sim.launch.py speed=3', "malformed launch argument 'speed=3', expected format '<name>:=<value>'"),
    ],
)
def test_unusable_words_are_explained(desk: Any, line: str, message: str) -> None:
    with pytest.raises(UnusableInput) as caught:
        desk.ros2(line)
    assert str(caught.value).startswith(message) and caught.value.help


def test_there_is_no_recording_before_anything_ran(desk: Any) -> None:
    with pytest.raises(UnusableInput, match='nothing has run yet'):
        desk.terminal.recording()


def press_at(desk: Any, second: float) -> None:
    """Let the person at the notebook press its interrupt button."""
    sim = desk.terminal.machine.session.sim
    sim.schedule(sim.now_ns + round(second * 1e9), lambda: signal.raise_signal(signal.SIGINT))


def test_the_interrupt_button_is_ctrl_c_for_the_command(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    press_at(desk, 1.5)
    desk.ros2('topic hz /turtle1/pose --for 3')
    assert desk.output.count('average rate: 62.5') == 1 and desk.said[-1] == '^C\n'
    assert desk.terminal.recording().duration_s == pytest.approx(2.5, abs=0.05)


def test_a_list_of_nothing_says_that_nothing_runs(desk: Any) -> None:
    desk.ros2('node list')
    assert desk.output.startswith('note: no program runs yet; start one with ')
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('node list')
    assert desk.output == '/sim\n'

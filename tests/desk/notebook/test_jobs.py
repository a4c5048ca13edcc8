"""What a notebook leaves running, and what a launch does to it."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.errors import LaunchFileError, UnusableInput


def nodes(desk: Any) -> list[str]:
    desk.ros2('node list')
    return str(desk.output).split()


def test_what_is_left_running_starts_at_once(desk: Any) -> None:
    desk.ros2('run demo_nodes_py talker &')
    assert desk.output == '[1]  1001  Running   ros2 run demo_nodes_py talker\n'
    desk.ros2('wait 3')
    assert 'Hello World: 2' in desk.output
    assert desk.terminal.recording().duration_s == 3.0


def test_a_launch_leaves_jobs_alone(desk: Any) -> None:
    desk.ros2('run demo_nodes_py talker &')
    recording = desk.ros2('launch sim.launch.py --for 2')
    assert '/sim' in nodes(desk) and '/talker' in nodes(desk)
    assert recording.duration_s == 2.0
    desk.ros2('launch sim.launch.py --for 1')
    assert sorted(nodes(desk)) == ['/sim', '/talker']  # what the cell before showed has ended, the job goes on


def test_a_launch_beside_a_job_says_so(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    assert 'still runs' not in ''.join(desk.said)
    desk.ros2('run demo_nodes_py talker &')
    desk.ros2('wait 3')
    desk.said.clear()
    desk.ros2('launch sim.launch.py --for 1')
    assert (
        'note: [1] ros2 run demo_nodes_py talker still runs, so this launch starts beside it at t = 4.00 s on the same machine\n'
        '  help: to compare runs, end it first: %ros2 stop 1\n'
    ) in ''.join(desk.said)


def test_launches_may_run_side_by_side(desk: Any) -> None:
    assert desk.ros2('launch sim.launch.py &') is None
    desk.ros2('launch turtlesim multisim.launch.py &')
    desk.ros2('wait 1')
    assert nodes(desk) == ['/sim', '/turtlesim1/turtlesim', '/turtlesim2/turtlesim']
    desk.ros2('jobs')
    assert [line.split()[0::2][1] for line in desk.output.splitlines()] == ['Running', 'Running']


def test_stop_presses_ctrl_c_and_tells_of_the_end(desk: Any) -> None:
    desk.ros2('launch sim.launch.py &')
    desk.ros2('run demo_nodes_py talker &')
    desk.ros2('stop 1')
    assert desk.said[-1].startswith('[1]  1001  Done') and nodes(desk) == ['/talker']
    desk.ros2('stop')
    assert nodes(desk) == []
    desk.ros2('jobs')
    assert desk.output == ''


def test_stop_ends_what_the_last_launch_left(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('stop')
    assert nodes(desk) == []


def test_a_mistake_does_not_destroy_the_running_machine(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    desk.write('oops.launch.py', 'def generate_launch_description(:\n')
    for line, error in (('launch simm.launch.py', UnusableInput), ('launch oops.launch.py', LaunchFileError)):
        with pytest.raises(error):
            desk.ros2(line)
        assert nodes(desk) == ['/sim']
    assert desk.terminal.recording().duration_s == 1.0


@pytest.mark.parametrize(
    ('line', 'message'), [('stop 3', 'there is no job 3'), ('wait', "wait needs a number from 0 to 1000000, not 'nothing'")]
)
def test_words_that_make_no_sense(desk: Any, line: str, message: str) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    with pytest.raises(UnusableInput, match=message):
        desk.ros2(line)


def test_commands_are_joined_as_in_a_shell(desk: Any) -> None:
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('topic list | grep pose')
    assert desk.output == '/turtle1/pose\n'
    desk.ros2('topic echo /turtle1/pose --field x > x.txt --for 0.1')
    assert (desk.folder / 'x.txt').read_text().startswith('5.54')
    desk.ros2('topic pub --once -w 0 /chatter std_msgs/msg/String "data: a | b > c; d & e"')
    assert "data='a | b > c; d & e'" in desk.output


def test_a_program_that_reads_keys_gets_a_keyboard(desk: Any) -> None:
    keyboards: list[Any] = []
    desk.terminal.machine.show_keyboard = lambda press, title: keyboards.append((press, title))
    desk.ros2('launch sim.launch.py --for 1')
    desk.ros2('run turtlesim turtle_teleop_key &')
    assert [title for _, title in keyboards] == ['ros2 run turtlesim turtle_teleop_key']
    before = desk.terminal.recording().duration_s
    keyboards[0][0]('\x1b[A')
    assert desk.terminal.recording().duration_s == before + 1.0
    desk.ros2('topic echo /turtle1/pose --once --field x')
    assert float(desk.output.split()[0]) > 7.4


def test_the_keyboard_is_buttons_and_a_line(desk: Any) -> None:
    widgets = pytest.importorskip('ipywidgets')
    from edulaunch.desk.notebook.interact import keyboard

    pressed: list[str] = []
    shown = keyboard(lambda keys: pressed.append(keys) or 'said', 'x')  # type: ignore[func-returns-value]
    *buttons, line = shown.children[1].children
    assert all(isinstance(button, widgets.Button) for button in buttons)
    for button in buttons:
        button.click()
    line.value = 'q'
    line.value = 'Ada'
    assert pressed == ['\x1b[A', '\x1b[B', '\x1b[D', '\x1b[C', 'q', 'Ada\n'] and line.value == ''


def test_a_line_may_hold_what_another_command_prints(desk: Any) -> None:
    desk.ros2('pkg xml $(ros2 pkg list | grep ^turtlesim) -t name')
    assert desk.output == 'turtlesim\n'

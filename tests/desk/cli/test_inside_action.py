"""`ros2 action ...` in the simulation."""

from __future__ import annotations

ROTATE = 'ros2 action send_goal /turtle1/rotate_absolute turtlesim/action/RotateAbsolute'


def test_list_type_and_info(machine) -> None:
    assert machine.read('ros2 action list -t') == '/turtle1/rotate_absolute [turtlesim/action/RotateAbsolute]\n'
    assert machine.read('ros2 action type /turtle1/rotate_absolute') == 'turtlesim/action/RotateAbsolute\n'
    assert machine.read('ros2 action info /turtle1/rotate_absolute') == (
        'Action: /turtle1/rotate_absolute\nAction clients: 0\nAction servers: 1\n    /sim\n'
    )


def test_send_goal_tells_its_story(machine) -> None:
    typed = machine.run(f"{ROTATE} '{{theta: 0.03}}' --feedback")
    lines = typed.out.splitlines()
    assert lines[:4] == ['Waiting for an action server to become available...', 'Sending goal:', '     theta: 0.03', '']
    assert lines[4].startswith('Goal accepted with ID: ') and len(lines[4].split()[-1]) == 32
    assert lines[6:8] == ['Feedback:', '    remaining: 0.029999999329447746']
    assert lines[-4:] == ['Result:', '    delta: -0.01600000075995922', '', 'Goal finished with status: SUCCEEDED']
    assert typed.code == 0


def test_ctrl_c_cancels_the_goal(machine) -> None:
    typed = machine.run(f"{ROTATE} '{{theta: 3}}'", 0.5)
    typed.interrupt()
    assert typed.out.endswith('Canceling goal...\nGoal canceled.\n')
    assert machine.turtlesim.err.endswith('Rotation goal canceled\n')


def test_ctrl_c_does_not_wait_for_a_dead_server(machine) -> None:
    typed = machine.run(f"{ROTATE} '{{theta: 3}}'", 0.5)
    machine.turtlesim.interrupt()
    typed.interrupt()
    assert (typed.code, typed.err) == (1, 'Failed to cancel goal\n')


def test_an_invalid_name_is_told_in_one_line(machine) -> None:
    assert machine.fails("ros2 action send_goal a//b turtlesim/action/RotateAbsolute '{}'") == (
        "Failed to create action client due to invalid topic name 'a//b' : topic name must not contain repeated '/'\n"
    )


def test_a_wrong_type_or_field_is_named(machine) -> None:
    assert machine.fails(ROTATE.replace('RotateA', 'Rotatea')) == (
        "The passed action type is invalid\n  help: did you mean 'turtlesim/action/RotateAbsolute'?\n"
    )
    assert machine.fails(f'{ROTATE} "{{angle: 1}}"').endswith(
        'help: the fields of turtlesim/action/RotateAbsolute_Goal are: theta\n'
    )

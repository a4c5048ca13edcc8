"""Did-you-mean."""

from __future__ import annotations

import pytest

from edulaunch.engine.nearest import nearest, nearest_few, nearest_file, nearest_name, nearest_spelling

NAMES = ['my_robot_bringup', 'my_robot_description', 'turtlesim']


@pytest.mark.parametrize(
    ('name', 'expected'),
    [
        ('turtelsim', 'turtlesim'),
        ('TurtleSim', 'turtlesim'),
        ('my-robot-bringup', 'my_robot_bringup'),
        ('my_robot_discription', 'my_robot_description'),
        ('nav2', None),
        ('', None),
    ],
)
def test_the_nearest_name_is_the_one_that_was_meant(name: str, expected: str | None) -> None:
    assert nearest(name, NAMES) == expected


def test_ties_go_to_the_alphabet_whatever_the_order_of_the_names() -> None:
    assert nearest('node_c', ['node_b', 'node_a']) == nearest('node_c', ['node_a', 'node_b'])


def test_several_that_are_close_come_with_the_nearest_first_and_one_that_is_meant_comes_alone() -> None:
    names = ['two_rooms', 'two_robots', 'two_robotss', 'radio']
    assert nearest_few('two_robot', names, 3) == ['two_robots', 'two_robotss', 'two_rooms']
    assert nearest_few('two_robot', names, 1) == ['two_robots']
    assert nearest_few('Two-Rooms', names, 3) == ['two_rooms']


@pytest.mark.parametrize(
    ('name', 'expected'),
    [
        ('cart.launch.py', None),
        ('colur.launch.py', 'colour.launch.py'),
        ('two.launch.pyy', 'two.launch.py'),
        ('two_launch.xml', 'two.launch.xml'),
        ('notes', 'notes.txt'),
        ('.hidden', None),
    ],
)
def test_files_are_alike_by_their_names_and_not_by_their_endings(name: str, expected: str | None) -> None:
    files = ['top.launch.py', 'colour.launch.py', 'two.launch.py', 'two.launch.xml', 'notes.txt', '.hidden.launch.py']
    assert nearest_file(name, files) == expected


@pytest.mark.parametrize(
    ('name', 'expected'),
    [('vision_msgs', None), ('sensor_msg', 'sensor_msgs'), ('Sensor-Msgs', 'sensor_msgs'), ('sensors_launch', None)],
)
def test_a_misspelt_package_is_near_and_another_one_is_not(name: str, expected: str | None) -> None:
    assert nearest_spelling(name, ['sensor_msgs', 'visualization_msgs']) == expected


def test_another_word_in_a_name_is_no_misspelling() -> None:
    assert nearest_spelling('color_qos', ['color_fps']) is None
    assert nearest_spelling('cmd_vle', ['cmd_vel']) == 'cmd_vel'


def test_a_full_name_means_only_a_name_with_the_same_last_part() -> None:
    assert nearest_name('/turtle1/cmd_vel', ['/red/turtle1/pose', '/turtle1/pose']) is None
    assert nearest_name('/turtle1/cmd_vel', ['/red/turtle1/pose', '/red/turtle1/cmd_vel']) == '/red/turtle1/cmd_vel'
    assert nearest_name('/chater', ['/chatter']) == '/chatter'

"""What a student reads after the mistakes that the lessons speak of."""

from __future__ import annotations

from collections.abc import Callable

import pytest

import edulaunch
from tests.lessons.notebook import Walk

Begin = Callable[[str], Walk]
PACKAGE = 'my_ws/src/learning_tf2_py/'


def launched(walk: Walk, file: str = 'turtle_tf2_demo.launch.py', **arguments: str) -> edulaunch.Recording:
    return edulaunch.run('learning_tf2_py', file, workspaces=[walk.folder / 'my_ws'], arguments=arguments, duration_s=2.5)


def third(walk: Begin) -> Walk:
    """Lesson 3, all files written."""
    student = walk('09_broadcaster_and_listener')
    student.run_all(until='your-turn-check')
    return student


def test_a_cell_out_of_order_says_which_name_is_missing(walk: Begin) -> None:
    with pytest.raises(NameError, match="name 'square' is not defined"):
        walk('01_first_launch').run('square-picture')


def test_a_later_lesson_needs_no_earlier_one(walk: Begin) -> None:
    student = walk('10_carrots')
    student.run('set-up')
    assert 'turtle2' in launched(student).frames_at(2.5)


def test_the_set_up_leaves_files_of_the_student_alone(walk: Begin) -> None:
    student = walk('10_carrots')
    student.write(PACKAGE + 'setup.py', 'mine')
    student.run('set-up')
    assert (student.folder / PACKAGE / 'setup.py').read_text() == 'mine'


def test_a_typo_in_an_executable_names_the_right_one(walk: Begin) -> None:
    student = walk('01_first_launch')
    student.run('oops')
    with pytest.raises(edulaunch.LaunchFileError) as failed:
        edulaunch.run(student.folder / 'my_launch' / 'oops.launch.py')
    assert 'oops.launch.py:7' in str(failed.value)
    assert failed.value.help == "the package 'turtlesim' has no executable named 'turtlesim_nod'; write 'turtlesim_node'"


def test_a_typo_in_a_frame_is_logged_once_a_second_and_nothing_dies(walk: Begin) -> None:
    recording = launched(third(walk), target_frame='turtel1')
    told = [(log.time_s, log.message) for log in recording.logs if log.logger == 'listener']
    text = 'Could not transform turtle2 to turtel1: "turtel1" passed to lookupTransform argument source_frame does not exist. '
    assert told == [(1.0, text), (2.0, text)]
    assert all(process.returncode is None for process in recording.processes if 'spawner' not in process.name)


def test_a_forgotten_entry_point_is_named(walk: Begin) -> None:
    student = third(walk)
    student.edit(PACKAGE + 'setup.py', "    'turtle_tf2_listener',\n", '')
    with pytest.raises(edulaunch.LaunchFileError) as failed:
        launched(student)
    assert 'setup.py does not install it as a program' in str(failed.value)


def test_a_typo_in_a_callback_ends_that_node_alone_and_says_where(walk: Begin) -> None:
    student = third(walk)
    student.edit(PACKAGE + 'learning_tf2_py/turtle_tf2_broadcaster.py', 'msg.theta', 'msg.Theta')
    recording = launched(student)
    died = [process.name for process in recording.processes if process.returncode == 1]
    text = ''.join(line.text for line in recording.output if line.process == died[0])
    assert died == ['turtle_tf2_broadcaster-4', 'turtle_tf2_broadcaster-5']
    assert 'turtle_tf2_broadcaster.py", line 20, in handle_turtle_pose' in text and 'help: write theta' in recording.warnings[0]
    assert 'edulaunch' not in text

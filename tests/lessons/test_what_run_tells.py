"""What a cell with `edulaunch.run` says when something went wrong in it: a program that died must not go unseen."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path

import pytest

import edulaunch
from tests.lessons.notebook import Walk

Begin = Callable[[str], Walk]
LISTENER = 'my_ws/src/learning_tf2_py/learning_tf2_py/turtle_tf2_listener.py'


def project(walk: Begin) -> Walk:
    """Lesson 5 with its two worlds."""
    student = walk('13_large_project')
    student.run_all(until='two-worlds-run')
    return student


def two_worlds(student: Walk) -> edulaunch.Recording:
    return edulaunch.run('launch_tutorial', 'two_worlds.launch.py', workspaces=[student.folder / 'my_ws'], duration_s=1.0)


def test_a_node_that_dies_is_told_with_its_line(walk: Begin, capsys: pytest.CaptureFixture[str]) -> None:
    student = walk('09_broadcaster_and_listener')
    student.run_all(until='your-turn-check')
    student.edit(LISTENER, 'goal.x, goal.y', 'goal.x, goal.yy')
    edulaunch.run('learning_tf2_py', 'turtle_tf2_demo.launch.py', workspaces=[student.folder / 'my_ws'], duration_s=2.5)
    assert capsys.readouterr().err == (
        'warning: Vector3 has no field yy; its fields are x, y, z (turtle_tf2_listener-6, '
        f'{student.folder / LISTENER}:20, at 1.00 s)\n  help: write y\n'
    )


@pytest.mark.parametrize(
    'old, new, told',
    [
        ('ros__parameters', 'ros_parameters', 'help: write ros__parameters, with two underscores'),
        ('    background_g', '   background_g', 'line 4 of turtlesim.yaml is not valid YAML: did not find expected key'),
        ('background_g: 86', 'background_g 86', "line 5 of turtlesim.yaml is not valid YAML: could not find expected ':'"),
    ],
)
def test_a_mistake_in_the_yaml_file_is_told(
    walk: Begin, capsys: pytest.CaptureFixture[str], old: str, new: str, told: str
) -> None:
    student = project(walk)
    student.edit('my_ws/src/launch_tutorial/config/turtlesim.yaml', old, new)
    two_worlds(student)
    err = capsys.readouterr().err
    assert told in err and err.startswith('warning: ') and 'turtlesim_node-2' in err
    assert f'{student.folder}/my_ws/src/launch_tutorial/config/turtlesim.yaml:' in err


def test_a_value_of_another_type_is_told_with_its_line(walk: Begin, capsys: pytest.CaptureFixture[str]) -> None:
    student = project(walk)
    file = 'my_ws/src/launch_tutorial/config/turtlesim.yaml'
    student.edit(file, 'background_g: 86', 'background_g: lots')
    two_worlds(student)
    assert capsys.readouterr().err == (
        "warning: the parameter 'background_g' of /turtlesim2/sim is of type integer, but this value is of type string: 'lots' "
        f'({student.folder / file}:4, at 0.00 s)\n  help: write a value of type integer\n'
    )


def test_a_run_without_a_mistake_says_nothing(walk: Begin, capsys: pytest.CaptureFixture[str]) -> None:
    two_worlds(project(walk))
    assert capsys.readouterr() == ('', '')


def launch_file(folder: Path, *lines: str) -> Path:
    file = folder / 'mine.launch.py'
    file.write_text(
        '\n'.join(
            [
                'from launch import LaunchDescription',
                'from launch.actions import GroupAction',
                'from launch.substitutions import EnvironmentVariable',
                'from launch_ros.actions import Node',
                'def generate_launch_description():',
                *(f'    {line}' for line in lines),
            ]
        ),
        encoding='utf-8',
    )
    return file


@pytest.mark.parametrize(
    'line, told',
    [
        (
            "return LaunchDescription([Node(package='turtlesim', excutable='draw_square')])",
            'Node needs the argument executable=; replace excutable= with executable=',
        ),
        (
            'return LaunchDescription([GroupAction(GroupAction([]), GroupAction([]))])',
            'GroupAction does not accept these arguments without names; put the arguments into one list: GroupAction([..., ...])',
        ),
        (
            "return LaunchDescription([Node(package='turtlesim', executable='mimic', name=EnvironmentVariable('USR'))])",
            "the environment variable 'USR' is not set; write 'USER' if you mean this name",
        ),
    ],
)
def test_help_for_mistakes_in_a_launch_file(tmp_path: Path, line: str, told: str) -> None:
    file = launch_file(tmp_path, line)
    with edulaunch.Session(env={'USER': 'student'}) as session:
        launch = session.launch(file)
        session.run(1.0)
        with pytest.raises(edulaunch.LaunchFileError) as failed:
            launch.raise_error()
    assert f'{file}:6' in str(failed.value) and failed.value.help == told


def test_a_launch_file_that_never_ends_is_an_error_with_its_line(tmp_path: Path) -> None:
    file = launch_file(tmp_path, 'while True:', '    pass')
    with edulaunch.Session(turn_limit_s=0.2) as session:
        launch = session.launch(file)
        session.run(1.0)
        with pytest.raises(
            edulaunch.LaunchFileError, match=r'never came to its end and was stopped\n  at .*mine.launch.py:[67]'
        ) as failed:
            launch.raise_error()
    assert failed.value.help is not None and 'a loop that does not end' in failed.value.help


def test_a_recording_asked_for_what_it_lacks_names_what_it_has(tmp_path: Path) -> None:
    recording = edulaunch.run(
        launch_file(
            tmp_path,
            "return LaunchDescription([Node(package='tf2_ros', executable='static_transform_publisher',",
            "    arguments=['--frame-id', 'tower', '--child-frame-id', 'thign'])])",
        ),
        duration_s=1.0,
    )
    with pytest.raises(KeyError) as failed:
        recording.frames_at(1.0)['thing']
    text = "NotRecorded: no tf frame 'thing' in this recording; there are: thign\n  help: did you mean 'thign'?"
    assert failed.value._render_traceback_() == [text]  # type: ignore[attr-defined]
    with pytest.raises(ValueError, match='nothing moved') as empty:
        recording.plot_turtles()
    assert len(empty.value._render_traceback_()) == 1  # type: ignore[attr-defined]

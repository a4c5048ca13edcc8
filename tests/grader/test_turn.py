"""A lesson's turn: its rubric beside the notebook, the same report and record as an exercise, never a traceback."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.library.called import call, defined
from edugrade.notebook import CheckReport, Note
from edugrade.progress_file import ProgressFile
from edugrade.turn import find_turn, grade_turn

from edulaunch import check

SIM = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{}])])
"""
WATER = """title: Red water
of: my_launch/water.launch.py
beside: [my_launch/water.yaml]
runs: [{name: run, duration: 1}]
checks:
  - {name: red, measured_parameter: {node: /sim, package: turtlesim, name: background_r, at_least: 200}, points: 2}
"""
PROGRAM = """title: A word
of: my_launch/word.py
launch: |
  from launch import LaunchDescription
  from launch.actions import ExecuteProcess
  def generate_launch_description():
      return LaunchDescription([ExecuteProcess(cmd=['python3', 'my_launch/word.py'])])
runs: [{name: run, duration: 1}]
checks:
  - {name: word, logs: {node: /word, pattern: '^hello$', example: hello}, points: 1}
"""
WORD = "import rclpy\n\nrclpy.init()\nrclpy.create_node('word').get_logger().info({})\n"


@pytest.fixture
def lessons(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Path:
    """A folder of lessons with three turns, as the current folder."""
    for name in ('checks', 'my_launch'):
        (tmp_path / name).mkdir()
    (tmp_path / 'checks' / 'water.yaml').write_text(WATER)
    (tmp_path / 'checks' / 'word.yaml').write_text(PROGRAM)
    (tmp_path / 'checks' / 'number.yaml').write_text(
        'title: N\nnames: [number]\nchecks: [{defined: {name: number, is: 3}, points: 1}]\n'
    )
    monkeypatch.chdir(tmp_path)
    return tmp_path


def statuses(name: str) -> list[str]:
    found = check(name)
    assert isinstance(found, CheckReport), found
    return [result.status for result in found.report.results]


@pytest.mark.parametrize(('value', 'status'), [('250', 'passed'), ('100', 'failed'), ("'250'", 'failed'), ('True', 'failed')])
def test_a_value_of_another_kind_is_a_failed_check(lessons: Path, value: str, status: str) -> None:
    text = SIM.replace('{}', f"{{'background_r': {value}}}")
    (lessons / 'my_launch' / 'water.launch.py').write_text(text)
    assert statuses('water') == ['passed', status]


def test_it_is_recorded_and_the_same_text_is_no_try(lessons: Path) -> None:
    (lessons / 'my_launch' / 'water.launch.py').write_text(SIM.replace('{}', "{'background_r': 3}"))
    check('water')
    assert 'has not changed since your last attempt' in repr(check('water'))
    (lessons / 'my_launch' / 'water.yaml').write_text('sim: {}')
    assert 'unchanged' not in repr(check('water'))
    assert (ProgressFile('.').of('water').attempts, ProgressFile('.').of('water').points) == (2, 2)


def test_a_launch_file_that_fails_is_told_without_a_traceback(lessons: Path) -> None:
    (lessons / 'my_launch' / 'water.launch.py').write_text('def generate_launch_description(:\n')
    found = check('water')
    assert isinstance(found, CheckReport)
    failed, not_run = found.report.results
    assert (failed.status, not_run.status) == ('failed', 'not_run')
    assert str(failed.where).endswith('water.launch.py:1') and failed.try_ == 'check this line and the line before it'


def test_a_file_that_is_not_there_is_a_note(lessons: Path) -> None:
    found = check('water')
    assert isinstance(found, Note) and 'run the cell that writes it' in repr(found)
    assert isinstance(check('water', hint=1), Note)


def test_a_program_is_started_by_the_launch_file_of_the_rubric(lessons: Path) -> None:
    (lessons / 'my_launch' / 'word.py').write_text(WORD.format("'hello'"))
    assert statuses('word') == ['passed', 'passed']
    (lessons / 'my_launch' / 'word.py').write_text(WORD.format('undefined'))
    assert statuses('word') == ['passed', 'failed']


def test_names_of_cells_are_looked_at(lessons: Path) -> None:
    path = find_turn('number')
    assert path is not None
    for names, passed in (({}, 0), ({'number': 4}, 0), ({'number': 3}, 1)):
        assert grade_turn('number', path, names).earned == passed
    exec("number = 3\nfound = check('number')", found := {'check': check})  # as a cell does
    assert found['found'].passed  # type: ignore[attr-defined]


def test_a_mistake_in_a_rubric_is_a_note(lessons: Path) -> None:
    (lessons / 'checks' / 'number.yaml').write_text('title: N\nnames: [number]\nchecks: [{what: {}}]\n')
    assert 'checks/number.yaml:3: a check has no what' in repr(check('number'))


def test_what_a_student_calls_may_raise_anything() -> None:
    from edugrade import Failure

    assert call('abs', abs, -3, wanted=3) == 3
    for function, given in ((abs, ('a',)), (None, ()), (abs, (4,))):
        with pytest.raises(Failure):
            call('it', function, *given, wanted=3)
    with pytest.raises(Failure, match='three is missing'):
        defined(type('Run', (), {'names': {'four': 4}})(), 'three')  # type: ignore[arg-type]


def test_a_launch_that_starts_nothing_is_judged_by_the_checks(lessons: Path) -> None:
    empty = 'from launch import LaunchDescription\n\n\ndef generate_launch_description():\n    return LaunchDescription([])\n'
    (lessons / 'my_launch' / 'water.launch.py').write_text(empty)
    assert statuses('water') == ['passed', 'failed']

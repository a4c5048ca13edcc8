"""Programs of edulaunch can begin late by a time that the submission does not know."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade import Scenario
from edugrade.rubrics.yaml_rubric import read_yaml_rubric
from edugrade.runner import Runner
from edugrade.submission import Submission

LAUNCH = """import gc
from launch import LaunchDescription
from launch.actions import LogInfo, TimerAction
from launch_ros.actions import Node

known = [name for each in gc.get_objects() if type(each) is dict and 'wall_s' in each for name in each]


def talker(name):
    return Node(package='demo_nodes_py', executable='talker', namespace=name)


def generate_launch_description():
    return LaunchDescription([
        LogInfo(msg='known: ' + ' '.join(known)), talker('a'), talker('b'), TimerAction(period=2.0, actions=[talker('c')]),
    ])
"""


@pytest.mark.processes
def test_programs_that_start_at_once_begin_late_and_the_submission_cannot_know_it(tmp_path: Path) -> None:
    file = tmp_path / 'a.launch.py'
    file.write_text(LAUNCH)
    with Runner(processors=1) as runner:
        (outcome,) = runner.wait(runner.add(Submission(str(file)), [Scenario('s', {}, 4.0, 7, late_s=0.4)]))
    assert outcome.recording is not None, outcome.text
    first = {name: next(iter(outcome.recording.messages(f'/{name}/chatter')))[0] for name in 'abc'}
    assert first == pytest.approx({'a': 1.4, 'b': 1.8, 'c': 3.0}, abs=0.05)
    said = ' '.join(item.text for item in outcome.recording.output)
    assert 'duration_s' in said and 'late' not in said


def test_a_rubric_chooses_the_time() -> None:
    text = """title: A
runs:
  - {name: one, late: {between: [0.3, 0.7], decimals: 2}}
  - {name: two}
checks:
  - {name: lives, alive: {}}
"""
    rubric = read_yaml_rubric('a.yaml', text.encode())
    times = [[run.late_s for run in rubric.scenarios(seed)] for seed in range(20)]
    assert all(0.3 <= one <= 0.7 and two == 0.0 for one, two in times)
    assert len({one for one, _ in times}) > 5

"""What a submission cannot know: programs that begin late or cannot start, and a message that the grader sends."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from random import Random

import pytest
from edugrade import Scenario
from edugrade.job import Limits, RunRequest
from edugrade.rubric import RubricMistake
from edugrade.rubrics.yaml_rubric import read_yaml_rubric
from edugrade.runner import Runner
from edugrade.submission import Submission

LAUNCH = """import gc, sys
from launch import LaunchDescription
from launch.actions import ExecuteProcess, LogInfo, TimerAction
from launch_ros.actions import Node

known = [repr(vars(each)) for each in gc.get_objects() if type(each).__name__ == 'TrustedPeer']
known += [repr(each) for each in gc.get_objects() if type(each) is dict and 'wall_s' in each]
frame = sys._getframe()
while frame:
    known += [repr(value) for value in frame.f_locals.values() if type(value) is dict]
    frame = frame.f_back


def talker(name):
    return Node(package='demo_nodes_py', executable='talker', namespace=name)


def generate_launch_description():
    return LaunchDescription([
        LogInfo(msg='known: ' + ' '.join(known)), talker('a'), talker('b'),
        Node(package='turtlesim', executable='turtlesim_node'), TimerAction(period=2.0, actions=[talker('c')]),
        ExecuteProcess(cmd=['ros2', 'topic', 'echo', '/words', 'std_msgs/msg/String']),
    ])
"""
SCENARIO = Scenario(
    's', {}, 6.0, 7, late={'talker': 0.4375}, sent={'/words': (2.5, 'zubaqe')}, turned={'/turtle1': (3.0, 1.0625)}
)


@pytest.mark.processes
def test_programs_begin_late_and_a_message_comes_and_the_submission_cannot_know_it(tmp_path: Path) -> None:
    file = tmp_path / 'a.launch.py'
    file.write_text(LAUNCH)
    with Runner(processors=1) as runner:
        (outcome,) = runner.wait(runner.add(Submission(str(file)), [SCENARIO]))
    assert outcome.recording is not None, outcome.text
    first = {name: next(iter(outcome.recording.messages(f'/{name}/chatter')))[0] for name in 'abc'}
    assert first == pytest.approx({'a': 1.4375, 'b': 1.875, 'c': 4.3125}, abs=0.05)
    said = [(item.time_s, item.text) for item in outcome.recording.output]
    heard = [time_s for time_s, text in said if 'data: zubaqe' in text]
    assert heard == pytest.approx([2.5], abs=0.05)
    angles = dict(outcome.recording.series('/turtle1/pose', 'theta'))
    assert {theta for time_s, theta in angles.items() if time_s < 2.95} == {0.0}
    assert {theta for time_s, theta in angles.items() if time_s > 3.05} == {1.0625}
    known = ' '.join(text for _, text in said if 'known: ' in text)
    assert 'duration_s' in known and not any(hidden in known for hidden in ('0.4375', 'zubaqe', '1.0625'))


VAIN = """from launch import LaunchDescription
from launch.actions import ExecuteProcess, LogInfo, RegisterEventHandler
from launch.event_handlers import OnProcessStart
from launch_ros.actions import Node


def generate_launch_description():
    found = []
    for name, first in (
        ('sim', Node(package='turtlesim', executable='turtlesim_node')),
        ('other', Node(package='turtlesim', executable='turtlesim_node', name='other')),
        ('list', ExecuteProcess(cmd=['ros2', 'topic', 'list'])),
        ('types', ExecuteProcess(cmd=['ros2', 'topic', 'list', '-t'])),
        ('real', ExecuteProcess(cmd=['echo', 'real'])),
    ):
        found += [RegisterEventHandler(OnProcessStart(target_action=first, on_start=[LogInfo(msg=f'after {name}')])), first]
    return LaunchDescription(found)
"""


@pytest.mark.processes
@pytest.mark.parametrize(
    ('fails', 'begun'),
    [
        ((), ['sim', 'other', 'list', 'types', 'real']),
        (('turtlesim_node',), ['other', 'list', 'types', 'real']),
        (('ros2 topic list',), ['sim', 'other', 'types', 'real']),
        (('ros2 topic list -t', 'turtlesim_node'), ['other', 'list', 'real']),
    ],
)
def test_nothing_follows_the_first_start_of_a_program_that_cannot_start(
    tmp_path: Path, fails: tuple[str, ...], begun: list[str]
) -> None:
    file = tmp_path / 'a.launch.py'
    file.write_text(VAIN)
    with Runner(processors=1) as runner:
        (outcome,) = runner.wait(runner.add(Submission(str(file)), [Scenario('s', {}, 2.0, 7, fails=fails)]))
    assert outcome.recording is not None, outcome.text
    text = ''.join(item.text for item in outcome.recording.output)
    assert [name for name in ('sim', 'other', 'list', 'types', 'real') if f'after {name}\n' in text] == begun
    assert text.count('exception occurred while executing process:\nBlockingIOError') == len(fails)


def test_what_is_hidden_is_not_in_the_message_to_the_process_that_reads_the_submission(tmp_path: Path) -> None:
    (tmp_path / 'a.launch.py').write_text(LAUNCH)
    message = RunRequest(Submission(str(tmp_path / 'a.launch.py')), SCENARIO, Limits(), [], str(tmp_path)).message
    assert not any(hidden in json.dumps(message) for hidden in ('0.4375', 'zubaqe', '1.0625'))


RUBRIC = """title: A
runs:
  - {name: one, arguments: {room: {word: 3}}, late: {talker: {between: [0.3, 0.7], decimals: 2}}, sends: {/$(arg room)/words: {word: 3}}}
  - {name: two, sends: {/words: {word: 2, at: {between: [0.5, 1.5]}}}, turns: {turtle1: {between: [1.0, 2.0]}}}
checks:
  - {name: lives, alive: {}}
"""


def scenarios() -> Iterator[tuple[Scenario, Scenario]]:
    rubric = read_yaml_rubric('a.yaml', RUBRIC.encode())
    for seed in range(20):
        one, two = rubric.scenarios(Random(seed).getrandbits(31))
        yield one, two


def test_a_rubric_chooses_the_times_and_the_words() -> None:
    found = list(scenarios())
    assert all(0.3 <= one.late['talker'] <= 0.7 and not two.late and not one.turned for one, two in found)
    assert len({one.late['talker'] for one, _ in found}) > 5
    assert all([*one.sent] == [f'/{one.arguments["room"]}/words'] for one, _ in found)
    assert len({value for one, _ in found for value in one.sent.values()}) == 20
    assert all(8.0 <= time_s <= 10.0 for one, _ in found for time_s, _ in one.sent.values())


def test_the_words_of_a_run_name_what_cannot_start_and_a_rubric_lists_it() -> None:
    text = RUBRIC.replace('{name: two,', '{name: two, fails: [talker, ros2 bag record],')
    _, two = read_yaml_rubric('a.yaml', text.encode()).scenarios(0)
    assert two.words == 'no arguments and a talker that cannot start and a ros2 bag record that cannot start'
    assert two.hidden['fails'] == ['talker', 'ros2 bag record']
    with pytest.raises(RubricMistake, match=r"a.yaml:4: fails is 'talker'; write a list of executables"):
        read_yaml_rubric('a.yaml', text.replace('[talker, ros2 bag record]', 'talker').encode())


def test_a_topic_names_an_argument_of_its_run() -> None:
    with pytest.raises(RubricMistake, match=r'a.yaml:3: the run one has no argument house'):
        read_yaml_rubric('a.yaml', RUBRIC.replace('$(arg room)', '$(arg house)').encode())


def test_a_rubric_limits_the_time_of_a_message_and_chooses_a_turn() -> None:
    found = list(scenarios())
    assert all(0.5 <= two.sent['/words'][0] <= 1.5 and len(two.sent['/words'][1]) == 4 for _, two in found)
    assert len({two.sent['/words'][0] for _, two in found}) > 5
    assert all(8.0 <= two.turned['/turtle1'][0] <= 10.0 and 1.0 <= two.turned['/turtle1'][1] <= 2.0 for _, two in found)

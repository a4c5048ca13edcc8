"""Findings in order, none of them twice, and a rule that fails ends nobody's run."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch
from edulaunch.advice import Failure, Rule, judge, judge_failure, judging, rendered
from edulaunch.advice.judging import in_order
from edulaunch.advice.reader import Reader
from edulaunch.advice.rendering import warning_lines
from edulaunch.advice.rule import Finding, found, rule
from tests.advice.harness import EXAMPLES

ENGLISH = Reader()


def of(name: str, subject: str = '/a', time_s: float | None = None, **facts: object) -> Finding:
    return found('node', subject, time_s=time_s, **facts)._replace(rule=name)


def test_the_worst_comes_first_and_then_what_was_first() -> None:
    findings = [
        of('programs.interrupted', time_s=0.1),
        of('programs.same-name', '/b', 3.0),
        of('programs.same-name', '/a', 2.0),
        of('programs.died', time_s=9.0),
    ]
    assert [(one.rule, one.name) for one in in_order(findings)] == [
        ('programs.died', '/a'),
        ('programs.same-name', '/a'),
        ('programs.same-name', '/b'),
        ('programs.interrupted', '/a'),
    ]


def test_nothing_is_found_twice_in_one_place() -> None:
    findings = [of('programs.same-name', time_s=2.0), of('programs.same-name', time_s=1.0)]
    assert [one.time_s for one in in_order(findings)] == [1.0]


def test_a_rule_that_fails_is_told_and_the_others_are_heard(monkeypatch: pytest.MonkeyPatch) -> None:
    @rule('launch.broken', what='-', do='-')
    def broken(failure: Failure) -> list[Finding]:
        raise KeyError('x')

    from edulaunch.advice import judging

    rules: tuple[Rule, ...] = (broken, *judging.rules_over('errors'))
    monkeypatch.setattr(judging, 'rules_over', lambda kind: rules)
    error = TypeError("Expected <class 'std_msgs.msg._string.String'>, got <class 'str'>")
    findings = judge_failure(error)
    assert [one.rule for one in findings] == ['messages.published-no-message', 'programs.rule-failed']
    assert "the rule 'launch.broken' of edulaunch failed: KeyError: 'x'" in rendered(findings[1], ENGLISH).what


def test_a_death_that_another_rule_explains_is_not_told_beside_it() -> None:
    file = EXAMPLES / 'messages.published-no-message' / 'failing.py'
    recording = edulaunch.run(EXAMPLES / 'program.launch.py', arguments={'file': file}, console=lambda *_: None)
    assert [one.rule for one in recording.advice] == ['messages.published-no-message']
    assert recording.advice[0].process == 'python3-1' and str(file) in str(recording.advice[0].file)
    assert recording.warnings == [str(rendered(recording.advice[0]))]


def test_a_recording_from_a_file_is_judged_alike(tmp_path: Path) -> None:
    recording = edulaunch.run(EXAMPLES / 'programs.same-name' / 'failing.launch.py', duration_s=1.0)
    recording.save(tmp_path / 'a.rec')
    assert judge(edulaunch.Recording.load(tmp_path / 'a.rec')) == recording.advice != []


def test_lines_are_few_and_say_how_many_more_there_are() -> None:
    findings = [of('programs.same-name', f'/n{number}', first='a', second='b', other='n_2') for number in range(8)]
    lines = warning_lines(findings, ENGLISH)
    assert len(lines) == 6 and lines[-1] == 'and 3 more'
    assert lines[0].splitlines() == [
        'warning: two nodes have the name /n0: one in a and one in b',
        "  help: rename one of them, for example with name='n_2' in the launch file, or use another namespace",
    ]


def test_the_recording_is_the_same_in_every_language(monkeypatch: pytest.MonkeyPatch) -> None:
    file = EXAMPLES / 'programs.died' / 'failing.py'
    digests, said = set(), set()
    for language in ('', 'de'):
        monkeypatch.setenv('EDULAUNCH_LANG', language)
        recording = edulaunch.run(EXAMPLES / 'program.launch.py', arguments={'file': file}, console=lambda *_: None)
        digests.add(recording.digest())
        said.add(recording.warnings[0])
    assert (len(digests), len(said)) == (1, 2)


LISTENER = """
import rclpy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('ear')
node.create_subscription(String, 'words', print, 10)
rclpy.spin(node)
"""


@pytest.mark.parametrize(
    ('other', 'rules'),
    [
        ('pass', {'messages.nobody-publishes'}),
        ('import gazebo_msgs.msg', {'packages.absent-module'}),
        ('raise SystemExit(3)', {'programs.died'}),
    ],
)
def test_nobody_is_missed_where_a_program_could_not_run(tmp_path: Path, other: str, rules: set[str]) -> None:
    (tmp_path / 'ear.py').write_text(LISTENER)
    (tmp_path / 'other.py').write_text(other)
    path = tmp_path / 'a.launch.py'
    path.write_text(
        'from launch import LaunchDescription\nfrom launch.actions import ExecuteProcess\n'
        'def generate_launch_description():\n'
        f'    files = [{str(tmp_path / "ear.py")!r}, {str(tmp_path / "other.py")!r}]\n'
        "    return LaunchDescription([ExecuteProcess(cmd=['python3', file]) for file in files])\n"
    )
    recording = edulaunch.run(path, duration_s=3.0, console=lambda *_: None)
    assert {finding.rule for finding in judge(recording)} == rules


def test_a_launch_file_is_judged_once_until_it_changes(tmp_path: Path) -> None:
    path = tmp_path / 'a.launch.py'
    body = 'def generate_launch_description():\n    left = Node(package="turtlesim", executable="mimic")\n    return LaunchDescription([{}])\n'
    head = 'from launch import LaunchDescription\nfrom launch_ros.actions import Node\n'
    counts = []
    for listed in ('', None, 'left'):
        if listed is not None:
            path.write_text(head + body.format(listed))
        recording = edulaunch.run(path, duration_s=1.0, console=lambda *_: None)
        before = judging.of_scripts.cache_info().misses
        counts.append(([one.rule for one in judge(recording)][:1], judging.of_scripts.cache_info().misses - before))
    assert [count for _, count in counts] == [1, 0, 1]
    assert [rules for rules, _ in counts[:2]] == [['launch.not-added']] * 2 and counts[2][0] != ['launch.not-added']


def test_a_note_that_explains_a_failure_stands_in_its_place() -> None:
    from edulaunch.advice.judging import judge_plan
    from edulaunch.advice.plan import rehearse
    from edulaunch.runtime.session import Session
    from tests.advice.harness import EXAMPLES

    example = str(EXAMPLES / 'launch.program-absent' / 'failing.launch.py')
    with Session() as session:
        found = judge_plan(rehearse(example, {}, session.index, session.host.env))
    assert [one.rule for one in found] == ['launch.program-absent']

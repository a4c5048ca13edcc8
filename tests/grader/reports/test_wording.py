"""Paths in a report are short, and the same wherever it was made.

Advice grows: the kind of thing, the thing, how it is written. A stub's report never has the answer.
"""

from __future__ import annotations

import re
from dataclasses import replace
from pathlib import Path

import made_report
import pytest
from edugrade import Evidence, Scenario
from edugrade.attempts import UNCHANGED, progress_folder, record_attempt
from edugrade.cli import main
from edugrade.evidence import Failure
from edugrade.progress_file import ProgressFile
from edugrade.reports.terminal import render
from edugrade.reports.wording import ALL, KIND, THING, ShortPaths, at_level, level_of
from edugrade.results import CheckResult
from edugrade.rubrics.yaml_rubric import read_yaml_rubric
from edugrade.source import Place, is_engine, is_shipped
from edugrade.submission import Submission
from fake_recording import FakeRecording

import edulaunch
from edulaunch.advice.rule import Finding

ENGINE = str(Path(edulaunch.__file__).parent)
IMAGE = '/tmp/x/edulaunch-0/robot-0123abcd/share/'


def test_the_submissions_folder_is_shown_as_it_was_given() -> None:
    paths = ShortPaths('/home/me/work', 'work/')
    assert paths.text('at /home/me/work/a.launch.py:3') == 'at work/a.launch.py:3'
    assert paths.text('at /home/me/workshop/a.py') == 'at /home/me/workshop/a.py'


def test_the_engines_folder_is_shown_by_its_name() -> None:
    assert ShortPaths('/w').text(f'{ENGINE}/ros/share/x') == 'edulaunch/ros/share/x'


def test_an_installed_file_of_the_package_is_shown_as_its_source() -> None:
    paths = ShortPaths('/w/robot', 'robot/', 'robot')
    assert paths.place(Place(f'{IMAGE}robot/launch/a.launch.py', 3)) == ('robot/launch/a.launch.py', 3)
    assert paths.text(f"cannot read '{IMAGE}robot/b'") == "cannot read 'robot/b'"
    assert paths.text(f'no value ({IMAGE}robot/b:5)') == 'no value (robot/b:5)'


def test_an_installed_file_of_another_package_is_named_after_it() -> None:
    assert ShortPaths('/w').text(f'{IMAGE}other/c.yaml') == 'other/c.yaml'


def test_all_texts_of_a_result_are_shortened() -> None:
    result = CheckResult('n', 's', 'failed', 1, (), '/w/a', '/w/b', '/w/c', Place('/w/d', 1), '/w/e')
    short = ShortPaths('/w').result(result)
    assert (short.reason, short.expected, short.seen, short.where, short.try_) == ('a', 'b', 'c', ('d', 1), 'e')
    assert ShortPaths('/w').result(CheckResult('n', 's', 'passed')).where is None


def test_shipped_launch_files_are_not_the_engine() -> None:
    assert (is_engine(f'{ENGINE}/session.py'), is_shipped(f'{ENGINE}/session.py')) == (True, True)
    shared = f'{ENGINE}/ros/share/turtlesim/launch/multisim.launch.py'
    assert (is_engine(shared), is_shipped(shared)) == (False, True)
    assert is_shipped('/student/a.launch.py') is False


ROOT = Path(__file__).resolve().parents[3]
LINE = re.compile(r'\w+=\[|\w+=\'|\w+=LaunchConfiguration|[A-Z]\w+\(')


def failed(try_: str, reason: str = 'the node /a is missing') -> CheckResult:
    return CheckResult('a', 'There is an a', 'failed', 1, (), reason, try_=try_)


@pytest.mark.parametrize(
    ('try_', 'kind', 'thing'),
    [
        (
            "add DeclareLaunchArgument('r', default_value='1')",
            'add a DeclareLaunchArgument to the launch file',
            'add DeclareLaunchArgument(...)',
        ),
        (
            "add parameters=[{'radius': LaunchConfiguration('r')}] to the Node",
            'write the missing parameter into the parameters of this Node, or correct its name there',
            'add parameters=[...] to the Node',
        ),
        (
            'write this namespace and name in the Node of turtlesim',
            'add a node with a namespace',
            'write this namespace and name in the Node of turtlesim',
        ),
        (
            "add launch_arguments={'target_frame': 'carrot1'}.items() to IncludeLaunchDescription(...)",
            'add an IncludeLaunchDescription to the launch file',
            'add launch_arguments={...}.items() to IncludeLaunchDescription(...)',
        ),
        ('write default="kitchen"', 'add a DeclareLaunchArgument to the launch file', 'write default="..."'),
        ('write "/a" instead of "/b"', 'compare the names letter by letter with the task', None),
    ],
)
def test_one_advice_has_three_steps(try_: str, kind: str, thing: str | None) -> None:
    result = failed(try_)
    assert [at_level(result, level).try_ for level in (KIND, THING, ALL)] == [kind, thing or try_, try_]


def test_only_an_existing_thing_can_be_corrected() -> None:
    result = replace(failed("add DeclareLaunchArgument('r', default_value='1')"), seen='radius')
    words = 'add a DeclareLaunchArgument to the launch file, or check the name and the default value of the launch argument'
    assert at_level(result, KIND).try_ == words


def test_a_rubric_may_say_the_steps_itself() -> None:
    failure = Failure('no', try_=['a frame', 'the frame laser', '--child-frame-id laser'])
    result = replace(failed(''), try_=failure.try_, steps=failure.steps)
    assert [at_level(result, level).try_ for level in (KIND, THING, ALL)] == [
        'check a frame',
        'check the frame laser',
        '--child-frame-id laser',
    ]


def test_a_yaml_rubric_may_say_them_too() -> None:
    text = b"""title: T
runs: [{name: one}]
checks:
  - {name: a, argument: {name: speed}, try: [an argument, the argument speed, "DeclareLaunchArgument('speed')"]}
"""
    check = read_yaml_rubric('t.yaml', text).checks[0]
    scenario = Scenario('one')
    source = Submission(str(ROOT / 'exercises/circle.launch.py')).source
    with pytest.raises(Failure) as caught:
        check(Evidence({'one': scenario}, {'one': FakeRecording()}, source))  # type: ignore[dict-item]
    assert caught.value.steps == ('an argument', 'the argument speed')


def test_it_takes_tries_or_hints_and_never_counts_for_what_was_tried_first() -> None:
    assert [level_of(tries, [], False) for tries in (1, 2, 3, 4)] == [KIND, THING, THING, ALL]
    assert level_of(1, [2], False) == THING and level_of(1, [1, 3], False) == ALL
    assert level_of(9, [3], True) == KIND


def test_a_file_that_does_not_run_says_at_once_what_is_wrong() -> None:
    result = replace(failed('close the bracket'), name='launches')
    assert at_level(result, KIND).try_ == 'close the bracket'


def test_the_same_text_twice_is_no_try(tmp_path: Path) -> None:
    report = made_report.report(made_report.FAILED)
    first, second = record_attempt(report, str(tmp_path)), record_attempt(report, str(tmp_path))
    assert (first.word, first.level) == ('', KIND) and (second.word, second.level) == (UNCHANGED, KIND)
    assert UNCHANGED in render(second)
    changed = replace(report, sha256='beef')
    assert (record_attempt(changed, str(tmp_path)).word, record_attempt(changed, str(tmp_path)).level) == ('', THING)
    assert ProgressFile(str(tmp_path)).of(report.rubric).attempts == 2


def test_nothing_is_kept_of_what_lies_outside_of_the_exercises_of_a_course(tmp_path: Path) -> None:
    for name in ('exercises', 'solutions', 'lessons'):
        (tmp_path / name).mkdir()
    (tmp_path / 'course.toml').touch()
    assert progress_folder(str(tmp_path / 'exercises' / 'a.launch.py')) == str(tmp_path / 'lessons')
    assert progress_folder(str(tmp_path / 'exercises' / 'pkg' / 'launch' / 'pkg.launch.py')) == str(tmp_path / 'lessons')
    assert progress_folder(str(tmp_path / 'solutions' / 'a.launch.py')) is None


@pytest.mark.processes
def test_no_report_on_a_stub_has_a_line_of_its_solution(capsys: pytest.CaptureFixture[str]) -> None:
    stubs = sorted(
        str(path) for path in (ROOT / 'exercises').iterdir() if path.suffix != '.toml' and not path.name.startswith(('.', '_'))
    )
    assert main([*stubs, '--sandbox', 'off']) == 1
    told = capsys.readouterr().out
    advice = re.findall(r'try:((?:.*\n)(?: {19}.*\n)*)', told)
    assert len(advice) >= len(stubs)
    assert [text for text in advice if LINE.search(text)] == []
    causes = re.findall(r'cause:((?:.*\n)(?: {19}.*\n)*)', told)
    assert [text for text in causes if LINE.search(text)] == [], 'what Python says of a program that ended is no answer'


def test_a_cause_that_ended_a_program_replaces_the_general_advice_on_its_death() -> None:
    cause = Finding('process', 'go-1', {'entry': 'go = robo.go:mian'}, None, None, None, 'packages.entry-function', 'go-1')
    died = replace(failed('check the arguments', reason='go-1 died after 0.0 s with exit code 1'), cause=cause)
    assert [at_level(died, level).try_ for level in (KIND, THING, ALL)] == ['correct the mistake that the cause names'] * 2 + [
        'make the change that the cause describes'
    ]

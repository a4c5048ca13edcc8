"""Runs without an argument: they show its default, and a default that is wrong or not there costs its own points only."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade import Scenario
from edugrade.bare_runs import with_defaults_given
from edugrade.evidence import Outcome
from edugrade.grading import grade, plan_work
from edugrade.rubrics.yaml_rubric import read_yaml_rubric
from edugrade.submission import Submission
from fake_recording import FILE, FakeRecording

from edulaunch.engine.recording.records import DeclaredArgument, LaunchRecord

ROOT = Path(__file__).resolve().parents[2]
CIRCLE = (ROOT / 'solutions' / 'circle.launch.py').read_text()
GIVEN = Scenario('given', {'a': '2'})
BARE = Scenario('bare', defaults={'a': '1.0'})
ANY = Scenario('any', defaults={'a': None})


def recorded(scenario: Scenario, default: str | None) -> Outcome:
    run = FakeRecording(launch=LaunchRecord(file=FILE, declared=[DeclaredArgument('a', default, '', None, FILE, 3)]))
    return Outcome(scenario, 'recorded', run)  # type: ignore[arg-type]


def made(outcomes: list[Outcome]) -> tuple[list[Scenario], list[Outcome]]:
    """Which runs are made again, and what stands in the end."""
    asked: list[Scenario] = []

    def again(scenarios: list[Scenario]) -> list[Outcome]:
        asked.extend(scenarios)
        return [recorded(scenario, "'1.0'") for scenario in scenarios]

    return asked, with_defaults_given(outcomes, again)


def test_a_run_whose_default_is_right_is_made_once() -> None:
    outcomes = [recorded(GIVEN, "'1'"), recorded(BARE, "'1'")]
    assert made(outcomes) == ([], outcomes)


def test_a_run_with_another_default_is_made_again_with_the_argument() -> None:
    asked, found = made([recorded(GIVEN, "'3'"), recorded(BARE, "'3'")])
    assert asked == [BARE._replace(arguments={'a': '1.0'}, defaults={})]
    assert [(outcome.scenario.arguments, outcome.bare) for outcome in found] == [({'a': '2'}, None), ({'a': '1.0'}, None)]


def test_a_run_that_cannot_do_without_is_made_again_and_says_why() -> None:
    asked, found = made([recorded(GIVEN, None), Outcome(BARE, 'unusable', text='missing argument a')])
    assert [dict(scenario.arguments) for scenario in asked] == [{'a': '1.0'}]
    assert found[1].bare == ('missing argument a', ('a',))


def test_a_run_for_which_any_default_will_do_is_left_out() -> None:
    asked, found = made([recorded(GIVEN, None), Outcome(ANY, 'unusable', text='missing argument a')])
    assert (asked, [outcome.scenario.name for outcome in found]) == ([], ['given'])


def test_what_cannot_be_run_at_all_is_not_made_again() -> None:
    outcomes = [Outcome(GIVEN, 'unusable', text='SyntaxError'), Outcome(BARE, 'unusable', text='SyntaxError')]
    assert made(outcomes) == ([], outcomes)
    stopped = [recorded(GIVEN, None), Outcome(BARE, 'stopped', text='too long')]
    assert made(stopped) == ([], stopped)


CASES = {
    'no default': (CIRCLE.replace("            default_value='1.0',\n", ''), 11.0, ['default_is_one_metre']),
    'another default': (CIRCLE.replace("'1.0'", "'1.2'"), 11.0, ['default_is_one_metre']),
    'the same number': (CIRCLE.replace("'1.0'", "'1.000'"), 12.0, []),
    'a default of another type': (CIRCLE.replace("'1.0'", "'1'"), 11.0, ['default_is_one_metre']),
    'a default that is calculated': (
        CIRCLE.replace("'1.0'", "PythonExpression(['0.5 + 0.5'])").replace(
            'import LaunchConfiguration', 'import LaunchConfiguration, PythonExpression'
        ),
        12.0,
        [],
    ),
    'another default that is calculated': (
        CIRCLE.replace("'1.0'", "PythonExpression(['0.5 + 0.7'])").replace(
            'import LaunchConfiguration', 'import LaunchConfiguration, PythonExpression'
        ),
        11.0,
        ['default_is_one_metre'],
    ),
    'a default that never counts': (
        CIRCLE.replace(
            'LaunchConfiguration(',
            "PythonExpression(['1.25 if ', LaunchConfiguration('circle_radius'), ' == 1.0 else ', LaunchConfiguration('circle_radius')]) or (",
        ).replace('import LaunchConfiguration', 'import LaunchConfiguration, PythonExpression'),
        5.0,
        ['radius_is_passed'],  # it explains the other failures, which give no points either
    ),
}


@pytest.mark.processes
def test_a_default_costs_its_own_points_and_is_shown_by_a_run(tmp_path: Path) -> None:
    works = []
    for number, (text, _, _) in enumerate(CASES.values()):
        assert text != CIRCLE
        path = tmp_path / str(number) / 'circle.launch.py'
        path.parent.mkdir()
        path.write_text(text)
        works.append(plan_work(Submission(str(path))))
    found = {}
    for name, report in zip(CASES, grade(works), strict=True):
        found[name] = (report.earned, [result.name for result in report.results if result.status == 'failed'])
    assert found == {name: (earned, failed) for name, (_, earned, failed) in CASES.items()}


RUBRIC = """\
title: A name
runs:
  - {name: usual, defaults: {who: anna}, duration: 1}
  - {name: other, arguments: {who: {one_of: [bert, carl]}}, duration: 1}
checks:
  - {name: default, argument: {name: who, default: anna, shows: [node]}, points: 1}
  - {name: node, node: {name: /$(arg who), package: turtlesim}, points: 1}
"""


def test_a_yaml_rubric_has_runs_without_an_argument() -> None:
    rubric = read_yaml_rubric('a.yaml', RUBRIC.encode())
    usual, other = rubric.scenarios(1)
    assert (usual.arguments, usual.defaults) == ({}, {'who': 'anna'}) and dict(other.arguments) in (
        {'who': 'bert'},
        {'who': 'carl'},
    )


@pytest.mark.parametrize(
    ('old', 'new', 'told'),
    [
        ('shows: [node]', 'shows: [nodes]', 'a.yaml:6: shows is a list of names of checks; there are default, node'),
        ('shows: [node]', 'shows: node', "a.yaml:6: shows is 'node'; write a list of names"),
        ('defaults: {who: anna}', 'defaults: {who: [1]}', 'a.yaml:3: a default must be a string, or null for any default'),
        (
            'defaults: {who: anna}',
            'defaults: {who: anna}, arguments: {who: b}',
            'a.yaml:3: write an argument in arguments or in defaults, and not in both',
        ),
    ],
)
def test_mistakes_in_it_are_said_with_their_line(old: str, new: str, told: str) -> None:
    with pytest.raises(Exception) as raised:
        read_yaml_rubric('a.yaml', RUBRIC.replace(old, new).encode())
    assert str(raised.value) == told


def test_what_is_declared_may_be_anything() -> None:
    odd = recorded(BARE, 7)  # type: ignore[arg-type]
    assert made([odd, odd]) == ([], [odd, odd])

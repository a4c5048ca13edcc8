"""Broken copies of the solutions: each report names the real cause, in one block, with an action that begins with a verb."""

from __future__ import annotations

import ast
import re
import shutil
from collections.abc import Iterator
from html import unescape
from pathlib import Path
from typing import Any

import made_report
import pytest
import yaml
from edugrade.evidence import Missing, Outcome
from edugrade.judging import judge
from edugrade.reports.page import report_html
from edugrade.reports.terminal import next_step, render
from edugrade.results import CheckResult
from edugrade.rubrics.catalogue import find_rubric
from edugrade.source import Gap
from edugrade.submission import Submission

from edulaunch.runtime.session import run

ROOT = Path(__file__).resolve().parents[2]
CHECKS = ROOT / 'grader' / 'checks'


def results_of(folder: Path, name: str, file: str = '', old: str = '', new: str | None = None) -> dict[str, CheckResult]:
    """The results of a solution with one change, or without one of its files."""
    solution = ROOT / 'solutions' / name
    copy = folder / name
    (shutil.copytree if solution.is_dir() else shutil.copy)(solution, copy)
    changed = copy / file if file else copy
    if new is None:
        changed.unlink()
    else:
        text = changed.read_text()
        assert old in text
        changed.write_text(text.replace(old, new))
    submission = Submission(str(copy))
    _, rubric = find_rubric(submission.exercise)
    outcomes = [Outcome(scenario, 'recorded', recorded(submission, scenario)) for scenario in rubric.scenarios(1)[:2]]
    return {result.name: result for result in judge(rubric.checks, outcomes, submission.source)}


def recorded(submission: Submission, scenario: Any) -> Any:
    package = submission.package
    target = [submission.file] if package is None else [package.name, Path(submission.file).name]
    workspaces = None if package is None else [package.workspace]
    return run(*target, arguments=dict(scenario.arguments), duration_s=scenario.duration_s, workspaces=workspaces, console=silent)


def silent(stream: str, text: str) -> None:
    """A console that shows nothing."""


def test_a_dead_program_shows_its_last_line_and_no_mistake_of_another_program(tmp_path: Path) -> None:
    results = results_of(tmp_path, 'static_frame.launch.py', old="LaunchConfiguration('height'),\n", new="'height',\n")
    dead = results['no_node_dies']
    assert re.fullmatch(
        r'static_transform_publisher-1 died after 0.0 s with exit code 1 in the run with height:=\S+', dead.reason
    )
    assert dead.seen is not None and dead.seen.endswith('Failed to parse --z argument as float')
    assert [result.cause for result in results.values()] == [None] * len(results)


@pytest.mark.parametrize(
    ('name', 'file', 'checks'),
    [
        ('two_seas', 'config/sea.yaml', ['north_red', 'south_red']),
        ('large_project', 'config/turtlesim.yaml', ['water_comes_from_the_file']),
    ],
)
def test_a_parameter_file_that_is_missing_is_the_reason(tmp_path: Path, name: str, file: str, checks: list[str]) -> None:
    found = results_of(tmp_path, name, file)
    results = [found[check] for check in checks]
    assert {result.status for result in results} == {'failed'}
    assert all(
        result.reason.startswith('the parameter file ') and result.reason.endswith(f'{file} does not exist') for result in results
    )
    assert all(result.where is not None and result.where.file.endswith('.launch.py') for result in results)
    assert render(made_report.report(*results)).count('does not exist') == 1


def test_a_parameter_file_that_cannot_be_read_is_the_place(tmp_path: Path) -> None:
    results = results_of(tmp_path, 'two_seas', 'config/sea.yaml', 'ros__parameters', 'ros_parameters')
    dead = results['alive']
    assert 'died because it cannot read the parameter file' in dead.reason
    assert dead.where is not None and (Path(dead.where.file).name, dead.where.line) == ('sea.yaml', 4)


def test_each_cause_is_with_the_check_of_its_parameter(tmp_path: Path) -> None:
    old, new = "f'background_{colour[0]}'", "f'backgrond_{colour[0]}'"
    results = results_of(tmp_path, 'water.launch.py', old=old, new=new)
    causes = {name: result.cause for name, result in results.items() if result.cause is not None}
    assert {name: cause.facts['near'] for name, cause in causes.items()} == {
        'red_water': 'background_r',
        'green_water': 'background_g',
        'blue_water': 'background_b',
    }


def test_checks_of_one_cause_are_one_block_on_the_page_too() -> None:
    first = made_report.FAILED
    second = CheckResult(**{**vars(first), 'name': 'turns', 'sentence': 'It turns'})
    shown = made_report.report(first, second, made_report.PASSED)
    for text in (render(shown), unescape(report_html(shown))):
        assert text.count('the robot stands') == 1
        assert text.index('It drives') < text.index('It turns') < text.index('the robot stands')


def test_the_next_step_is_the_first_failed_check_even_where_a_solved_todo_stayed() -> None:
    gaps = (Gap(made_report.FILE, 4, '# TODO 1: drive'),)
    assert next_step(made_report.report(made_report.PASSED, made_report.FAILED, gaps=gaps)).startswith(
        'Next: make the check "It drives" pass'
    )


@pytest.mark.parametrize(('text', 'is_written'), [("Node(name='sam')", True), ("Node(name='sample')", False), ('', False)])
def test_only_a_whole_word_of_the_student_is_corrected(text: str, is_written: bool) -> None:
    failure = Missing('the node /sim', name='/sim', among=['/sam'], try_='add it')
    failure.correct([text])
    assert failure.try_ == ('write "sim" instead of "sam"' if is_written else 'add it')


VERBS = {
    *('add', 'begin', 'call', 'check', 'compare', 'correct', 'count', 'create', 'define', 'find', 'free', 'give', 'grade'),
    *('include', 'launch', 'list', 'move', 'pass', 'publish', 'put', 'remove', 'report', 'restore', 'return', 'run', 'set'),
    *('spawn', 'start', 'store', 'take', 'use', 'write'),
}


def advice() -> Iterator[tuple[str, str]]:
    """Each piece of advice of the rubrics and of the library, with its file."""
    for path in sorted(CHECKS.glob('*.yaml')):
        for check in yaml.safe_load(path.read_text())['checks']:
            steps = check.get('try', [])
            yield from ((path.name, step) for step in ([steps] if isinstance(steps, str) else steps))
    for path in (*CHECKS.glob('*.py'), *(ROOT / 'grader' / 'edugrade').rglob('*.py')):
        for node in ast.walk(ast.parse(path.read_text())):
            if isinstance(node, ast.keyword) and node.arg == 'try_':
                values = node.value.elts if isinstance(node.value, ast.List) else [node.value]
                yield from ((path.name, text) for value in values if (text := beginning(value)))


def beginning(node: ast.expr) -> str:
    """The first letters of a string; '' for a value that is made elsewhere."""
    if isinstance(node, ast.JoinedStr) and node.values:
        node = node.values[0]
    return node.value if isinstance(node, ast.Constant) and isinstance(node.value, str) else ''


def test_every_advice_begins_with_a_verb() -> None:
    found = list(advice())
    assert len(found) > 60
    assert [item for item in found if item[1].split()[0] not in VERBS] == []


def test_a_program_that_died_shows_its_last_line_where_no_check_is_about_deaths(tmp_path: Path) -> None:
    old, new = "get_logger().info(f'messages: {self.count}')", 'get_logger().inform(self.count)'
    results_of(tmp_path, 'two_channels', 'two_channels/counter.py', old, new)
    submission = Submission(str(tmp_path / 'two_channels'))
    _, rubric = find_rubric(submission.exercise)
    outcomes = [Outcome(scenario, 'recorded', recorded(submission, scenario)) for scenario in rubric.scenarios(1)[:1]]
    checks = [check._replace(needs=()) for check in rubric.checks if check.name == 'counts_on']
    _, failed = judge(checks, outcomes, submission.source)
    assert failed.seen is not None
    assert re.fullmatch(r"counter-\d died with exit code 1: AttributeError: .*'inform'.*", failed.seen.splitlines()[-1])

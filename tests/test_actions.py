"""Each action begins with a verb: what a rule of advice suggests, the help of an error, and the `try` of a report."""

from __future__ import annotations

import ast
from collections.abc import Iterator
from pathlib import Path

import pytest
import yaml

from edulaunch.advice.catalogue import template_of
from edulaunch.advice.rule import all_rules
from tests.house import ROOT

VERBS = (
    'add align ask assign begin broadcast build call change check choose clone close compare connect convert copy '
    'correct count create declare define delete deserialize do download end export find fix follow get give grade '
    'hand import include increase indent install keep kill launch leave let list look make move name open pack pass '
    'publish put read record remap remove rename repair replace report restore return run save see select send set '
    'simulate spawn spin start stop store subscribe swap synchronize try type undo use wait write '
)
OPENINGS = ('did you mean ', 'if you ', 'in main(), ')
"""An action may begin with the case in which it holds. A hint may also be a question."""
NOT_ACTIONS = ('edulaunch/ros/python', 'edulaunch/ros/programs')
"""Errors there have the words of ROS 2."""


def begins_with_verb(text: str) -> bool:
    first = text.split()[0].strip(',:').lower()
    return first in VERBS.split() or text.startswith(OPENINGS) or text.startswith('{') or text.endswith('?')


def actions_of(tree: ast.AST) -> Iterator[tuple[int, str]]:
    """The `help` of each error and the `try_` of each result; help of options of a command line is not an action."""
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and not ast.unparse(call.func).endswith(('add_argument', 'add_parser', 'add_subparsers')):
            for keyword in call.keywords:
                if keyword.arg in ('help', 'try_'):
                    yield from ((call.lineno, text) for text in map(template_of, _parts(keyword.value)) if text)


def _parts(value: ast.expr) -> list[ast.expr]:
    if isinstance(value, ast.IfExp):
        return [*_parts(value.body), *_parts(value.orelse)]
    if isinstance(value, ast.BoolOp):
        return [part for one in value.values for part in _parts(one)]
    return value.elts if isinstance(value, (ast.Tuple, ast.List)) else [value]


def sources() -> list[Path]:
    paths = [*(ROOT / 'edulaunch').rglob('*.py'), *(ROOT / 'grader').rglob('*.py')]
    return [path for path in paths if not path.relative_to(ROOT).as_posix().startswith(NOT_ACTIONS)]


def test_what_a_rule_suggests_begins_with_a_verb() -> None:
    assert [(rule.name, text) for rule in all_rules().values() for text in rule.do if not begins_with_verb(text)] == []


def test_the_help_of_an_error_and_the_try_of_a_result_begin_with_a_verb() -> None:
    wrong = [
        f'{path.relative_to(ROOT)}:{line}: {text}'
        for path in sorted(sources())
        for line, text in actions_of(ast.parse(path.read_text(encoding='utf-8')))
        if not begins_with_verb(text)
    ]
    assert wrong == []


def test_the_try_of_a_rubric_begins_with_a_verb() -> None:
    wrong = []
    for path in [*(ROOT / 'grader' / 'checks').glob('*.yaml'), *(ROOT / 'lessons' / 'checks').glob('*.yaml')]:
        for check in yaml.safe_load(path.read_text(encoding='utf-8')).get('checks', ()):
            steps = check.get('try', ()) if isinstance(check, dict) else ()
            wrong += [(path.name, text) for text in ([steps] if isinstance(steps, str) else steps) if not begins_with_verb(text)]
    assert wrong == []


def test_the_try_of_a_launch_file_that_fails_begins_with_a_verb() -> None:
    reports = (ROOT / 'tests' / 'grader' / 'golden').glob('*/report.txt')
    tries = [line.partition('try: ')[2].strip() for path in reports for line in path.read_text().splitlines() if ' try: ' in line]
    assert len(tries) > 15 and [text for text in tries if not begins_with_verb(text)] == []


@pytest.mark.parametrize('text', ['the package x does not exist; write y', 'nothing is here', 'there are: a, b'])
def test_a_state_is_not_an_action(text: str) -> None:
    assert not begins_with_verb(text)

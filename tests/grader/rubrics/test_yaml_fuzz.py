"""Damaged rubrics: whatever a course author writes is read, or refused with the line."""

from __future__ import annotations

from copy import deepcopy
from pathlib import Path
from typing import Any

import pytest
import yaml
from edugrade.rubric import RubricMistake
from edugrade.rubrics.yaml_rubric import read_yaml_rubric
from hypothesis import example, given
from hypothesis import strategies as st

ROOT = Path(__file__).resolve().parents[3]
RUBRICS = [yaml.safe_load(path.read_text('utf-8')) for path in sorted((ROOT / 'grader' / 'checks').glob('*.yaml'))]
ODD: list[Any] = [
    None,
    True,
    0,
    -1,
    10**30,
    1e400,
    float('nan'),
    '',
    'x',
    '{a',
    '../x',
    'a\x07b',
    '(?P<',
    '$(arg x)',
    '$(arg',
    [],
    {},
]
ODD += [[1], [[]], [{}], ['x'] * 3, {'a': 1}, {'': None}, {'between': [5, 1]}, {'between': [1, 'x']}, {'between': [0, 1e400]}]
ODD += [{'one_of': []}, {'one_of': [[]]}, {'one_of': ['x']}, {'word': True}, {'between': [1, 2], 'decimals': True}, {'node': []}]


def places(value: Any) -> list[tuple[Any, Any]]:
    """Return every container in a value with each of its keys."""
    keys = list(value) if isinstance(value, dict) else list(range(len(value))) if isinstance(value, list) else []
    return [place for key in keys for place in ((value, key), *places(value[key]))]


@st.composite
def damaged(draw: st.DrawFn) -> bytes:
    rubric = deepcopy(draw(st.sampled_from(RUBRICS)))
    for _ in range(draw(st.integers(1, 2))):
        place, key = draw(st.sampled_from(places(rubric)))
        if draw(st.integers(0, 4)):
            place[key] = deepcopy(draw(st.sampled_from(ODD)))
        else:
            del place[key]
    return yaml.safe_dump(rubric).encode()


@given(data=damaged())
@example(data=b'[' * 2000)
@example(data=b'title: T\nchecks: [{alive: {}, needs: 3}]\nruns: [{name: a}]')
@example(data=b'title: T\nchecks: [{alive: {}, needs: [[]]}]\nruns: [{name: a}]')
@example(data=b'title: T\nchecks: [{argument: {name: r, shows: [[]]}}]\nruns: [{name: a}]')
@example(data=b'title: T\nchecks: [{alive: {}}]\nruns: [{name: a, seed: []}]')
@example(data=b'title: T\nchecks: [{alive: {}}]\nruns: [{name: a, arguments: {r: {between: [1, 2], decimals: true}}}]')
def test_a_damaged_rubric_is_read_or_refused(data: bytes) -> None:
    try:
        rubric = read_yaml_rubric('one.yaml', data)
        runs = rubric.scenarios(7)
    except RubricMistake as error:
        assert str(error).startswith('one.yaml')
    else:
        assert all(isinstance(run.duration_s, float) for run in runs) and all(check.name for check in rubric.checks)


@pytest.mark.parametrize(
    ('field', 'words'),
    [
        ('hears: {node: [1], topic: /a}', 'node is [1]; write a string'),
        ('hears: {node: "a\\u0007", topic: /a}', "node is 'a\\x07'; write a string"),
        ('nodes: {are: a}', "are is 'a'; write a list of names"),
        (
            'node_parameter: {node: a, package: b, name: b, value: {c: 1}}',
            "value is {'c': 1}; write a string, a number, true, false, or a list of",
        ),
        ('topic: {name: a, rate: .inf}', 'rate is inf; write a number of at least 0'),
        ('topic: {name: a, rate: true}', 'rate is True; write a number of at least 0'),
        ('travels: {at_least: 1, share: 2}', 'share is 2; write a number between 0 and 1'),
        ('starts: {node: a, at: 1, after: {node: [1]}}', "after is {'node': [1]}; write the name of a node"),
        ('starts: {node: a, at: 1, after: {package: b}}', "after is {'package': 'b'}; write the name of a node"),
        ('receives: {node: a, from: {executable: b}}', "from is {'executable': 'b'}; write the name of a node"),
        ('receives: {node: a, from: {node: b, topic: /c}}', "from is {'node': 'b', 'topic': '/c'}; write the name of a node"),
        ('receives: {node: a}', 'receives lacks from'),
    ],
)
def test_a_value_of_the_wrong_type_is_named(field: str, words: str) -> None:
    with pytest.raises(RubricMistake) as caught:
        read_yaml_rubric('one.yaml', f'title: T\nruns:\n- name: a\nchecks:\n- {field}\n'.encode())
    assert words in str(caught.value) and str(caught.value).startswith('one.yaml:5')

"""Checks of what a file with a recording may contain."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.engine.recording import schema
from edulaunch.engine.recording.schema import FAR, each, maybe, record, row, table

RIGHT_AND_WRONG: dict[str, tuple[list[Any], list[Any]]] = {
    'text': (['', 'a'], [None, 1, ['a']]),
    'number': ([0, -1, FAR - 1, -FAR], [True, 1.0, '1', FAR, -FAR - 1]),
    'quantity': ([1, 1.5, FAR], [True, '1', None]),
    'numbers': ([[], [1, 2], [-FAR, FAR - 1]], [(1,), [1.0], [True], [FAR], [-FAR - 1, 0], [1, 'a']]),
    'wire': ([[], [1, 'a']], [(1,), None]),
    'wires': ([[], [[], [1]]], [[1], [[], (1,)], ([],)]),
    'truth': ([True, False], [0, 1, None]),
    'fact': ([None, 'a', 1, 1.5, True, ['a', 'b'], []], [[1], {'a': 1}, ('a',)]),
    'root': (
        [['/a/b', '@work'], ['', '@' + 'x' * 39]],
        [['/a', 'work'], ['/a', '@' + 'x' * 40], ['/a'], [1, '@a'], ('/a', '@a')],
    ),
    'anything': ([None, {}], []),
}


@pytest.mark.parametrize('name', RIGHT_AND_WRONG)
def test_simple_checks(name: str) -> None:
    right, wrong = RIGHT_AND_WRONG[name]
    check = getattr(schema, name)
    assert [check(value) for value in right] == [True] * len(right)
    assert [check(value) for value in wrong] == [False] * len(wrong)


@pytest.mark.parametrize(
    ('check', 'right', 'wrong'),
    [
        (maybe(schema.text), [None, 'a'], [1]),
        (each(schema.text), [[], ['a', 'b']], ['ab', ('a',), ['a', 1]]),
        (row(schema.text, schema.number), [['a', 1]], [['a'], ['a', 1, 1], [1, 'a'], ('a', 1)]),
        (table(schema.number), [{}, {'a': 1}], [{'a': 'b'}, [1]]),
        (
            record({'a': schema.text}, {'b': schema.number}),
            [{'a': 'x'}, {'a': 'x', 'b': 1}],
            [{}, {'b': 1}, {'a': 1}, {'a': 'x', 'b': 'y'}, {'a': 'x', 'c': 1}, ['a']],
        ),
        (record({'a': schema.text}), [{'a': 'x'}], [{'a': 'x', 'b': 1}]),
    ],
)
def test_combined_checks(check: Any, right: list[Any], wrong: list[Any]) -> None:
    assert [check(value) for value in right] == [True] * len(right)
    assert [check(value) for value in wrong] == [False] * len(wrong)


def test_a_table_that_is_too_long_for_its_name_is_no_part() -> None:
    endpoint = ['publisher', '/a', 'std_msgs/msg/String', 1, 0, 2, []]
    assert schema.PARTS['endpoints']([endpoint])
    assert not schema.PARTS['endpoints']([[*endpoint, 1]])
    call = [0, '/s', 'a/srv/B', 'n', [], True, None, None]
    assert schema.PARTS['calls']([call, [*call[:6], 5, []]])
    assert not schema.PARTS['calls']([[*call[:5], 1, None, None]])

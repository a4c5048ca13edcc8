"""Numbers of a rubric that are calculated."""

from __future__ import annotations

import pytest
from edugrade.rubrics.yaml_wanted import Wanted, calculated


def test_numbers_are_calculated() -> None:
    assert [calculated(text) for text in ('2', ' -0.5', '5.5 + 4 * 0.25', '(1 + 2) / -4')] == [2.0, -0.5, 6.5, -0.75]


@pytest.mark.parametrize(
    'text', ['', 'fast', '2 ** 99999', '1 / 0', 'open("x")', '[1]', 'True', '1 +', "'3'", '(' * 300 + '1' + ')' * 300]
)
def test_nothing_else_is(text: str) -> None:
    with pytest.raises(ValueError, match='not a number'):
        calculated(text)


@pytest.mark.parametrize(
    'after', ['/sim', {'node': '/sim', 'package': 'turtlesim'}, {'topic': '/chatter', 'package': 'demo_nodes_py'}]
)
def test_a_time_is_after_a_node_or_a_message(after: object) -> None:
    Wanted({'after': after}, None).refuse_odd_values()


@pytest.mark.parametrize('after', [{'package': 'turtlesim'}, {'node': '/sim', 'topic': '/chatter'}, {'topic': 3}, 3])
def test_a_time_is_after_nothing_else(after: object) -> None:
    with pytest.raises(ValueError, match=r'after is .*; write the name of a node'):
        Wanted({'after': after}, None).refuse_odd_values()

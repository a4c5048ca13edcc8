"""Numbers of a rubric that are calculated."""

from __future__ import annotations

import pytest
from edugrade.rubrics.yaml_wanted import calculated


def test_numbers_are_calculated() -> None:
    assert [calculated(text) for text in ('2', ' -0.5', '5.5 + 4 * 0.25', '(1 + 2) / -4')] == [2.0, -0.5, 6.5, -0.75]


@pytest.mark.parametrize(
    'text', ['', 'fast', '2 ** 99999', '1 / 0', 'open("x")', '[1]', 'True', '1 +', "'3'", '(' * 300 + '1' + ')' * 300]
)
def test_nothing_else_is(text: str) -> None:
    with pytest.raises(ValueError, match='not a number'):
        calculated(text)

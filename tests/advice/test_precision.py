"""Of the broken exercises the planted mistake is named first in nine of ten, with at most one further remark on average."""

from __future__ import annotations

import pytest

from tests.advice.precision import NAMES, TWINS, is_named_first, remarks


@pytest.mark.whole
def test_the_planted_mistake_is_named_first_in_nine_of_ten() -> None:
    missed = [name for name in NAMES if not is_named_first(name)]
    assert len(NAMES) >= 40
    assert len(missed) <= len(NAMES) // 10, missed


@pytest.mark.whole
def test_there_is_at_most_one_further_remark_on_average() -> None:
    further = {name: len(remarks(name)) - 1 for name in NAMES if len(remarks(name)) > 1}
    assert sum(further.values()) <= len(NAMES), further


@pytest.mark.parametrize('name', TWINS)
def test_nothing_is_said_of_a_healthy_twin(name: str) -> None:
    assert [finding.rule for finding in remarks(name)] == []

"""docs/features.md says what the lessons have, and they have it."""

from __future__ import annotations

import pytest

from tests.lessons.features import FEATURES, PAGE, Feature, page, table
from tests.lessons.notebook import LESSONS


def test_the_page_is_up_to_date() -> None:
    assert PAGE.read_text('utf-8') == page(), 'python -m tests.lessons.features'


@pytest.mark.parametrize(('feature', 'row'), list(zip(FEATURES, table(), strict=True)), ids=[feature.name for feature in FEATURES])
def test_a_feature_is_in_as_many_lessons_as_it_has_to_be(feature: Feature, row: list[list[str]]) -> None:
    assert sum(bool(cells) for cells in row) >= feature.least


def test_the_tests_that_are_named_exist() -> None:
    missing = [test for feature in FEATURES for test in feature.tests if not (LESSONS.parent / test).exists()]
    assert missing == []

"""Pages of a class have the colours of a report."""

from __future__ import annotations

import re

import pytest
from edugrade.classes.batch.tables import STYLE as CLASS_STYLE
from edugrade.classes.similar import STYLE as SIMILAR_STYLE
from edugrade.reports.theme import PAGE


@pytest.mark.parametrize('style', [CLASS_STYLE, SIMILAR_STYLE], ids=['class', 'similar'])
def test_every_page_has_both_schemes_and_no_other_colour(style: str) -> None:
    assert PAGE in style and 'prefers-color-scheme:dark' in style
    assert not re.findall(r'#[0-9a-fA-F]{3,6}\b', style.replace(PAGE, ''))

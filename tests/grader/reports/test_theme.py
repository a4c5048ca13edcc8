"""The colours of pages have enough contrast in both schemes (WCAG 2.2: 4.5 to 1 for text, 3 to 1 for borders)."""

from __future__ import annotations

import re
from collections.abc import Mapping

import pytest
from edugrade.reports.page import STYLE, report_html
from edugrade.reports.theme import DARK, LIGHT, NOTEBOOK, PAGE, colour
from made_report import BROKE, FAILED, NOT_RUN, PASSED, report

GROUNDS = {'ground', 'mark', 'same'}
NOTEBOOK_GROUND = '#111111'  # of JupyterLab's dark theme


def luminance(colour: str) -> float:
    parts = [int(colour[place : place + 2], 16) / 255 for place in (1, 3, 5)]
    red, green, blue = (part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts)
    return 0.2126 * red + 0.7152 * green + 0.0722 * blue


def contrast(one: str, other: str) -> float:
    high, low = sorted((luminance(one), luminance(other)), reverse=True)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize('scheme', [LIGHT, DARK], ids=['light', 'dark'])
def test_text_and_borders_have_contrast(scheme: Mapping[str, str]) -> None:
    for name in set(scheme) - GROUNDS:
        assert contrast(scheme[name], scheme['ground']) >= (3.0 if name == 'line' else 4.5), name
    assert min(contrast(scheme['text'], scheme[name]) for name in GROUNDS) >= 4.5


def test_a_dark_notebook_has_contrast() -> None:
    names = set(DARK) - GROUNDS - {'line'}
    assert min(contrast(DARK[name], NOTEBOOK_GROUND) for name in names) >= 4.5
    assert all(f'--{name}:{value};' in NOTEBOOK for name, value in DARK.items())


def test_black_and_white_have_the_contrast_that_the_standard_says() -> None:
    assert contrast('#000000', '#ffffff') == pytest.approx(21.0)
    assert contrast('#ffffff', '#ffffff') == pytest.approx(1.0)


def test_a_report_has_both_schemes_and_no_other_colour() -> None:
    assert PAGE in STYLE and 'prefers-color-scheme:dark' in STYLE
    assert not re.findall(r'#[0-9a-fA-F]{3,6}\b', STYLE.replace(PAGE, ''))


def test_a_report_has_only_the_colours_of_the_theme() -> None:
    text = report_html(report(BROKE, FAILED, NOT_RUN, PASSED))
    assert set(re.findall(r'color:([^;"]+)', text)) == {colour(name) for name in ('passed', 'failed', 'not_run', 'grader_broke')}

"""The page is whole: nothing is fetched, and nothing of a run can become markup or script."""

from __future__ import annotations

import base64
import json
import re
import zlib
from pathlib import Path

import pytest

from edulaunch.desk.view import page as page_module
from edulaunch.desk.view.page import FILES, live_page, module, packed, recorded_page, script

PIECE = {'start': 0, 'now': 1, 'logs': [[0, 'x', 'x', 20, '</script><script>alert(1)</script>']]}


def test_what_programs_wrote_stands_in_no_page_as_text() -> None:
    page = recorded_page(PIECE, '<b>title</b>')
    assert '</script><script>' not in page
    assert '<b>title' not in page
    data = re.search(r"unpacked\('z([^']+)'\)", page)
    assert data
    assert json.loads(zlib.decompress(base64.b64decode(data[1]))) == PIECE
    assert json.loads(base64.b64decode(packed(PIECE, small=False)[1:])) == PIECE


@pytest.mark.parametrize('page', [recorded_page(PIECE, 'a'), live_page('a')], ids=['recorded', 'live'])
def test_a_page_asks_no_other_machine(page: str) -> None:
    places = set(re.findall(r'https?://[^\'"\s)]+', page))
    assert places == {'http://www.w3.org/2000/svg'}  # the name of a format, never fetched
    assert "default-src 'none'" in page


def contrast(one: str, other: str) -> float:
    """The ratio of contrast of two colours, as WCAG defines it."""
    parts = [[int(colour[i : i + 2], 16) / 255 for i in (1, 3, 5)] for colour in (one, other)]
    linear = [[part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in colour] for colour in parts]
    low, high = sorted(0.2126 * red + 0.7152 * green + 0.0722 * blue for red, green, blue in linear)
    return (high + 0.05) / (low + 0.05)


@pytest.mark.parametrize('theme', ['', '[data-theme=dark]'], ids=['light', 'dark'])
def test_text_and_borders_of_the_page_have_contrast(theme: str) -> None:
    """WCAG 2.2: 4.5 to 1 for text, 3 to 1 for the borders of controls. axe-core sees neither borders nor what a canvas shows."""
    style = (Path(page_module.__file__).with_name('page') / 'style.css').read_text(encoding='utf-8')
    (rule,) = re.findall(rf'(?m)^\.desk{re.escape(theme)} {{ (--x:[^}}]*)', style)
    colours = dict(re.findall(r'--(\w+): (#\w{6});', rule))
    colours = {**dict(re.findall(r'--(\w+): (#\w{6});', style.partition('}')[0])), **colours}
    for name, least in (('ink', 4.5), ('soft', 4.5), ('bad', 4.5), ('good', 4.5), ('lit', 4.5), ('line', 3.0)):
        assert min(contrast(colours[name], colours[ground]) for ground in ('paper', 'field')) >= least, name
    assert contrast(colours['line'], colours['button']) >= 3.0


def test_red_is_the_colour_of_errors_and_of_the_axis_x_only() -> None:
    folder = Path(page_module.__file__).with_name('page')
    lines = [line for name in FILES for line in (folder / name).read_text(encoding='utf-8').splitlines()]
    assert [line.strip() for line in lines if re.search('#(cc241d|b3261e)', line) and '[1, 0, 0]' not in line] == []


def test_packing_is_the_same_every_time() -> None:
    assert packed(PIECE) == packed(dict(PIECE))


def test_no_name_is_defined_twice_in_the_joined_script() -> None:
    texts = [(Path(page_module.__file__).with_name('page') / name).read_text(encoding='utf-8') for name in FILES]
    names = re.findall(r'^(?:const|let|class|function|async function) (\w+)', '\n'.join(texts), re.MULTILINE)
    assert len(names) == len(set(names))
    assert len(FILES) == len(set(FILES))


def test_comments_and_indents_are_not_part_of_what_a_notebook_stores() -> None:
    assert not re.search(r'(?m)^ ', script()) and '/* Small words' not in script()
    assert "'/*'" not in script() and script().count('class GraphView') == 1


def test_the_module_exports_what_a_widget_needs() -> None:
    assert module().rstrip().endswith('export default { render };')

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

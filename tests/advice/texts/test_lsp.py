"""edulaunch.advice.texts.lsp: places, edits and addresses as editors count and write them."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.advice.texts.edits import Edit
from edulaunch.advice.texts.lsp import changes, offset_of, path_of, position, uri_of
from edulaunch.advice.texts.text import Span, Text

TEXT = Text('one\n🐢 = 2\n\nlast', '/a.py')


@pytest.mark.parametrize(
    ('word', 'line', 'character'), [('one', 0, 0), ('e\n', 0, 2), ('🐢', 1, 0), (' = 2', 1, 2), ('\nlast', 2, 0), ('st', 3, 2)]
)
def test_lines_and_characters_count_from_0_and_a_turtle_has_two_units(word: str, line: int, character: int) -> None:
    offset = TEXT.text.index(word)
    assert position(TEXT, offset) == {'line': line, 'character': character}
    assert offset_of(TEXT, line, character) == offset


def test_a_place_behind_a_line_is_its_end() -> None:
    assert offset_of(TEXT, 3, 99) == len(TEXT.text)


def test_each_edit_is_a_change_of_the_document() -> None:
    at = TEXT.text.index('2')
    assert changes(TEXT, (Edit('/a.py', Span(at, at + 1), '2', '30'),)) == [
        {'range': {'start': {'line': 1, 'character': 5}, 'end': {'line': 1, 'character': 6}}, 'newText': '30'}
    ]
    assert changes(TEXT, ()) == []


def test_an_address_leads_back_to_its_file(tmp_path: Path) -> None:
    file = str(tmp_path / 'a launch file ü.py')
    assert ' ' not in uri_of(file) and path_of(uri_of(file)) == file
    assert path_of('untitled:Untitled-1') == 'Untitled-1'

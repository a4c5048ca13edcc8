"""Places in texts: lines, columns in characters, and what begins in a line."""

from __future__ import annotations

import ast

from edulaunch.advice.texts.text import Place, Span, Text


def test_offsets_and_places() -> None:
    text = Text('ab\n\u00e9 c\n', 'a.py')
    assert [text.place(offset) for offset in (0, 2, 3, 5, 7)] == [Place(1, 0), Place(1, 2), Place(2, 0), Place(2, 2), Place(3, 0)]
    assert [text.offset(1, 1), text.offset(2, 99), text.offset(9, 9)] == [1, 6, 7]
    assert text.line_span(2) == Span(3, 6)


def test_columns_of_the_syntax_tree_count_bytes() -> None:
    text = Text("x = 'é', name\n", 'a.py')
    assert text.tree is not None
    (name,) = [node for node in ast.walk(text.tree) if isinstance(node, ast.Name) and node.id == 'name']
    start, end = text.of_node(name)
    assert text.text[start:end] == 'name'


def test_words_are_found_whole_and_once() -> None:
    text = Text('turtle turtles turtle_1 a.turtle', 'a')
    everything = Span(0, len(text.text))
    assert text.found('turtles', everything) == Span(7, 14)
    assert text.found('turtle', everything) is None
    assert text.found('urtle_1', everything) is None


def test_a_call_reaches_over_its_lines_and_a_tag_to_its_end() -> None:
    text = Text('f(\n  a=1,\n)\ng()\n', 'a.py')
    assert text.text[slice(*text.extent(1))] == 'f(\n  a=1,\n)'
    text = Text('<launch>\n  <node\n pkg="a"/>\n', 'a.xml')
    assert text.text[slice(*text.extent(2))] == '<node\n pkg="a"/>'

"""What is not markup is escaped."""

from __future__ import annotations

from html.parser import HTMLParser

from edugrade.reports.markup import Markup, element, joined
from hypothesis import given
from hypothesis import strategies as st


class Reader(HTMLParser):
    def __init__(self) -> None:
        super().__init__()
        self.tags: list[tuple[str, dict[str, str | None]]] = []
        self.text = ''

    def handle_starttag(self, tag: str, attrs: list[tuple[str, str | None]]) -> None:
        self.tags.append((tag, dict(attrs)))

    def handle_data(self, data: str) -> None:
        self.text += data


def test_elements_nest_and_texts_are_escaped() -> None:
    inner = element('b', 'a < b')
    assert element('p', inner, ' & c', class_='x') == '<p class="x"><b>a &lt; b</b> &amp; c</p>'
    assert element('img', alt='"') == '<img alt="&quot;">'
    assert element('meta', http_equiv='x') == '<meta http-equiv="x">'


def test_markup_is_left_alone() -> None:
    assert joined(Markup('<i>'), '<i>') == '<i>&lt;i&gt;'


@given(st.text(st.characters(codec='utf-8', categories=('L', 'N', 'P', 'S'), include_characters=' ')))
def test_any_text_comes_back_as_text_and_adds_no_element(text: str) -> None:
    reader = Reader()
    reader.feed(element('p', text, title=text))
    reader.close()
    assert (reader.tags, reader.text) == ([('p', {'title': text})], text)

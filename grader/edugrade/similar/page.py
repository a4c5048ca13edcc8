"""The page of ``edugrade similar``: pairs, side by side."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import zip_longest

from ..markup import Markup, element
from .fingerprints import Code
from .pairs import Pair, Work

POLICY = "default-src 'none'; style-src 'unsafe-inline'"
STYLE = """
body { font: 15px/1.4 system-ui, sans-serif; margin: 2em; color: #222; }
td, th { text-align: left; vertical-align: top; padding: .15em 1.2em .15em 0; }
.side { display: grid; grid-template-columns: 1fr 1fr; gap: 1em; } pre { overflow-x: auto; margin: 0; }
mark { background: #ffe9a8; } .same { background: #d9ecff; }
"""
WORDS = (
    'These submissions have more in common than the task and the class explain. Names, comments, texts and numbers make no '
    'difference here; marked lines are alike. This is a reason to look and to ask, and no proof.'
)
MOST_PAIRS = 100
MOST_LINES = 2000


def similar_page(exercise: str, pairs: Sequence[Pair]) -> str:
    """The whole page. Nothing that a student wrote is markup in it."""
    rows = [element('tr', *(element('th', name) for name in ('pair', 'code', 'launch graph')))]
    for number, pair in enumerate(pairs[:MOST_PAIRS]):
        link = element('a', f'{pair.one.student} and {pair.two.student}', href=f'#p{number}')
        rows.append(element('tr', *(element('td', cell) for cell in (link, f'{pair.code:.0%}', f'{pair.graph:.0%}'))))
    head = element(
        'head',
        element('meta', charset='utf-8'),
        element('meta', http_equiv='Content-Security-Policy', content=POLICY),
        element('title', f'edugrade similar: {exercise}'),
        element('style', Markup(STYLE)),
    )
    parts = [element('h1', f'Alike: {exercise}'), element('p', WORDS), element('table', *rows)]
    parts += [_section(pair, number) for number, pair in enumerate(pairs[:MOST_PAIRS])]
    return f'<!doctype html>\n{element("html", head, element("body", *parts), lang="en")}\n'


def _section(pair: Pair, number: int) -> Markup:
    both = set(pair.one.graph) & set(pair.two.graph)
    sides = [
        element('div', element('h3', work.path), *_texts(work, pair.shared), _graph(work, both)) for work in (pair.one, pair.two)
    ]
    title = f'{pair.one.student} and {pair.two.student}: code {pair.code:.0%}, launch graph {pair.graph:.0%}'
    return element('section', element('h2', title), element('div', *sides, class_='side'), id=f'p{number}')


def _texts(work: Work, shared: frozenset[int]) -> list[Markup]:
    """The files that have something shared in them, with those lines marked."""
    found = []
    for name, code in work.texts.items():
        marked = {line for number, (first, last) in code.prints.items() if number in shared for line in range(first, last + 1)}
        if marked:
            found += [element('h4', name), element('pre', *_lines(code, marked))]
    return found


def _lines(code: Code, marked: set[int]) -> list[Markup]:
    lines = []
    for number, line in zip_longest(range(1, min(len(code.lines), MOST_LINES) + 1), code.lines[:MOST_LINES]):
        text = f'{number:4} {line}'
        lines.append(Markup((element('mark', text) if number in marked else element('span', text)) + '\n'))
    return lines


def _graph(work: Work, both: set[str]) -> Markup:
    rows = [element('li', line, class_='same' if line in both else '') for line in work.graph]
    return element('details', element('summary', f'launch graph, {len(work.graph)} lines'), element('ul', *rows))

"""Build the page that compares two plans or two runs. It shows both graphs and a list of the differences."""

from __future__ import annotations

import html
from base64 import b64encode
from collections.abc import Sequence
from typing import Any

SIGNS = {'+': ('new', 'only in the second'), '-': ('gone', 'only in the first'), '~': ('changed', 'differs')}
"""The CSS class and the meaning of each sign."""
STYLE = """
:root { color-scheme: light dark; --ink: #1b1b1b; --paper: #fff; --new: #265cb2; --gone: #964e00; --changed: #1b1b1b; }
@media (prefers-color-scheme: dark) {
  :root { --ink: #eee; --paper: #16181c; --new: #8cc4ff; --gone: #ffb454; --changed: #eee; }
}
body { font: 16px/1.5 system-ui, sans-serif; color: var(--ink); background: var(--paper); margin: 1rem auto; padding: 0 1rem; }
h1 { font-size: 1.2rem; overflow-wrap: anywhere; }
img { max-width: 100%; height: auto; background: #fff; border-radius: 4px; }
td, th { text-align: left; vertical-align: top; padding: .15rem .8rem .15rem 0; overflow-wrap: anywhere; }
td:first-child { white-space: nowrap; font-weight: 600; }
.new td:first-child { color: var(--new); }
.gone td:first-child { color: var(--gone); }
.changed td:first-child { color: var(--changed); }
"""


def compared_page(first: str, second: str, found: Sequence[str], picture: Any) -> str:
    """Return the page as HTML. The page needs no other file and no network.

    :param first: the name of the first plan or run.
    :param second: the name of the second plan or run.
    :param found: the differences. Each string begins with a sign and a space.
    :param picture: the picture of both graphs, an :class:`edulaunch.canvas.picture.Picture`.
    """
    title = html.escape(f'{first} and {second}')
    image = f'data:image/png;base64,{b64encode(picture.png()).decode()}'
    rows = ''.join(map(_row, found))
    table = f'<table><tr><th>Sign</th><th>What</th></tr>{rows}</table>' if found else '<p>There is no difference.</p>'
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n<meta name="viewport" content="width=device-width">\n'
        '<meta http-equiv="Content-Security-Policy" content="default-src \'none\'; style-src \'unsafe-inline\'; img-src data:">\n'
        f'<title>{title}</title>\n<style>{STYLE}</style>\n<main>\n<h1>{title}</h1>\n'
        f'<img alt="{html.escape(picture.caption)}" src="{image}">\n{table}\n</main>\n</html>\n'
    )


def _row(line: str) -> str:
    look, meaning = SIGNS.get(line[:1], ('', ''))
    return f'<tr class="{look}"><td>{html.escape(line[:1])} {meaning}</td><td>{html.escape(line[2:])}</td></tr>'

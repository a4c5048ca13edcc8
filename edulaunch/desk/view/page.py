"""The front end put together: a page that needs nothing else, and the module that a notebook's widget loads."""

from __future__ import annotations

import html
import json
import re
import zlib
from base64 import b64encode
from functools import cache
from pathlib import Path
from typing import Any

FILES = (
    'dom.js',
    'data.js',
    'tf.js',
    'turtles.js',
    'advice.js',
    'frames.js',
    'layout.js',
    'graph.js',
    'charts.js',
    'series.js',
    'plot.js',
    'tables.js',
    'launch.js',
    'desk.js',
)
"""In the order in which they build on each other; together they are one script."""


@cache
def script() -> str:
    """All of the front end as one script without imports; it defines `openDesk` and `unpacked`."""
    folder = Path(__file__).with_name('page')
    style = json.dumps(_short((folder / 'style.css').read_text(encoding='utf-8')))
    parts = [_short((folder / name).read_text(encoding='utf-8')) for name in FILES]
    return '\n'.join([f'const STYLE = {style};', *parts])


def _short(text: str) -> str:
    """A file of the page without comments on lines of their own and without indents: each stored notebook holds all of it."""
    return re.sub(r'(?m)^\s+', '', re.sub(r'(?ms)^ */\*(?:(?!\*/).)*\*/ *$\n?', '', text))


def module() -> str:
    """The script as an ES module with `render`, as anywidget asks for."""
    link = (Path(__file__).with_name('page') / 'widget.js').read_text(encoding='utf-8')
    return f'{script()}\n{link}'


def packed(delta: dict[str, Any], small: bool = True) -> str:
    """A timeline delta as text for a page: JSON in base64 behind a letter, deflated if it is to be small.

    Deflated bytes differ between versions of zlib; what a notebook stores is to be equal everywhere, and is not deflated.
    """
    data = json.dumps(delta, separators=(',', ':')).encode()
    return 'z' + b64encode(zlib.compress(data, 9)).decode() if small else 'j' + b64encode(data).decode()


def recorded_page(delta: dict[str, Any], title: str, tab: str = 'graph', *, small: bool = True) -> str:
    """An HTML page that plays a whole timeline, from disk and without a network; `small`: see :func:`packed`."""
    options = json.dumps({'tab': tab, 'whole': True}).replace('</', '<\\/')
    start = (
        f"unpacked('{packed(delta, small)}').then(all => openDesk(document.getElementById('desk'), null, {options}).load(all));"
    )
    return _page(title, start)


def live_page(title: str, tab: str = 'graph') -> str:
    """The page beside a terminal: it talks to the server that it came from."""
    link = (Path(__file__).with_name('page') / 'socket.js').read_text(encoding='utf-8')
    return _page(
        title, f'{link}\nopenDesk(document.getElementById("desk"), socketLink(), {{ tab: {json.dumps(tab)}, whole: true }});'
    )


def _page(title: str, start: str) -> str:
    policy = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; connect-src 'self'"
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{policy}">\n'
        f'<title>{html.escape(title)}</title>\n<style>body {{ margin: 0; }}</style>\n<main id="desk"></main>\n'
        f"<script>\n'use strict';\n{script()}\n{start}\n</script>\n</html>\n"
    )

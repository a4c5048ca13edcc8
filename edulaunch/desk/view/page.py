"""Build the front end of the live view: a page that needs no other file, and the script that a notebook's widget loads."""

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
"""The script files in the order of their dependencies. They are joined to one script."""

POLICY = "default-src 'none'; script-src 'unsafe-inline'; style-src 'unsafe-inline'; img-src data:; connect-src 'self'"
"""What a page may load: itself, and the connection to the server that sent it."""


@cache
def script() -> str:
    """Return the front end as one script without imports. It defines `openDesk` and `unpacked`."""
    folder = Path(__file__).with_name('page')
    style = json.dumps(_short((folder / 'style.css').read_text(encoding='utf-8')))
    parts = [_short((folder / name).read_text(encoding='utf-8')) for name in FILES]
    return '\n'.join([f'const STYLE = {style};', *parts])


def _short(text: str) -> str:
    """Return a file of the page without indentation and comment lines, because each stored notebook contains the whole page."""
    return re.sub(r'(?m)^\s+', '', re.sub(r'(?ms)^ */\*(?:(?!\*/).)*\*/ *$\n?', '', text))


def module() -> str:
    """Return the script as an ES module with a function `render`, as anywidget requires."""
    link = (Path(__file__).with_name('page') / 'widget.js').read_text(encoding='utf-8')
    return f'{script()}\n{link}'


def packed(delta: dict[str, Any], small: bool = True) -> str:
    """Return a timeline delta as a string for a page: a letter, then JSON in base64.

    Compressed bytes differ between versions of zlib. Notebooks must store the same bytes everywhere, so they do not
    compress the JSON.

    :param delta: the timeline delta.
    :param small: whether to compress the JSON.
    """
    data = json.dumps(delta, separators=(',', ':')).encode()
    return 'z' + b64encode(zlib.compress(data, 9)).decode() if small else 'j' + b64encode(data).decode()


def recorded_page(delta: dict[str, Any], title: str, tab: str = 'graph', *, small: bool = True) -> str:
    """Return an HTML page that replays a whole timeline without other files or a network. Without scripts, it shows the launch.

    :param delta: the timeline.
    :param title: the title of the page.
    :param tab: the tab that the page shows first.
    :param small: whether to compress the timeline, as in :func:`packed`, and to include the launch for browsers without
        scripts. A page in a notebook's output needs neither.
    """
    options = json.dumps({'tab': tab, 'whole': True}).replace('</', '<\\/')
    start = (
        "const host = document.getElementById('desk');\nhost.attachShadow({ mode: 'open' });\n"
        f"unpacked('{packed(delta, small)}').then(all => openDesk(host, null, {options}).load(all));"
    )
    return _page(title, start, _without_script(delta, title) if small else '')


def _without_script(delta: dict[str, Any], title: str) -> str:
    """Return the launch as HTML. If scripts run, the page replaces this HTML."""
    from edulaunch.desk.view.launch_outline import launch_outline  # imported here, because a live view does not need it

    outline = launch_outline(delta.get('launches', ()), delta['now'])
    style = 'color-scheme: light dark; color: CanvasText; background: Canvas; font: 16px/1.45 system-ui, sans-serif; padding: 1em'
    return f'<div style="{style}"><h1>{html.escape(title)}</h1>{outline}</div>'


def live_page(title: str, tab: str = 'graph') -> str:
    """Return the page of `edulaunch view`, which connects to the server that has sent it."""
    link = (Path(__file__).with_name('page') / 'socket.js').read_text(encoding='utf-8')
    return _page(
        title, f'{link}\nopenDesk(document.getElementById("desk"), socketLink(), {{ tab: {json.dumps(tab)}, whole: true }});'
    )


def _page(title: str, start: str, inside: str = '') -> str:
    return (
        '<!DOCTYPE html>\n<html lang="en">\n<meta charset="utf-8">\n'
        '<meta name="viewport" content="width=device-width, initial-scale=1">\n'
        f'<meta http-equiv="Content-Security-Policy" content="{POLICY}">\n'
        f'<title>{html.escape(title)}</title>\n<style>body {{ margin: 0; }}</style>\n<main id="desk">{inside}</main>\n'
        f"<script>\n'use strict';\n{script()}\n{start}\n</script>\n</html>\n"
    )

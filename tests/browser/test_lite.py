"""The edition for a browser, in one: a launch, checks and Stop, with no other machine within reach. EDULAUNCH_PYODIDE names Pyodide's
folder; without it these are skipped.
"""

from __future__ import annotations

import os
from collections.abc import Iterator
from functools import partial
from http.server import SimpleHTTPRequestHandler, ThreadingHTTPServer
from pathlib import Path
from threading import Thread
from typing import Any

import pytest

from edulaunch.course.lite.site import make_site

pytestmark = pytest.mark.browser

ROOT = Path(__file__).resolve().parents[2]
PATIENCE_MS = 120_000
ENDLESS = 'while True:\n    pass\n'
NEEDS_MORE = ('mast',)
"""Exercises that need packages with C inside which are not in Pyodide's folder: a robot description is read with lxml."""


class Quiet(SimpleHTTPRequestHandler):
    """A plain server of files."""

    extensions_map = {**SimpleHTTPRequestHandler.extensions_map, '.mjs': 'text/javascript', '.wasm': 'application/wasm'}

    def log_message(self, *args: object) -> None:
        """Say nothing."""


@pytest.fixture(scope='module')
def desk(browser: Any, tmp_path_factory: pytest.TempPathFactory) -> Iterator[Any]:
    """The page, with Python loaded."""
    runtime = os.environ.get('EDULAUNCH_PYODIDE')
    if not runtime:
        pytest.skip('EDULAUNCH_PYODIDE does not name a folder of Pyodide')
    site = tmp_path_factory.mktemp('lite') / 'site'
    make_site(str(site), runtime, str(ROOT))
    with ThreadingHTTPServer(('127.0.0.1', 0), partial(Quiet, directory=str(site))) as server:
        Thread(target=server.serve_forever, daemon=True).start()
        page = browser.new_page(viewport={'width': 1400, 'height': 850})
        here = f'http://127.0.0.1:{server.server_port}/'
        elsewhere: list[str] = []
        page.on('request', lambda asked: asked.url.startswith((here, 'blob:', 'data:', 'about:')) or elsewhere.append(asked.url))
        page.goto(here)
        yield ready(page)
        assert elsewhere == []
        page.close()
        server.shutdown()


def ready(page: Any) -> Any:
    page.wait_for_function("!document.getElementById('launch').disabled", timeout=PATIENCE_MS)
    return page


def choose(page: Any, name: str) -> None:
    titles = page.eval_on_selector_all('#files option', 'all => all.map((each) => each.textContent)')
    page.select_option('#files', label=next(title for title in titles if name in title))


def test_a_launch_is_printed_and_played(desk: Any, shots: Path) -> None:
    choose(desk, 'turtle_tf2_demo')
    desk.click('#launch')
    assert 'Spawning turtle [turtle2]' in ready(desk).inner_text('#log')
    desk.frame_locator('#page').get_by_text('12.00 s recorded').wait_for()
    desk.screenshot(path=shots / 'lite_launch.png')


def test_solutions_pass_and_stubs_do_not(desk: Any, shots: Path) -> None:
    files = [path for path in sorted((ROOT / 'solutions').glob('*.launch.*')) if path.name.split('.')[0] not in NEEDS_MORE]
    for path in files:
        name, stub = path.name.split('.')[0], (ROOT / 'exercises' / path.name).read_text(encoding='utf-8')
        for index in range(desk.locator('#files option').count()):
            desk.select_option('#files', index=index)
            if desk.input_value('#text') == stub:
                break
        desk.click('#check')
        assert ready(desk).inner_text('#log').strip() == f'{name}: some failed'
        desk.fill('#text', path.read_text(encoding='utf-8'))
        desk.click('#check')
        assert ready(desk).inner_text('#log').strip() == f'{name}: all passed'
        desk.click('#again')
    assert len(files) >= 18
    desk.screenshot(path=shots / 'lite_check.png')


def test_what_never_ends_is_stopped(desk: Any) -> None:
    choose(desk, 'multisim')
    desk.fill('#text', ENDLESS)
    desk.click('#launch')
    desk.click('#stop')
    assert 'stopped' in desk.inner_text('#log')
    ready(desk).click('#again')
    desk.click('#launch')
    assert 'Spawning turtle [turtle1]' in ready(desk).inner_text('#log')

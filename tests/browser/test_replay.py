"""The replay in a real browser: a page on disk, no network."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import edulaunch


@pytest.fixture(scope='module')
def cell(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A page with the output of a cell that shows a replay, as an exported notebook has it."""
    replay = edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=6.0).replay()
    page = tmp_path_factory.mktemp('replay') / 'cell.html'
    page.write_text(f'<!DOCTYPE html><meta charset="utf-8"><body>{replay.html()}</body>', encoding='utf-8')
    return page


class Shown:
    """The page in the browser: its player, the errors in it, and what it asked other machines for."""

    def __init__(self, page: Any, address: str) -> None:
        self.page = page
        self.errors: list[str] = []
        self.requests: list[str] = []
        page.on('pageerror', lambda error: self.errors.append(str(error)))
        page.on('request', lambda request: self.requests.append(request.url))
        page.goto(address)
        self.player = page.frame_locator('iframe')
        self.player.locator('body.ready').wait_for()

    def text(self, name: str) -> str:
        return str(self.player.locator(name).text_content())

    def picture(self) -> str:
        return str(self.player.locator('canvas').first.evaluate('canvas => canvas.toDataURL()'))

    def move_slider(self, sample: int) -> None:
        self.player.locator('#slider').evaluate(
            f'slider => {{ slider.value = {sample}; slider.dispatchEvent(new Event("input")); }}'
        )


@pytest.fixture
def shown(browser: Any, cell: Path) -> Iterator[Shown]:
    context = browser.new_context(viewport={'width': 900, 'height': 620}, offline=True)
    shown = Shown(context.new_page(), cell.as_uri())
    yield shown
    assert shown.errors == []
    assert [url for url in shown.requests if not url.startswith(('file:', 'data:', 'about:'))] == []
    context.close()


def test_the_slider_moves_the_turtle(shown: Shown) -> None:
    before = (shown.text('#twin'), shown.picture())
    shown.move_slider(100)
    assert shown.text('#clock') == '5.00 s'
    assert shown.text('#twin') != before[0] and shown.picture() != before[1]
    assert 'turtle2 (' in str(shown.player.locator('canvas').first.get_attribute('aria-label'))


def test_play_runs_and_pause_stands_still(shown: Shown) -> None:
    shown.player.locator('#speed').select_option('1')
    shown.player.locator('#play').click()
    shown.player.locator('#clock').evaluate(
        'clock => new Promise(done => { (function look() { parseFloat(clock.textContent) > 0.5 ? done() : setTimeout(look, 10) })() })'
    )
    shown.player.locator('#play').click()
    assert 'Play' in shown.text('#play')
    stopped = shown.text('#clock')
    shown.page.wait_for_timeout(100)
    assert shown.text('#clock') == stopped


def test_the_keyboard_plays_steps_and_jumps(shown: Shown) -> None:
    shown.player.locator('canvas').first.click()
    for key, clock in (
        ('ArrowRight', '0.05 s'),
        ('Shift+ArrowRight', '1.05 s'),
        ('End', '6.00 s'),
        ('ArrowLeft', '5.95 s'),
        ('Home', '0.00 s'),
    ):
        shown.page.keyboard.press(key)
        assert shown.text('#clock') == clock
    shown.page.keyboard.press(' ')
    assert 'Pause' in shown.text('#play')


def test_tf_frames_are_shown_on_demand(shown: Shown) -> None:
    shown.move_slider(100)
    before = shown.picture()
    shown.player.locator('#frames').check()
    assert shown.picture() != before
    shown.player.locator('#frames').uncheck()
    assert shown.picture() == before


def test_where_frames_are_taken_out_the_filmstrip_is_seen(browser: Any, cell: Path) -> None:
    page = browser.new_page()
    text = cell.read_text(encoding='utf-8')
    page.set_content(text[: text.index('<iframe')] + '</div></body>')
    strip = page.locator('img')
    assert strip.is_visible() and strip.evaluate('image => image.naturalWidth') > 500
    assert str(strip.get_attribute('alt')).startswith('replay of 6.00 s: /sim with turtle1, turtle2')
    page.close()

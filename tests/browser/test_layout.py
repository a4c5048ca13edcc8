"""The graph of the page: laid out as the stills are, drawn to the width at hand, zoomed by keys."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.view import page as page_module
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.replay import timeline_of
from tests.browser.desk import Desk

pytestmark = pytest.mark.browser
ROOT = Path(__file__).resolve().parents[2]
CASES = json.loads((ROOT / 'tests' / 'canvas' / 'layouts.json').read_text(encoding='utf-8'))
LAYOUT = Path(page_module.__file__).with_name('page') / 'layout.js'


def test_the_page_lays_graphs_out_as_python_does(browser: Any) -> None:
    page = browser.new_page()
    script = LAYOUT.read_text(encoding='utf-8')
    found = page.evaluate(
        f'cases => {{ {script}; return cases.map(one => layOut(one.sizes, one.edges, one.direction)); }}',
        [{name: case[name] for name in ('sizes', 'edges', 'direction')} for case in CASES],
    )
    page.close()
    for case, layout in zip(CASES, found, strict=True):
        assert layout['direction'] == case['chosen']
        for name in ('width', 'height', 'corners', 'routes'):
            assert flat(layout[name]) == pytest.approx(flat(case[name]), abs=0.011)


def flat(value: Any) -> list[float]:
    return [number for part in value for number in flat(part)] if isinstance(value, list) else [value]


@pytest.fixture(scope='module')
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    recording = edulaunch.run(ROOT / 'tests' / 'benchmarks' / 'large_project.launch.py', duration_s=3)
    path = tmp_path_factory.mktemp('graph') / 'large.html'
    path.write_text(recorded_page(timeline_of(recording), 'large'))
    return path


@pytest.mark.parametrize('width', [900, 1120, 1400])
def test_the_graph_is_as_wide_as_there_is_room_and_keys_zoom_it(browser: Any, file: Path, shots: Path, width: int) -> None:
    context = browser.new_context(viewport={'width': width, 'height': 860})
    desk = Desk(context.new_page())
    desk.page.goto(file.as_uri())
    desk.open('graph')
    desk.seek(1.0)
    frame = desk.page.locator('.graph')
    inner, outer = (frame.locator('svg').bounding_box() or {}), (frame.bounding_box() or {})
    assert outer['x'] <= inner['x'] and inner['x'] + inner['width'] <= outer['x'] + outer['width'] + 1
    frame.focus()
    desk.page.keyboard.press('+')
    assert (frame.locator('svg').bounding_box() or {})['width'] > inner['width']
    desk.page.keyboard.press('0')
    assert (frame.locator('svg').bounding_box() or {})['width'] == pytest.approx(inner['width'], abs=2)
    desk.page.screenshot(path=shots / f'graph-{width}.png')
    assert desk.errors == []
    context.close()


def test_the_height_does_not_jump_between_tabs(browser: Any, file: Path) -> None:
    context = browser.new_context(viewport={'width': 1200, 'height': 860})
    desk = Desk(context.new_page())
    desk.page.goto(file.as_uri())
    places = set()
    for tab in ('launch', 'frames', 'tree', 'graph', 'timeline', 'plot', 'log', 'parameters', 'terminal'):
        desk.open(tab)
        desk.frame()
        places.add(round((desk.page.locator('footer').bounding_box() or {})['y']))
    assert len(places) == 1
    context.close()

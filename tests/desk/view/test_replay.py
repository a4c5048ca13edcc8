"""The replay as a cell, a page and a strip of pictures."""

from __future__ import annotations

import html
import re
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

import edulaunch
from edulaunch.canvas.picture import SCENE_TYPE


@pytest.fixture(scope='module')
def large() -> Any:
    """Twenty seconds of the large project: two worlds, three turtles."""
    return edulaunch.run(Path(__file__).parents[2] / 'benchmarks' / 'large_project.launch.py', duration_s=20.0)


def test_the_repr_is_one_line(walk: Any) -> None:
    assert repr(walk(0.0, 2.0).replay()) == 'replay of 2.00 s: /sim with turtle1'


def test_the_cell_shows_a_frame_over_the_filmstrip(walk: Any) -> None:
    text = walk(0.0, 2.0).replay().html()
    assert 'sandbox="allow-scripts"' in text and text.index('<img alt="replay of') < text.index('<iframe title="replay of')
    inner = html.unescape(re.search(r'srcdoc="(.*?)"', text, re.DOTALL).group(1))  # type: ignore[union-attr]
    assert inner.startswith('<!DOCTYPE html>')


def test_twenty_seconds_take_less_than_440_kilobytes(large: Any) -> None:
    bundle = large.replay()._repr_mimebundle_()
    assert sum(map(len, bundle.values())) < 440_000  # 140 of them are the page itself
    assert set(bundle) == {'text/plain', 'text/html', SCENE_TYPE} and bundle['text/plain'].startswith('replay of 20.00 s')


def test_the_filmstrip_shows_eight_times_with_what_moved(walk: Any) -> None:
    strip = ElementTree.fromstring(walk(0.0, 2.0).replay().filmstrip())
    kinds = [item.tag.rpartition('}')[2] for item in strip]
    assert kinds == ['text', 'svg'] * 8 and [strip[0].text, strip[14].text] == ['t = 0.0 s', 't = 2.0 s']
    last = [item for item in strip[15] if item.tag.endswith('polyline')]
    scale = 500 / 11.088889
    ends = [float(value) / scale for pair in last[0].get('points', '').split() for value in pair.split(',')]
    assert ends == pytest.approx([2.0, 11.088889 - 3.0, 4.0, 11.088889 - 3.0], abs=0.01)


def test_a_saved_page_is_the_player(walk: Any, tmp_path: Path) -> None:
    replay = walk(0.0, 1.0).replay()
    replay.save(tmp_path / 'walk.html')
    assert (tmp_path / 'walk.html').read_text(encoding='utf-8') == replay.page()


def test_another_run_goes_with_the_page() -> None:
    runs = [edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=seconds) for seconds in (1, 2)]
    delta = runs[0].replay(runs[1]).timeline
    assert (delta['now'], delta['other']['now']) == (1_000_000, 2_000_000)
    assert 'other' not in runs[0].replay().timeline

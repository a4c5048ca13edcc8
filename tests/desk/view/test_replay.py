"""The replay as a cell, a page and a strip of pictures."""

from __future__ import annotations

import html
import re
from pathlib import Path
from typing import Any
from xml.etree import ElementTree

import pytest

import edulaunch
from edulaunch.canvas.filmstrip import still
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
    paper, *strip = ElementTree.fromstring(walk(0.0, 2.0).replay().filmstrip())
    kinds = [item.tag.rpartition('}')[2] for item in strip]
    assert kinds == ['text', 'svg'] * 8 and [strip[0].text, strip[14].text] == ['t = 0.0 s', 't = 2.0 s']
    last = [item for item in strip[15] if item.tag.endswith('polyline')]
    scale = 500 / 11.088889
    ends = [float(value) / scale for pair in last[0].get('points', '').split() for value in pair.split(',')]
    assert ends == pytest.approx([2.0, 11.088889 - 3.0, 4.0, 11.088889 - 3.0], abs=0.01)


@pytest.mark.parametrize('kind', ['filmstrip', 'still'])
def test_what_is_written_in_a_small_picture_is_readable_on_any_page(walk: Any, kind: str) -> None:
    replay = walk(0.0, 2.0).replay()
    picture = ElementTree.fromstring(replay.filmstrip() if kind == 'filmstrip' else still(replay._worlds, 1.0)[0])
    paper = next(item for item in picture if item.tag.endswith('rect'))
    assert [paper.get(side) for side in ('width', 'height')] == [picture.get('width'), picture.get('height')]
    light, dark = (_luminance(str(item.get('fill'))) for item in (paper, picture))
    assert (light + 0.05) / (dark + 0.05) > 4.5
    assert list(picture).index(paper) < min(place for place, item in enumerate(picture) if item.tag.endswith('text'))


def _luminance(colour: str) -> float:
    """The relative luminance of #rrggbb, as the contrast of WCAG 2 uses it."""
    parts = [int(colour[place : place + 2], 16) / 255 for place in (1, 3, 5)]
    lit = [part / 12.92 if part <= 0.04045 else ((part + 0.055) / 1.055) ** 2.4 for part in parts]
    return 0.2126 * lit[0] + 0.7152 * lit[1] + 0.0722 * lit[2]


def test_a_saved_page_is_the_player(walk: Any, tmp_path: Path) -> None:
    replay = walk(0.0, 1.0).replay()
    replay.save(tmp_path / 'walk.html')
    assert (tmp_path / 'walk.html').read_text(encoding='utf-8') == replay.page()


def test_another_run_goes_with_the_page() -> None:
    runs = [edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=seconds) for seconds in (1, 2)]
    delta = runs[0].replay(runs[1]).timeline
    assert (delta['now'], delta['other']['now']) == (1_000_000, 2_000_000)
    assert 'other' not in runs[0].replay().timeline


def test_a_replay_bears_the_name_of_its_launch_file_and_its_own_without_one(large: Any, walk: Any) -> None:
    assert '<title>large_project.launch.py' in large.replay().page() and '<title>replay' in walk(0.0, 2.0).replay().page()

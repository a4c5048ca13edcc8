"""The live view on a busy computer: it leaves out details and never input; a large launch is stepped without writing each row."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.replay import timeline_of
from tests.benchmarks.live_view import timeline
from tests.browser.desk import Desk

pytestmark = pytest.mark.browser
MANY = """
from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([
        Node(package='demo_nodes_py', executable='listener', name=f'n{number}') for number in range(200)
    ])
"""
DRAWN = """times => {
  const { desk } = window, drawn = { tab: 0, worlds: 0, trails: 0 }, [world] = desk.worldViews;
  const counted = (owner, name, kind) => {
    const draw = owner[name];
    owner[name] = (...words) => { drawn[kind]++; return draw.apply(owner, words); };
    return () => { delete owner[name]; };
  };
  const ends = [counted(desk.shown, 'draw', 'tab'), counted(world, 'draw', 'worlds'), counted(world, 'trails', 'trails')];
  desk.asked = 1;  // no picture of its own in between
  for (let i = 0; i < times; i++) { desk.time += 0.01; desk.beat(performance.now()); }
  desk.asked = 0;
  ends.forEach(end => end());
  return drawn;
}"""

BODIES = """() => {  // the same turtle at three angles, drawn for a few turtles and for a crowd
  const [view] = window.desk.worldViews, pen = view.canvas.getContext('2d'), [mover] = view.world.movers, ground = view.background(0);
  const picture = (many, a) => {
    view.here = Array(many).fill({});
    pen.fillStyle = ground;
    pen.fillRect(0, 0, view.side, view.side);
    view.body(pen, mover, { x: 5.5, y: 5.5, a });
    return pen.getImageData(0, 0, view.canvas.width, view.canvas.height).data;
  };
  const differs = (one, two) => one.reduce((sum, value, i) => sum + (Math.abs(value - two[i]) > 90), 0);
  return [0, 0.5, -2.4].map(a => [differs(picture(1, a), picture(100, a)), differs(picture(1, a), picture(100, a + 1.5))]);
}"""
TURNED = """() => {
  const [view] = window.desk.worldViews, pen = view.canvas.getContext('2d');
  let turned = 0;
  pen.rotate = () => { turned++; };
  view.draw(window.desk.time);
  return turned;
}"""


@pytest.fixture
def page_of(browser: Any, tmp_path: Path) -> Iterator[Any]:
    contexts = []

    def opened(delta: dict[str, Any], tab: str) -> Desk:
        file = tmp_path / 'page.html'
        file.write_text(recorded_page(delta, 'busy', tab).replace('.load(all)', '.load(all, window)'), encoding='utf-8')
        contexts.append(browser.new_context(viewport={'width': 1400, 'height': 860}))
        desk = Desk(contexts[-1].new_page())
        desk.page.goto(file.as_uri())
        desk.page.wait_for_function('() => window.desk && window.desk.worldViews')
        return desk

    yield opened
    for context in contexts:
        context.close()


def test_slow_pictures_leave_out_details_until_pictures_are_fast_again(page_of: Any) -> None:
    desk = page_of(timeline(3, 12, 20), 'frames')
    run = desk.page.evaluate
    run('() => { window.desk.playing = true; window.desk.asked = 1; }')
    assert run(DRAWN, 16) == {'tab': 16, 'worlds': 16, 'trails': 16}
    run('() => { for (let i = 0; i < 60; i++) window.desk.effort.took(60); }')
    assert run(DRAWN, 16) == {'tab': 8, 'worlds': 16, 'trails': 8}
    run('() => { for (let i = 0; i < 60; i++) window.desk.effort.took(200); }')
    assert run(DRAWN, 16) == {'tab': 4, 'worlds': 16, 'trails': 4}
    run('() => { window.desk.playing = false; }')
    assert run(DRAWN, 16) == {'tab': 16, 'worlds': 16, 'trails': 16}, 'a picture that stands still is complete'
    run('() => { window.desk.playing = true; for (let i = 0; i < 60; i++) window.desk.effort.took(5); }')
    assert run(DRAWN, 16) == {'tab': 16, 'worlds': 16, 'trails': 16}


def test_input_is_never_left_out(page_of: Any) -> None:
    desk = page_of(timeline(3, 12, 600), 'frames')
    desk.page.locator('.worlds canvas').first.focus()
    desk.page.evaluate('() => { window.desk.effort.took = () => {}; window.desk.effort.level = 2; window.desk.toggle(); }')
    desk.page.wait_for_function('() => window.desk.time > 0')
    desk.page.keyboard.press('Space')
    assert desk.page.evaluate('window.desk.playing') is False
    before = desk.page.evaluate('window.desk.time')
    for _ in range(3):
        desk.page.keyboard.press('ArrowRight')
    assert desk.page.evaluate('window.desk.time') == pytest.approx(before + 3 * 0.016, abs=0.017)


def test_a_crowd_is_drawn_from_turned_copies_that_look_like_a_single_turtle(page_of: Any) -> None:
    desk = page_of(timeline(100, 200, 2), 'graph')
    for equal, other in desk.page.evaluate(BODIES):
        assert equal < other / 4, 'the copy of an angle is not the turtle at this angle'
    assert desk.page.evaluate(TURNED) == 0


def test_while_time_passes_only_rows_in_view_are_written(page_of: Any) -> None:
    desk = page_of(timeline(3, 200, 20), 'frames')
    desk.seek(0.2)
    column = '() => [...window.desk.views.frames[0].table.rows].slice(1).map(row => row.cells[2].textContent)'
    before = desk.page.evaluate(column)
    desk.page.wait_for_function('() => window.desk.views.frames[0].visible.size < 60')
    desk.page.evaluate('() => { window.desk.toggle(); }')
    desk.page.wait_for_function('() => window.desk.time > 5')
    desk.page.locator('table.small tr').last.scroll_into_view_if_needed()
    desk.page.wait_for_function(
        'text => window.desk.views.frames[0].table.rows[200].cells[2].textContent !== text', arg=before[-1]
    )
    playing = desk.page.evaluate(column)
    assert playing[100] == before[100], 'a row that nobody sees was written'
    desk.page.evaluate('() => { window.desk.toggle(); }')
    desk.frame()
    assert [text for text, old in zip(desk.page.evaluate(column), before, strict=True) if text == old] == []


def test_a_step_of_a_large_launch_writes_only_the_rows_that_change(page_of: Any, tmp_path: Path) -> None:
    path = tmp_path / 'many.launch.py'
    path.write_text(MANY, encoding='utf-8')
    desk = page_of(timeline_of(edulaunch.run(path, duration_s=0.2)), 'launch')
    desk.press('step through the launch again')
    desk.frame()
    written = 'window.desk.views.launch[0].written'
    for title in ('to the next action, also', 'to the next action, also', 'back to the previous action'):
        before = desk.page.evaluate(written)
        desk.press(title)
        desk.frame()
        assert 0 < desk.page.evaluate(written) - before <= 6
    assert desk.page.locator('.step').count() == 201

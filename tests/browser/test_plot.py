"""The tab Plot: fields, transforms with their gaps, expressions, and another run over this one."""

from __future__ import annotations

import math
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from edulaunch.desk.view.page import recorded_page
from tests.browser.desk import Desk

pytestmark = pytest.mark.browser
US, FINE = 1_000_000, 10_000


def steps(values: list[float], scale: int) -> list[int]:
    whole = [round(value * scale) for value in values]
    return [after - before for before, after in zip([0, *whole], whole, strict=False)]


def track(child: str, parent: str, times: list[float], xs: list[float], yaw: float = 0.0, static: bool = False) -> dict[str, Any]:
    """A child frame at `xs`, published at `times` (seconds)."""
    fixed = [0.0, 0.0, 0.0, 0.0, math.sin(yaw / 2), math.cos(yaw / 2)]
    columns = [steps(times, US), steps(times, US), steps(xs, FINE)]
    columns += [steps([value] * len(times), FINE * (1 if place < 2 else 100)) for place, value in enumerate(fixed)]
    return {'child': child, 'parent': parent, 'by': 0, 'static': static, 'c': columns}


def run(speed: float, until: int = 101) -> dict[str, Any]:
    """Ten seconds. The base moves at `speed`, and its transform is missing from 4 s to 6 s; a number is published each second."""
    times = [number / 10 for number in range(1, until) if not 40 < number < 60]
    whole = [float(number) for number in range(11)]
    return {
        'start': 0,
        'now': 10 * US,
        'tf': [
            track('base', 'world', times, [speed * time for time in times]),
            track('camera', 'base', [0.1], [0.5], math.pi / 2, static=True),
        ],
        'topics': [
            {
                'name': '/battery/state',
                'type': 'x/msg/State',
                't': steps(whole, US),
                'fields': [['volts', 'float'], ['name', 'text']],
                'c': [steps([12 - number / 10 for number in whole], FINE), ['a'] * 11],
            }
        ],
    }


@pytest.fixture(params=[('light', 900), ('light', 1400), ('dark', 900), ('dark', 1400)], ids=lambda look: f'{look[0]}-{look[1]}')
def look(request: Any) -> tuple[str, int]:
    found: tuple[str, int] = request.param
    return found


@pytest.fixture
def desk(look: tuple[str, int], browser: Any, tmp_path: Path) -> Iterator[Desk]:
    (tmp_path / 'run.html').write_text(recorded_page(run(1.0), 'run', 'plot'))
    (tmp_path / 'other.html').write_text(recorded_page(run(2.0), 'other', 'plot'))
    context = browser.new_context(viewport={'width': look[1], 'height': 860}, color_scheme=look[0])
    desk = Desk(context.new_page(), ('file:',))
    desk.page.goto((tmp_path / 'run.html').as_uri())
    desk.page.get_by_label('an expression to plot').wait_for()
    yield desk
    assert desk.errors == []
    context.close()


def write(desk: Desk, text: str) -> str:
    """Type an expression; returns what is wrong with it, or ''."""
    field = desk.page.get_by_label('an expression to plot')
    field.fill(text)
    field.press('Enter')
    return str(desk.page.locator('.panel [role=alert]').text_content())


def told(desk: Desk) -> str:
    desk.frame()
    return str(desk.page.locator('.panel canvas').get_attribute('aria-label'))


def test_a_transform_is_plotted_with_its_gaps(desk: Desk) -> None:
    page = desk.page
    page.get_by_label('plot: seen from the frame').select_option('world')
    page.get_by_label('plot: the frame').select_option('camera')
    desk.press('add this transform')
    page.get_by_label('plot: part of the transform').select_option('yaw')
    desk.press('add this transform')
    desk.seek(0.3)
    assert told(desk).startswith('tf(world, camera).x is 3.5 at 3.00 s, with 1 gap of 2.00 s')
    assert 'tf(world, camera).yaw is 1.5708' in told(desk)
    desk.seek(0.5)
    assert 'tf(world, camera).x is none' in told(desk)
    desk.seek(0.8)
    assert 'tf(world, camera).x is 8.5' in told(desk)


@pytest.mark.parametrize('look', [('light', 1400)], indirect=True)
def test_a_line_ends_where_the_transform_does(desk: Desk, tmp_path: Path) -> None:
    (tmp_path / 'short.html').write_text(recorded_page(run(1.0, 81), 'run', 'plot'))
    desk.page.goto((tmp_path / 'short.html').as_uri())
    assert write(desk, 'tf(world, base).x') == ''
    desk.seek(0.8)
    assert 'tf(world, base).x is 8 ' in told(desk)
    desk.seek(0.95)
    assert 'tf(world, base).x is none' in told(desk)


def test_an_expression_of_fields_and_transforms(desk: Desk, look: tuple[str, int], shots: Path) -> None:
    assert write(desk, '2 * (/battery/state.volts - 10) ^ 2 / tf(world, base).distance') == ''
    desk.seek(0.2)
    assert f'is {round(2 * 1.8**2 / 2, 4)} at 2.00 s' in told(desk)
    assert write(desk, '-min(/battery/state.volts, 3) + abs(-1)') == ''
    assert ' is -2 at 2.00 s' in told(desk)
    desk.page.screenshot(path=shots / f'plot-{look[0]}-{look[1]}.png')


@pytest.mark.parametrize('look', [('light', 1400)], indirect=True)
def test_what_is_wrong_with_an_expression_is_said(desk: Desk) -> None:
    for text, wrong in {
        '/nowhere.x': 'there is no topic /nowhere',
        '/battery/state.amps': '/battery/state has no number amps; it has volts',
        '/battery/state.name': '/battery/state has no number name',
        'tf(world, arm).x': 'there is no frame arm; there are',
        'tf(world, base).roll': 'a transform has x, y, z, yaw, distance, not roll',
        '(/battery/state.volts': '")" is missing before the end',
        '/battery/state.volts +': 'a value is expected before the end',
        '/battery/state.volts 3': '"3" is not expected here',
        'constructor(/battery/state.volts)': 'there is no function constructor',
        '1 + 1': 'name a field',
        '/battery/state': 'a topic is written with its field',
    }.items():
        assert wrong in write(desk, text), text
    assert desk.page.locator('.key').count() == 0


def test_another_run_is_plotted_over_this_one(desk: Desk, look: tuple[str, int], tmp_path: Path, shots: Path) -> None:
    assert write(desk, 'tf(world, base).x') == ''
    chooser = desk.page.get_by_label('page of another run')
    chooser.set_input_files(tmp_path / 'other.html')
    desk.until('.keys', 'dotted: the other run')
    desk.seek(0.3)
    assert told(desk).startswith('tf(world, base).x is 3 (other run: 6) at 3.00 s')
    desk.page.screenshot(path=shots / f'plot-two-{look[0]}-{look[1]}.png')
    desk.press('take the other run')
    assert told(desk).startswith('tf(world, base).x is 3 at 3.00 s')
    (tmp_path / 'no.html').write_text('hello')
    chooser.set_input_files(tmp_path / 'no.html')
    desk.until('.panel [role=alert]', 'this file is not a page of a run')

"""Parameters with their defaults and as YAML, and the tf tree with rates, ages and lines."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest
import yaml

import edulaunch
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.replay import timeline_of
from tests.browser.desk import Desk

pytestmark = pytest.mark.browser

LAUNCH = """
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{'background_r': 200, 'background_g': 86}]),
        Node(package='turtle_tf2_py', executable='turtle_tf2_broadcaster', name='tf', parameters=[{'turtlename': 'turtle1'}]),
        Node(package='tf2_ros', executable='static_transform_publisher', name='fixed', arguments=['--frame-id', 'turtle1', '--child-frame-id', 'hat']),
    ])
"""


@pytest.fixture(scope='module')
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    folder = tmp_path_factory.mktemp('parameters')
    launch = folder / 'my.launch.py'
    launch.write_text(LAUNCH)
    page = folder / 'run.html'
    page.write_text(recorded_page(timeline_of(edulaunch.run(launch, duration_s=2)), 'run', 'parameters'))
    return page


@pytest.fixture(params=[('light', 900), ('light', 1400), ('dark', 900), ('dark', 1400)], ids=lambda look: f'{look[0]}-{look[1]}')
def desk(request: Any, browser: Any, file: Path, shots: Path) -> Iterator[Desk]:
    context = browser.new_context(viewport={'width': request.param[1], 'height': 860}, color_scheme=request.param[0])
    desk = Desk(context.new_page(), ('file:', 'blob:'))
    desk.page.goto(file.as_uri())
    desk.page.locator('.params').wait_for()
    desk.seek(1.0)
    yield desk
    desk.page.screenshot(path=shots / f'{request.node.originalname}-{request.param[0]}-{request.param[1]}.png')
    assert desk.errors == []
    context.close()


def rows(desk: Desk) -> dict[str, str]:
    """Parameter -> default, of the table."""
    desk.frame()
    cells = desk.page.locator('.params').evaluate(
        'table => [...table.rows].slice(1).map(row => [...row.cells].map(cell => cell.firstChild?.textContent ?? ""))'
    )
    return {f'{row[0]} {row[1]}': row[3] for row in cells}


def test_a_value_that_differs_from_its_default_is_marked(desk: Desk) -> None:
    every = rows(desk)
    assert every['/sim background_r'] == '≠ 69' and every['/sim background_g'] == 'the same'
    assert every['/tf turtlename'] == '≠ turtle'
    desk.page.get_by_label('only differences from the defaults').check()
    assert '/sim background_g' not in rows(desk) and rows(desk)['/sim background_r'] == '≠ 69'
    with desk.page.expect_download() as download:
        desk.press('save the parameters')
    saved = yaml.safe_load(Path(download.value.path()).read_text())
    assert saved['/sim'] == {'ros__parameters': {'background_r': 200}}
    assert saved['/tf'] == {'ros__parameters': {'turtlename': 'turtle1'}}
    assert desk.page.locator('.yaml').inner_text().startswith('/sim:\n  ros__parameters:\n    background_r: 200\n')


def test_the_tree_says_how_often_how_old_by_whom_and_where(desk: Desk) -> None:
    desk.open('tree')
    desk.frame()
    text = desk.page.locator('.tree').first.inner_text()
    assert 'static, by /fixed (launched at my.launch.py:9)' in text
    assert ' Hz, 0.0' in text and ' s old, by /tf (launched at my.launch.py:8)' in text

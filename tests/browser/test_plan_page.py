"""The page of a plan: the graph before the launch runs, in light and dark, at two widths."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.cli.main import main
from edulaunch.desk.view.planned import planned_page
from tests.browser.desk import Desk

pytestmark = pytest.mark.browser
TWO = """from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    name = LaunchConfiguration('name')
    node = Node(package='turtlesim', executable='turtlesim_node', name=name)
    return LaunchDescription([DeclareLaunchArgument('name', default_value='a'), node])
"""
ROOT = Path(__file__).resolve().parents[2]


def violations(page: Any, axe: str) -> list[Any]:
    page.add_script_tag(content=axe)
    result = page.evaluate('axe.run(document, { resultTypes: ["violations"] })')
    return [(one['id'], [node['html'] for node in one['nodes']]) for one in result['violations']]


@pytest.fixture(scope='module')
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    project = ROOT / 'exercises' / 'large_project'
    system = edulaunch.explain('large_project', 'large_project.launch.py', workspaces=[project]).system()
    path = tmp_path_factory.mktemp('plan') / 'plan.html'
    path.write_text(planned_page(system))
    return path


@pytest.mark.parametrize(('scheme', 'width'), [('light', 900), ('light', 1400), ('dark', 900), ('dark', 1400)])
def test_nodes_topics_and_frames_of_the_plan(scheme: str, width: int, browser: Any, file: Path, shots: Path, axe: str) -> None:
    context = browser.new_context(viewport={'width': width, 'height': 860}, color_scheme=scheme, bypass_csp=True)
    desk = Desk(context.new_page(), ('file:',))
    desk.page.goto(file.as_uri())
    desk.page.locator('svg .node').first.wait_for()
    assert desk.page.locator('svg .node').count() == 6 and desk.page.locator('svg .frame').count() == 3
    unknown = desk.page.get_by_role('button', name='/turtle2/pose, no publisher known; this is not known')
    unknown.focus()
    desk.page.keyboard.press('Enter')
    assert '/turtle2/pose turtlesim/msg/Pose: subscription /broadcaster2' in desk.page.locator('.told').inner_text()
    assert desk.page.locator('.state').inner_text() == 'planned; nothing runs'
    assert desk.page.locator('[role=tab]').all_inner_texts() == ['Graph', 'Parameters']
    assert not desk.page.locator('footer').is_visible()
    desk.page.screenshot(path=shots / f'plan-{scheme}-{width}.png')
    assert violations(desk.page, axe) == []
    desk.page.get_by_role('tab', name='Parameters').click()
    desk.page.locator('.params', has_text='background_r').wait_for()
    assert desk.errors == []
    context.close()


@pytest.mark.parametrize(('scheme', 'width'), [('light', 900), ('light', 1400), ('dark', 900), ('dark', 1400)])
def test_two_plans_side_by_side_fit_the_page(
    scheme: str, width: int, browser: Any, tmp_path: Path, shots: Path, axe: str
) -> None:
    page, launch = tmp_path / 'two.html', tmp_path / 'two.launch.py'
    launch.write_text(TWO, encoding='utf-8')
    assert main(['explain', '--diff', str(launch), 'name:=a', 'name:=b', '--graph', str(page)]) == 0
    context = browser.new_context(viewport={'width': width, 'height': 860}, color_scheme=scheme, bypass_csp=True)
    desk = Desk(context.new_page(), ('file:', 'data:'))
    desk.page.goto(page.as_uri())
    desk.page.screenshot(path=shots / f'two-plans-{scheme}-{width}.png', full_page=True)
    assert desk.page.evaluate('() => document.images[0].complete && document.images[0].naturalWidth > 100')
    assert desk.page.evaluate('() => document.documentElement.scrollWidth') <= width
    assert desk.page.locator('tr.gone').first.inner_text().startswith('- only in the first')
    assert '/b' in desk.page.locator('tr.new').first.inner_text() and desk.errors == []
    assert violations(desk.page, axe) == []
    context.close()

"""The page of a plan: the graph before the launch runs, in light and dark, at two widths."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.view.planned import planned_page
from tests.browser.desk import Desk

pytestmark = pytest.mark.browser
ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope='module')
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    project = ROOT / 'exercises' / 'large_project'
    system = edulaunch.explain('large_project', 'large_project.launch.py', workspaces=[project]).system()
    path = tmp_path_factory.mktemp('plan') / 'plan.html'
    path.write_text(planned_page(system))
    return path


@pytest.mark.parametrize(('scheme', 'width'), [('light', 900), ('light', 1400), ('dark', 900), ('dark', 1400)])
def test_nodes_topics_and_frames_of_the_plan(scheme: str, width: int, browser: Any, file: Path, shots: Path) -> None:
    context = browser.new_context(viewport={'width': width, 'height': 860}, color_scheme=scheme)
    desk = Desk(context.new_page(), ('file:',))
    desk.page.goto(file.as_uri())
    desk.page.locator('svg .node').first.wait_for()
    assert desk.page.locator('svg .node').count() == 6 and desk.page.locator('svg .frame').count() == 3
    unknown = desk.page.get_by_role('button', name='/turtle2/pose, not known: no publisher known')
    unknown.focus()
    desk.page.keyboard.press('Enter')
    assert '/turtle2/pose turtlesim/msg/Pose: subscription /broadcaster2' in desk.page.locator('.told').inner_text()
    assert desk.page.locator('.state').inner_text() == 'planned; nothing runs'
    assert desk.page.locator('[role=tab]').all_inner_texts() == ['Graph', 'Parameters']
    assert not desk.page.locator('footer').is_visible()
    desk.page.screenshot(path=shots / f'plan-{scheme}-{width}.png')
    desk.page.get_by_role('tab', name='Parameters').click()
    desk.page.locator('.params', has_text='background_r').wait_for()
    assert desk.errors == []
    context.close()

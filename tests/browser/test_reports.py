"""Reports of the grader and pages of recordings in a real browser: on a phone, without scripts, by keyboard, with axe-core."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import replace
from pathlib import Path
from typing import Any

import pytest
from edugrade import Scenario
from edugrade.classes.batch.entries import Entry
from edugrade.classes.batch.tables import class_page
from edugrade.evidence import Outcome
from edugrade.reports.page import page

import edulaunch
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.replay import timeline_of
from edulaunch.engine.recording import Recording
from tests.browser.desk import Desk
from tests.desk.view.test_launch_outline import FILE
from tests.grader.made_report import FAILED, PASSED, report

pytestmark = pytest.mark.browser
LONG = 'a_name_without_a_place_to_break_' * 4
LINES_OF_LABELS = """() => [...document.querySelectorAll('th[style]')].map(label => {
    const text = document.createRange();
    text.selectNodeContents(label);
    return text.getClientRects().length;
})"""


def test_reports_fit_the_screen_of_a_phone(browser: Any) -> None:
    entry = Entry(f'{LONG}/circle.launch.py', LONG, LONG)
    work = browser.new_page(viewport={'width': 400, 'height': 800})
    for text in (page([report(PASSED, replace(FAILED, seen=LONG), given=LONG)], []), class_page([(entry, None)] * 2, {})):
        work.set_content(text)
        assert work.evaluate('() => document.documentElement.scrollWidth') <= 400
        assert set(work.evaluate(LINES_OF_LABELS)) <= {1}
    work.close()


@pytest.fixture(scope='module')
def recording(tmp_path_factory: pytest.TempPathFactory) -> Recording:
    path = tmp_path_factory.mktemp('reports') / 'demo.launch.py'
    path.write_text(FILE, encoding='utf-8')
    return edulaunch.run(path, duration_s=2)


@pytest.fixture(scope='module')
def pages(recording: Recording, tmp_path_factory: pytest.TempPathFactory) -> dict[str, Path]:
    """A report of the grader with a run, and the page of a recording."""
    folder = tmp_path_factory.mktemp('pages')
    texts = {
        'report': page([report(PASSED, FAILED, outcome=Outcome(Scenario('usual', {}), 'recorded', recording=recording))], []),
        'recording': recorded_page(timeline_of(recording), 'demo', 'launch'),
    }
    for name, text in texts.items():
        (folder / f'{name}.html').write_text(text, encoding='utf-8')
    return {name: folder / f'{name}.html' for name in texts}


@pytest.fixture(params=[('light', 900), ('light', 1400), ('dark', 900), ('dark', 1400)], ids=lambda look: f'{look[0]}-{look[1]}')
def context(request: Any, browser: Any) -> Iterator[Any]:
    """A browser that runs no script of a page."""
    scheme, width = request.param
    found = browser.new_context(
        viewport={'width': width, 'height': 860}, color_scheme=scheme, java_script_enabled=False, bypass_csp=True
    )
    found.look = f'{scheme}-{width}'
    yield found
    found.close()


@pytest.mark.parametrize('name', ['report', 'recording'])
def test_the_launch_can_be_read_and_opened_by_keyboard_without_a_script(
    context: Any, pages: dict[str, Path], shots: Path, name: str
) -> None:
    work = context.new_page()
    work.goto(pages[name].as_uri())
    outside = work.locator('summary', has_text='The launch: its files')
    if name == 'report':
        outside.focus()
        work.keyboard.press('Enter')
    assert work.get_by_text("left out: second is 'false'").is_visible()
    never, runs = work.get_by_text('never fired'), work.get_by_text('running, pid').first
    assert never.is_visible() and never.get_attribute('class') == 'idle'
    colour = 'text => getComputedStyle(text).color'
    assert never.evaluate(colour) != runs.evaluate(colour), 'it is marked'
    origin = work.get_by_text('— default').first
    assert origin.is_hidden()
    inner = work.locator('summary', has_text="argument second = 'false'")
    inner.focus()
    work.keyboard.press('Enter')
    assert origin.is_visible()
    work.screenshot(path=shots / f'outline-{name}-{context.look}.png', full_page=True)


@pytest.mark.parametrize('scheme', ['light', 'dark'])
def test_axe_finds_no_violation_in_a_report(browser: Any, pages: dict[str, Path], axe: str, scheme: str) -> None:
    context = browser.new_context(viewport={'width': 900, 'height': 860}, color_scheme=scheme, bypass_csp=True)
    work = context.new_page()
    work.goto(pages['report'].as_uri())
    work.evaluate("() => document.querySelectorAll('details').forEach(one => { one.open = true; })")
    work.evaluate("() => document.querySelectorAll('iframe').forEach(one => one.remove())")  # test_look.py has the replay
    work.add_script_tag(content=axe)
    result = work.evaluate('axe.run(document, { resultTypes: ["violations"] })')
    assert [(one['id'], [node['html'] for node in one['nodes']]) for one in result['violations']] == []
    context.close()


def test_the_tab_and_the_page_without_a_script_say_the_same_states(browser: Any, pages: dict[str, Path]) -> None:
    context = browser.new_context(viewport={'width': 1400, 'height': 860}, bypass_csp=True)
    desk = Desk(context.new_page())
    desk.page.goto(pages['recording'].as_uri())
    desk.page.locator('.step').first.wait_for()
    desk.seek(1.0)
    shown = desk.page.evaluate(
        """() => [...document.getElementById('desk').shadowRoot.querySelectorAll('.step')]
            .map(step => ['.what', '.state-of', '.at'].map(part => step.querySelector(part).textContent))"""
    )
    told = desk.page.evaluate(
        """() => [...document.querySelectorAll('.launch-outline li')]
            .map(item => item.querySelector(':scope > span, :scope > details > summary > span')).filter(Boolean)
            .map(span => [span, span.nextElementSibling, span.nextElementSibling.nextElementSibling].map(one => one.textContent))"""
    )
    assert len(shown) >= 8
    assert shown == told
    context.close()

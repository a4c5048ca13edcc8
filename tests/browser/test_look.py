"""How the view looks: themes, contrast and names (axe-core), windows of ended programs, and what the page says when nothing moves."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.view.page import recorded_page, script
from edulaunch.desk.view.replay import timeline_of
from edulaunch.engine.recording import Recording
from tests.browser.desk import Desk
from tests.browser.lab import WANTED, Lab, write_notebook

pytestmark = pytest.mark.browser
CONTRAST = """() => {  // text of the view whose contrast with what is behind it is too low, as WCAG 2.2 defines it
  const host = [...document.querySelectorAll('*')].find(one => one.shadowRoot?.querySelector('.desk')), root = host.shadowRoot, found = [];
  const parsed = text => { const [r, g, b, a = 1] = text.match(/[\\d.]+/g)?.map(Number) ?? [0, 0, 0, 0]; return [r, g, b, a]; };
  const over = ([r, g, b, a], [R, G, B]) => [r * a + R * (1 - a), g * a + G * (1 - a), b * a + B * (1 - a)];
  const light = parts => parts.map(v => v / 255).map(v => v <= 0.04045 ? v / 12.92 : ((v + 0.055) / 1.055) ** 2.4).reduce((sum, v, i) => sum + v * [0.2126, 0.7152, 0.0722][i], 0);
  const ratio = (one, two) => { const [low, high] = [light(one), light(two)].sort((a, b) => a - b); return (high + 0.05) / (low + 0.05); };
  const above = element => element.parentElement ?? element.getRootNode().host ?? null;
  const ground = element => {
    const layers = [];
    for (let at = element; at; at = above(at)) {
      const shape = at.tagName === 'g' && [...at.children].find(one => ['rect', 'ellipse', 'path'].includes(one.tagName) && getComputedStyle(one).fill !== 'none');
      const colour = parsed(shape ? getComputedStyle(shape).fill : getComputedStyle(at).backgroundColor);
      layers.push(colour);
      if (colour[3] === 1) break;
    }
    return layers.reverse().reduce((below, layer) => over(layer, below), [255, 255, 255]);
  };
  const walk = document.createTreeWalker(root.querySelector('.desk'), NodeFilter.SHOW_TEXT);
  let count = 0;
  while (walk.nextNode()) {
    const element = walk.currentNode.parentElement, text = walk.currentNode.data.trim();
    if (!text || !element.checkVisibility() || element.closest(':disabled, style, option')) continue;
    const style = getComputedStyle(element), behind = ground(element), size = parseFloat(style.fontSize), isLarge = size >= 24 || (size >= 18.66 && style.fontWeight >= 700);
    let faint = 1;
    for (let at = element; at; at = above(at)) faint *= Number(getComputedStyle(at).opacity);
    const colour = parsed(element.namespaceURI.endsWith('svg') ? style.fill : style.color), seen = over([...colour.slice(0, 3), colour[3] * faint], behind);
    count++;
    if (ratio(seen, behind) < (isLarge ? 3 : 4.5)) found.push(`${text.slice(0, 40)}: ${seen.map(Math.round)} on ${behind.map(Math.round)}, ${ratio(seen, behind).toFixed(2)}`);
  }
  return { count, found };
}"""
HOST = "[...document.querySelectorAll('*')].find(one => one.shadowRoot?.querySelector('.desk')).shadowRoot"
REACHED = f"""() => {{ const all = [...{HOST}.querySelectorAll('button, select, input, summary, [tabindex="0"]')];
  return all.filter(e => e.checkVisibility() && !e.disabled && e.tabIndex < 0 && e.getAttribute('role') !== 'tab').map(e => e.outerHTML.slice(0, 80)); }}"""
"""The controls that the tabulator does not reach."""
WIDER = f"() => {{ const panel = {HOST}.querySelector('.panel'); return panel.scrollWidth - panel.clientWidth; }}"
TABS = ('launch', 'frames', 'tree', 'graph', 'timeline', 'plot', 'log', 'parameters', 'terminal')


@pytest.fixture(scope='module')
def recording() -> Recording:
    return edulaunch.run('turtle_tf2_py', 'turtle_tf2_demo.launch.py', duration_s=3)


@pytest.mark.parametrize('scheme', ['light', 'dark'])
@pytest.mark.parametrize('width', [900, 1400])
def test_axe_finds_no_violation(browser: Any, tmp_path: Path, recording: Recording, axe: str, scheme: str, width: int) -> None:
    file = tmp_path / 'demo.html'
    file.write_text(recorded_page(timeline_of(recording), 'demo'), encoding='utf-8')
    context = browser.new_context(viewport={'width': width, 'height': 860}, color_scheme=scheme, bypass_csp=True)
    desk = Desk(context.new_page())
    desk.page.goto(file.as_uri())
    desk.page.add_script_tag(content=axe)
    desk.seek(1.0)
    found = []
    for tab in TABS:
        desk.open(tab)
        desk.frame()
        result = desk.page.evaluate('axe.run(document, { resultTypes: ["violations"] })')
        found += [(tab, one['id'], [node['target'] for node in one['nodes']]) for one in result['violations']]
    assert found == []
    context.close()


@pytest.mark.parametrize('jupyter', ['light', 'dark'])
def test_a_replay_has_the_theme_of_jupyterlab(browser: Any, recording: Recording, jupyter: str) -> None:
    context = browser.new_context(color_scheme='null')  # a theme that playwright sets would hold in the frame, too
    page = context.new_page()
    page.goto('about:blank')
    page.evaluate(
        '([light, text]) => { document.body.dataset.jpThemeLight = light; document.body.innerHTML = text; }',
        [str(jupyter == 'light').lower(), recording.replay().html()],
    )
    page.frame_locator('iframe').locator(f'.desk[data-theme={jupyter}]').wait_for(timeout=20_000)
    context.close()


@pytest.fixture
def live(browser: Any, recording: Recording) -> Iterator[Desk]:
    """A live view whose machine is a list of messages."""
    context = browser.new_context(viewport={'width': 1200, 'height': 860}, color_scheme='light')
    page = context.new_page()
    page.goto('about:blank')
    delta = json.dumps(timeline_of(recording))
    page.evaluate(
        f"""async () => {{ document.body.innerHTML = '<div id=desk></div>';
        document.body.dataset.jpThemeLight = 'false';
        {script()}
        window.sent = []; const handlers = [];
        openDesk(document.getElementById('desk'), {{ send: words => sent.push(words), on: handler => handlers.push(handler) }}, {{ tab: 'graph' }});
        window.say = message => handlers.forEach(handler => handler(message));
        say({{ delta: {delta}, machine: {{ running: true, speed: 1 }} }}); }}"""
    )
    desk = Desk(page)
    page.locator('.worlds canvas').first.wait_for()
    yield desk
    context.close()


def test_a_widget_follows_the_theme_of_jupyterlab_until_somebody_chooses(live: Desk) -> None:
    theme = "document.getElementById('desk').shadowRoot.querySelector('.desk').dataset.theme"
    assert live.page.evaluate(theme) == 'dark', 'the system is light'
    live.page.evaluate("document.body.dataset.jpThemeLight = 'true'")
    live.page.wait_for_function(f"() => {theme} === 'light'")
    live.press('switch between dark and light')
    live.page.evaluate("document.body.dataset.jpThemeLight = 'false'; document.body.dataset.jpThemeLight = 'true'")
    assert live.page.evaluate(theme) == 'dark'


def test_in_jupyterlab_the_view_and_its_3d_canvas_have_the_theme_of_jupyterlab(
    lab: Lab, course: Path, shots: Path, axe: str
) -> None:
    """The system's theme is the other one each time. axe-core finds no violation in the widget, and each tab fits in it.

    The contrast is measured by hand: axe-core takes text in JupyterLab's scrolled panels as hidden. The arrow keys reach each tab,
    and the tabulator each control.
    """
    code = "import edulaunch\nmachine = edulaunch.start('turtle_tf2_py', 'turtle_tf2_demo.launch.py')\nmachine.view('frames')"
    brightness = """canvas => { const { data } = canvas.getContext('2d').getImageData(3, 3, 1, 1);
        return data[3] ? (data[0] + data[1] + data[2]) / 3 : null; }"""
    with lab.open(write_notebook(course / 'lessons', 'theme', {'theme': code})) as opened:
        page = opened.page
        page.evaluate("() => { window.jupyterapp.commands.execute('notebook:run-all-cells') }")
        canvas, found = page.locator('.panel canvas').first, []
        canvas.wait_for()
        page.add_script_tag(content=axe)
        for name, system in (('dark', 'light'), ('light', 'dark')):
            page.emulate_media(color_scheme=system)
            page.evaluate(
                "theme => window.jupyterapp.commands.execute('apputils:change-theme', { theme })", f'JupyterLab {name.title()}'
            )
            page.locator(f'.desk[data-theme={name}]').wait_for()
            page.wait_for_timeout(500)  # JupyterLab loads the style of the theme
            shade = canvas.evaluate(brightness)
            assert shade is not None and (shade < 80 if name == 'dark' else shade > 200), (name, shade)
            page.screenshot(path=shots / f'theme-lab-{name}.png')
            page.locator(f'[data-tab={TABS[-1]}]').click()
            for tab in TABS:
                page.keyboard.press('ArrowRight')
                page.locator(f'[data-tab={tab}][aria-selected=true]').wait_for()
                for width in (900, 1400):
                    page.set_viewport_size({'width': width, 'height': 860})
                    page.wait_for_timeout(100)
                    seen = page.evaluate(CONTRAST)
                    assert seen['count'] > 25, 'the text of the tab is not there'
                    found += [(name, tab, width, text) for text in seen['found']]
                    found += [(name, tab, width, text) for text in page.evaluate(REACHED)]
                    assert page.evaluate(WIDER) <= 1, (tab, width)
                    if WANTED:
                        page.locator('.desk').screenshot(path=shots / f'lab-{name}-{width}-{tab}.png')
                result = page.evaluate(
                    """() => axe.run([...document.querySelectorAll('*')].find(one => one.shadowRoot?.querySelector('.desk')),
                        { resultTypes: ['violations'], rules: { 'color-contrast': { enabled: false } } })"""
                )
                found += [(name, tab, one['id'], [node['target'] for node in one['nodes']]) for one in result['violations']]
            page.locator('[data-tab=frames]').click()
        page.emulate_media(color_scheme='light')
    assert found == []


def test_arrow_keys_while_time_is_paused_say_why_nothing_happens(live: Desk) -> None:
    live.page.evaluate('say({ machine: { running: false } })')
    live.page.locator('.worlds canvas').first.focus()
    live.page.keyboard.press('ArrowUp')
    live.until('.state', 'Time is paused, so nothing moves.')


def test_a_machine_that_has_ended_is_not_shown_as_running(live: Desk, recording: Recording) -> None:
    live.page.evaluate("say({ ended: 'the machine has ended', machine: { running: false } })")
    live.until('.state', 'the machine has ended')
    assert live.page.locator('button[title^="play or pause"]').is_disabled()
    ended = [[*row[:5], 3_000_000, 0, *row[7:]] for row in timeline_of(recording)['processes']]
    delta = json.dumps({'start': 0, 'now': 3_100_000, 'processes': ended})
    live.page.evaluate(f'say({{ delta: {delta}, machine: {{ running: true }} }})')
    live.until('.state', 'stopped: every program has ended')


def test_a_machine_with_a_program_is_running(live: Desk) -> None:
    row = [99, 'talker-9', 4242, ['talker'], 0, None, None, '']
    live.page.evaluate(f'say({{ delta: {{ start: 0, now: 3200000, processes: [{json.dumps(row)}] }} }})')
    live.until('.state', 'running')


def test_the_window_of_an_ended_program_takes_one_line(live: Desk, recording: Recording) -> None:
    nodes = [[*row[:5], 2_000_000] for row in timeline_of(recording)['nodes'] if row[1] == '/sim']
    live.page.evaluate(f'say({{ delta: {{ start: 0, now: 3200000, nodes: {json.dumps(nodes)} }} }})')
    live.until('figure', '/sim ended at 2.00 s')
    assert live.page.locator('.worlds canvas').first.is_hidden()
    live.page.get_by_text('/sim ended at').click()
    live.page.locator('.worlds canvas').first.wait_for()


@pytest.mark.parametrize('scheme', ['light', 'dark'])
def test_axe_finds_no_violation_on_a_live_page(browser: Any, live: Desk, axe: str, scheme: str) -> None:
    live.page.evaluate(f"document.body.dataset.jpThemeLight = '{str(scheme == 'light').lower()}'")
    live.page.add_script_tag(content=axe)
    found = []
    for width in (900, 1400):
        live.page.set_viewport_size({'width': width, 'height': 860})
        for tab in TABS:
            live.open(tab)
            live.frame()
            result = live.page.evaluate('axe.run(document.getElementById("desk"), { resultTypes: ["violations"] })')
            found += [(tab, one['id'], [node['target'] for node in one['nodes']]) for one in result['violations']]
    assert found == []


def test_a_keyboard_alone_reaches_every_control_of_a_live_page(live: Desk) -> None:
    """Tab reaches each visible control of each tab of the page."""
    for tab in TABS:
        live.open(tab)
        live.frame()
        assert live.page.evaluate(REACHED) == [], tab
    live.page.locator('[role=tab][aria-selected=true]').focus()
    for tab in TABS:
        live.page.keyboard.press('ArrowRight')
        live.frame()
        assert live.page.locator('[role=tab][aria-selected=true]').get_attribute('data-tab') == tab
    focused = "() => document.getElementById('desk').shadowRoot.activeElement?.getAttribute('aria-label') ?? ''"
    live.open('plot')
    seen = set()
    live.page.locator('[role=tab][aria-selected=true]').focus()
    for _ in range(14):
        live.page.keyboard.press('Tab')
        seen.add(live.page.evaluate(focused))
    assert {
        'add a field to the plot',
        'plot: the frame',
        'an expression to plot',
        'page of another run to plot over this one',
    } <= seen

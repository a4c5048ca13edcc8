"""The live desk beside a terminal, in JupyterLab, and exported to a file: seen, driven, stopped, stepped, turned back and asked."""

from __future__ import annotations

import json
import re
import subprocess
import sys
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.replay import timeline_of
from tests.browser.desk import Desk
from tests.browser.lab import WAIT_MS, Lab

pytestmark = pytest.mark.browser

DEMO = ('turtle_tf2_py', 'turtle_tf2_demo.launch.py')


def check_the_desk(desk: Desk, shots: Path, name: str, *, can_continue: bool) -> None:
    """Watch, drive, pause, step, go back, ask tf, change a parameter, plot, read the log, type a command."""
    quiet_s = drive_and_stop(desk)
    look_back(desk, quiet_s, shots / f'{name}-frames.png', can_continue=can_continue)
    use_the_tabs(desk)
    desk.page.screenshot(path=shots / f'{name}-graph.png')
    use_the_terminals(desk)
    desk.page.screenshot(path=shots / f'{name}-terminal.png')
    export_and_replay(desk)
    assert desk.errors == []


def drive_and_stop(desk: Desk) -> float:
    """One arrow key, the space bar, and one tick; returns a time at which both turtles were there and the first had not moved."""
    page = desk.page
    desk.until_js("root.querySelector('.worlds canvas').ariaLabel.includes('turtle2')")
    quiet_s = desk.time()
    page.locator('.worlds canvas').first.click()
    page.keyboard.press('ArrowUp')
    desk.until_js("parseFloat(root.querySelector('.worlds canvas').ariaLabel.match(/turtle1 at .([0-9.]+)/)[1]) > 7.4")

    page.keyboard.press(' ')
    desk.until('.state', 'paused')
    before = desk.time()
    desk.press('one step forward')
    desk.until_js(f"Math.abs(parseFloat(root.querySelector('.clock').textContent) - {before} - 0.016) < 0.0011")

    x, y = desk.pose('turtle1')
    red, green, blue = desk.pixel(x, y)
    assert green > red and green > blue, 'the first turtle is green where its pose says that it is'
    return quiet_s


def look_back(desk: Desk, quiet_s: float, shot: Path, *, can_continue: bool) -> None:
    """An instant before the drive, tf asked there, and from there on, or back to now."""
    page = desk.page
    desk.seek(quiet_s / desk.time())
    assert desk.pose('turtle1') == (5.54, 5.54)
    desk.until('.state', 'looking back')
    desk.open('frames')
    page.get_by_label('source frame').select_option('turtle1')
    page.get_by_label('target frame').select_option('world')
    desk.until('.probe output', 'translation [5.544, 5.544, 0.000]')
    page.get_by_label('time in seconds').fill('99')
    desk.until('.probe output', 'ExtrapolationException: Lookup would require extrapolation')
    page.screenshot(path=shot)
    if can_continue:
        desk.press('run the launch again')
        desk.until_js("root.querySelector('.state').textContent === 'paused'")
        assert desk.pose('turtle1') == (5.54, 5.54)
    else:
        page.get_by_text('● Live').click()


def use_the_tabs(desk: Desk) -> None:
    """A colour changes the picture; a plot, the log, a command, and edges of the graph that light up."""
    page = desk.page
    desk.press('play or pause')
    desk.open('parameters')
    page.get_by_label('/sim background_r', exact=True).evaluate('e => { e.value = 250; e.dispatchEvent(new Event("change")); }')
    page.wait_for_function(
        """() => { const root = [...document.querySelectorAll('*')].find(e => e.shadowRoot?.querySelector('.desk')).shadowRoot;
        return root.querySelector('.worlds canvas').getContext('2d').getImageData(5, 5, 1, 1).data[0] > 240; }"""
    )
    desk.open('plot')
    page.get_by_label('add a field to the plot').select_option('/turtle1/pose.x')
    desk.until('.key', '/turtle1/pose.x')
    desk.open('log')
    page.get_by_placeholder('word').fill('turtle2')
    desk.until('.log td', 'Spawning turtle [turtle2]')
    desk.until_js("!root.querySelector('.log').textContent.includes('[turtle1]')")
    desk.open('graph')
    page.locator('svg path.lit').first.wait_for()


def use_the_terminals(desk: Desk) -> None:
    """A command in the first, one that goes on in the second, where Tab works, too; Ctrl-C ends it."""
    page = desk.page
    desk.open('terminal')
    page.get_by_label('command for the machine', exact=True).fill('ros2 node list')
    page.keyboard.press('Enter')
    desk.until('.terminal', '/broadcaster2')
    second = page.get_by_label('command for the machine, terminal 2')
    second.fill('ros2 topic echo /turtle1/po')
    second.press('Tab')
    desk.until_js("root.querySelectorAll('.term input')[1].value === 'ros2 topic echo /turtle1/pose '")
    second.press('Enter')
    desk.until('.term:nth-child(2) .terminal', 'linear_velocity')
    desk.press('Ctrl-C for terminal 2')
    desk.until_js("root.querySelectorAll('.term .tools span')[1].textContent === '$'")


def export_and_replay(desk: Desk) -> None:
    """A file with all that has happened, opened from disk in a browser without a network."""
    with desk.page.expect_download() as waiting:
        desk.press('save the run so far')
    assert waiting.value.suggested_filename in ('turtle_tf2_demo.html', 'machine.html')
    context = desk.page.context.browser.new_context(offline=True)
    replay = Desk(context.new_page(), ('file:',))
    replay.page.goto(Path(waiting.value.path()).rename(Path(waiting.value.path()).with_suffix('.html')).as_uri())
    replay.page.locator('.worlds canvas').first.wait_for()
    replay.seek_first('turtle1')
    assert replay.pose('turtle1') == (5.54, 5.54)
    replay.seek(1.0)
    assert 'turtle2' in replay.label() and replay.time() > 1
    assert replay.errors == []
    context.close()


def test_the_page_beside_a_terminal(beside_terminal: Desk, shots: Path) -> None:
    check_the_desk(beside_terminal, shots, 'terminal', can_continue=False)


def test_a_tab_that_is_closed_in_mid_run_loses_nothing(beside_terminal: Desk) -> None:
    old = beside_terminal
    old.open('terminal')
    old.page.get_by_label('command for the machine', exact=True).fill('ros2 topic echo /turtle1/pose')
    old.page.keyboard.press('Enter')
    old.until('.terminal', 'theta')
    context = old.page.context
    old.page.close()
    new = Desk(context.new_page(), (old.address, old.address.replace('http', 'ws')))
    new.page.goto(old.address)
    new.until_js("root.querySelector('.worlds canvas')?.ariaLabel.includes('turtle2')")
    new.seek_first('turtle1')
    assert new.pose('turtle1') == (5.54, 5.54) and 'turtle2' not in new.label()
    new.open('terminal')
    new.page.get_by_label('command for the machine', exact=True).fill('ros2 node list')
    new.page.keyboard.press('Enter')
    new.until('.terminal', '/listener')
    assert new.errors == []


def test_the_page_server_dies_and_the_machine_goes_on(beside_terminal: Desk) -> None:
    desk = beside_terminal
    desk.until_js("root.querySelector('.worlds canvas').ariaLabel.includes('turtle2')")
    desk.processes['view'].kill()
    desk.until('.state', 'has ended')
    desk.seek_first('turtle1')
    assert desk.pose('turtle1') == (5.54, 5.54), 'what was seen stays'
    assert desk.processes['launch'].poll() is None
    words = [sys.executable, '-m', 'edulaunch', 'view', '--no-browser']
    quiet = {'stdout': subprocess.PIPE, 'stderr': subprocess.DEVNULL, 'env': desk.env, 'text': True}
    again = desk.processes['again'] = subprocess.Popen(words, **quiet)  # type: ignore[call-overload]
    new = Desk(desk.page.context.new_page())
    address = re.search(r'http://\S+', again.stdout.readline())
    assert address
    new.page.goto(address[0])
    new.until_js("root.querySelector('.worlds canvas')?.ariaLabel.includes('turtle2')")
    new.seek_first('turtle1')
    assert new.pose('turtle1') == (5.54, 5.54), 'and the machine has everything from its start'


def test_the_machine_dies_and_the_page_keeps_what_it_has_seen(beside_terminal: Desk) -> None:
    desk = beside_terminal
    desk.until_js("root.querySelector('.worlds canvas').ariaLabel.includes('turtle2')")
    subprocess.run([sys.executable, '-m', 'edulaunch', 'machine', 'stop'], env=desk.env, check=True, stdout=subprocess.DEVNULL)
    desk.until('.state', 'has ended')
    desk.seek_first('turtle1')
    assert desk.pose('turtle1') == (5.54, 5.54)
    assert desk.processes['launch'].wait(timeout=WAIT_MS / 1000) == 1


def test_a_page_of_another_origin_gets_nothing(beside_terminal: Desk) -> None:
    page = beside_terminal.page.context.new_page()
    page.goto('about:blank')
    address = beside_terminal.address
    fetched = "address => fetch(address).then(answer => answer.text(), error => 'refused')"
    assert page.evaluate(fetched, address) == 'refused'
    joined = """address => new Promise(done => { const socket = new WebSocket(address);
        socket.onopen = () => done('let in'); socket.onerror = () => done('refused'); })"""
    assert page.evaluate(joined, address.replace('http', 'ws') + 'socket') == 'refused'
    framed = """address => new Promise(done => { const frame = document.createElement('iframe'); frame.src = address;
        frame.onload = () => { try { done(frame.contentDocument ? 'read' : 'refused'); } catch { done('refused'); } }; document.body.append(frame); })"""
    assert page.evaluate(framed, address) == 'refused'


def test_an_exported_file_plays_from_disk(page: Any, tmp_path: Path, shots: Path) -> None:
    recording = edulaunch.run(*DEMO, duration_s=20)
    file = tmp_path / 'demo.html'
    file.write_text(recorded_page(timeline_of(recording), 'demo'), encoding='utf-8')
    assert file.stat().st_size < 400_000
    desk = Desk(page, (file.as_uri(),))
    page.goto(file.as_uri())
    page.locator('.worlds canvas').first.wait_for()
    desk.seek(0.5)
    expected = recording.trajectory('turtle2')
    at = int((expected.t <= desk.time()).sum()) - 1
    x, y = desk.pose('turtle2')
    assert (x, y) == (pytest.approx(expected.x[at], abs=0.03), pytest.approx(expected.y[at], abs=0.03))
    desk.press('play or pause')
    desk.until_js("parseFloat(root.querySelector('.clock').textContent) > 10.2")
    for tab in ('frames', 'tree', 'graph', 'timeline', 'plot', 'log', 'parameters', 'terminal'):
        desk.open(tab)
        desk.frame()
        page.screenshot(path=shots / f'export-{tab}.png')
    assert desk.errors == []


@pytest.mark.parametrize(('scheme', 'width'), [('dark', 1280), ('light', 400)])
def test_dark_and_narrow(browser: Any, tmp_path: Path, shots: Path, scheme: str, width: int) -> None:
    recording = edulaunch.run(*DEMO, duration_s=8)
    file = tmp_path / 'demo.html'
    file.write_text(recorded_page(timeline_of(recording), 'demo'), encoding='utf-8')
    context = browser.new_context(viewport={'width': width, 'height': 900}, color_scheme=scheme)
    desk = Desk(context.new_page())
    desk.page.goto(file.as_uri())
    desk.page.locator('.worlds canvas').first.wait_for()
    desk.seek(0.9)
    desk.page.screenshot(path=shots / f'{scheme}-{width}.png')
    assert desk.page.evaluate('() => document.documentElement.scrollWidth') <= width
    context.close()
    assert desk.errors == []


STARTED = f'import edulaunch\nmachine = edulaunch.start{DEMO!r}\nmachine.view()'
MAGIC = f'%load_ext edulaunch.jupyter\nrecording = %ros2 launch {" ".join(DEMO)} --for 3\n%ros2 view'


@pytest.mark.parametrize(('code', 'can_continue'), [(STARTED, True), (MAGIC, False)], ids=['started', 'magic'])
def test_the_desk_in_a_notebook(lab: Lab, course: Path, shots: Path, code: str, can_continue: bool) -> None:
    cell = {'cell_type': 'code', 'id': 'desk', 'metadata': {}, 'source': code, 'outputs': [], 'execution_count': None}
    kernel = {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}}
    notebook = {'cells': [cell], 'metadata': kernel, 'nbformat': 4, 'nbformat_minor': 5}
    (course / 'lessons' / 'desk.ipynb').write_text(json.dumps(notebook))
    with lab.open('desk') as page:
        desk = Desk(page.page)
        page.page.evaluate("() => { window.jupyterapp.commands.execute('notebook:run-all-cells') }")
        page.page.locator('.worlds canvas').first.wait_for()
        desk.errors.clear()  # what JupyterLab itself complains of while it starts
        check_the_desk(desk, shots, 'lab', can_continue=can_continue)
        assert page.requests == []


def test_a_kernel_that_dies_leaves_the_page_with_what_it_has_seen(lab: Lab, course: Path) -> None:
    cell = {'cell_type': 'code', 'id': 'desk', 'metadata': {}, 'source': STARTED, 'outputs': [], 'execution_count': None}
    kernel = {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}}
    notebook = {'cells': [cell], 'metadata': kernel, 'nbformat': 4, 'nbformat_minor': 5}
    (course / 'lessons' / 'dies.ipynb').write_text(json.dumps(notebook))
    with lab.open('dies') as page:
        desk = Desk(page.page)
        page.page.evaluate("() => { window.jupyterapp.commands.execute('notebook:run-all-cells') }")
        desk.until_js("root.querySelector('.worlds canvas')?.ariaLabel.includes('turtle2')")
        page.page.evaluate('() => window.jupyterapp.serviceManager.sessions.shutdownAll()')
        desk.seek_first('turtle1')
        assert desk.pose('turtle1') == (5.54, 5.54)
        desk.open('log')
        desk.until('.log td', 'Spawning turtle [turtle1]')


def test_a_restarted_kernel_is_reported_and_leaves_no_error_in_the_console(lab: Lab, course: Path) -> None:
    cell = {'cell_type': 'code', 'id': 'desk', 'metadata': {}, 'source': STARTED, 'outputs': [], 'execution_count': None}
    kernel = {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}}
    notebook = {'cells': [cell], 'metadata': kernel, 'nbformat': 4, 'nbformat_minor': 5}
    (course / 'lessons' / 'again.ipynb').write_text(json.dumps(notebook))
    with lab.open('again') as page:
        desk = Desk(page.page)
        page.page.evaluate("() => { window.jupyterapp.commands.execute('notebook:run-all-cells') }")
        desk.until_js("root.querySelector('.worlds canvas')?.ariaLabel.includes('turtle2')")
        desk.errors.clear()
        page.page.evaluate('() => window.jupyterapp.shell.currentWidget.sessionContext.session.kernel.restart()')
        desk.until('.state', 'The kernel was restarted: run this cell again.')
        desk.press('forward')  # a student who has not seen it yet
        page.page.wait_for_timeout(3_000)  # six more questions would come in this time
        page.page.evaluate("() => { window.jupyterapp.commands.execute('notebook:run-all-cells') }")
        desk.until('.state', 'running')
        assert desk.errors == []


def test_a_slider_of_a_lesson_changes_the_colour_of_the_window(lab: Lab, course: Path, shots: Path) -> None:
    code = f"import edulaunch\nmachine = edulaunch.start{DEMO!r}\nmachine.run(0.1)\ndisplay(machine.slider('/sim', 'background_r'))\nmachine.view()"
    cell = {'cell_type': 'code', 'id': 'desk', 'metadata': {}, 'source': code, 'outputs': [], 'execution_count': None}
    kernel = {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}}
    notebook = {'cells': [cell], 'metadata': kernel, 'nbformat': 4, 'nbformat_minor': 5}
    (course / 'lessons' / 'slider.ipynb').write_text(json.dumps(notebook))
    with lab.open('slider') as page:
        desk = Desk(page.page)
        page.page.evaluate("() => { window.jupyterapp.commands.execute('notebook:run-all-cells') }")
        desk.until_js("root.querySelector('.worlds canvas')")
        handle = page.page.locator('.widget-slider .noUi-handle')
        handle.focus()
        page.page.keyboard.press('End')
        desk.until_js("root.querySelector('.worlds canvas').getContext('2d').getImageData(5, 5, 1, 1).data[0] === 255")
        page.page.screenshot(path=shots / 'lab-slider.png')

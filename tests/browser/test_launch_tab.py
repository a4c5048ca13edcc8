"""The tab Launch: in a replay, on the page of a machine, and in JupyterLab."""

from __future__ import annotations

import json
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.replay import timeline_of
from tests.browser.desk import Desk
from tests.browser.lab import Lab

pytestmark = pytest.mark.browser
ROOT = Path(__file__).resolve().parents[2]


@pytest.fixture(scope='module')
def file(tmp_path_factory: pytest.TempPathFactory) -> Path:
    project = ROOT / 'solutions' / 'large_project'
    recording = edulaunch.run('large_project', 'large_project.launch.py', workspaces=[project], duration_s=4)
    path = tmp_path_factory.mktemp('launch') / 'large.html'
    path.write_text(recorded_page(timeline_of(recording), 'large', 'launch'))
    return path


@pytest.fixture(params=[('light', 900), ('light', 1400), ('dark', 900), ('dark', 1400)], ids=lambda look: f'{look[0]}-{look[1]}')
def replay(request: Any, browser: Any, file: Path) -> Iterator[tuple[Desk, str]]:
    scheme, width = request.param
    context = browser.new_context(viewport={'width': width, 'height': 860}, color_scheme=scheme)
    desk = Desk(context.new_page(), ('file:',))
    desk.page.goto(file.as_uri())
    desk.page.locator('.step').first.wait_for()
    yield desk, f'{scheme}-{width}'
    assert desk.errors == []
    context.close()


def where(desk: Desk) -> str:
    desk.frame()
    return str(desk.page.locator('.where').inner_text())


def test_the_large_project_is_stepped_through_to_its_last_node_and_back(replay: tuple[Desk, str], shots: Path) -> None:
    desk, name = replay
    desk.press('step through the launch again')
    forward = [where(desk)]
    while len(forward) < 60:
        desk.press('to the next action, also')
        if where(desk) == forward[-1]:
            break
        forward.append(where(desk))
    assert forward[0].startswith('Before: argument') or forward[0].startswith('Before: include')
    nodes = [text for text in forward if 'Before: node ' in text]
    assert len(nodes) >= 6 and all('.launch.py:' in text for text in forward)
    desk.page.screenshot(path=shots / f'launch-{name}.png')
    back = [forward[-1]]
    while len(back) < 200:
        desk.press('back to the previous action or event')
        if where(desk) == back[-1]:
            break
        back.append(where(desk))
    assert [text for text in reversed(back) if not text.startswith('Before the event')] == forward


def test_the_context_follows_the_step_and_an_event_comes_after_the_visit(replay: tuple[Desk, str]) -> None:
    desk, _ = replay
    desk.press('step through the launch again')
    seen = set()
    for _ in range(40):
        seen.add(desk.page.locator('.context').inner_text())
        desk.press('to the next action, also')
    assert any('namespace' in text and '/turtlesim2' in text for text in seen)
    assert any('No launch configuration is set.' in text for text in seen)
    desk.press('step through the launch again')
    desk.press('to the next event')
    assert where(desk).startswith('Before the event') and 'started' in where(desk)


def test_over_an_include_and_to_a_line_and_back_to_the_step_before(replay: tuple[Desk, str]) -> None:
    desk, _ = replay
    desk.press('step through the launch again')
    while 'Before: include' not in where(desk):
        desk.press('to the next action, also')
    first = where(desk)
    desk.press('to the next action after this')
    over = where(desk)
    assert over != first and over.rpartition(':')[0].endswith(first.rpartition('(')[2].rpartition(':')[0])
    desk.press('back to the previous action or event')
    assert where(desk) != over
    desk.press('step through the launch again')
    desk.page.get_by_label('file and line to run to').fill(over.rpartition('(')[2].rstrip(')'))
    desk.page.keyboard.press('Enter')
    assert where(desk) == over
    desk.page.get_by_label('file and line to run to').fill('nothing.launch.py:1')
    desk.press('run to the next action that this line makes')
    desk.until('.state', 'the launch does not reach this line')


def test_a_process_shows_where_its_parameters_come_from(replay: tuple[Desk, str]) -> None:
    desk, _ = replay
    desk.seek(1.0)
    desk.page.locator('.step', has_text='turtlesim_node').first.click()
    desk.until('.step-told', 'running, pid')
    desk.until('.step-told', 'parameter background_r')


HANDLERS = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, LogInfo, RegisterEventHandler, TimerAction
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessExit, OnProcessStart
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node', name='sim', parameters=[{
        'background_r': 1, 'background_g': 2, 'qos_overrides./parameter_events.publisher.durability': 'volatile'}])
    return LaunchDescription([
        DeclareLaunchArgument('second', default_value='false'),
        sim,
        Node(package='turtlesim', executable='mimic', condition=IfCondition(LaunchConfiguration('second'))),
        RegisterEventHandler(OnProcessStart(target_action=sim, on_start=[LogInfo(msg='started')])),
        RegisterEventHandler(OnProcessExit(target_action=sim, on_exit=[LogInfo(msg='gone')])),
        TimerAction(period=9.0, actions=[LogInfo(msg='late')]),
    ])
"""


@pytest.fixture
def handlers(browser: Any, tmp_path: Path) -> Iterator[Any]:
    """Opens a replay of a launch with handlers, a timer and an action that is left out: in a theme, so wide."""
    source, file, contexts = tmp_path / 'demo.launch.py', tmp_path / 'demo.html', []
    source.write_text(HANDLERS)
    file.write_text(recorded_page(timeline_of(edulaunch.run(source, duration_s=2)), 'demo', 'launch'))

    def opened(scheme: str, width: int) -> Desk:
        contexts.append(browser.new_context(viewport={'width': width, 'height': 860}, color_scheme=scheme))
        desk = Desk(contexts[-1].new_page(), ('file:',))
        desk.page.goto(file.as_uri())
        desk.seek(1.0)
        return desk

    yield opened
    for context in contexts:
        context.close()


LOOKS = [(scheme, width) for scheme in ('light', 'dark') for width in (900, 1400)]


@pytest.mark.parametrize(('scheme', 'width'), LOOKS)
def test_what_never_fired_what_is_left_out_and_what_waits_are_marked(handlers: Any, shots: Path, scheme: str, width: int) -> None:
    desk = handlers(scheme, width)
    page = desk.page
    assert "left out: second is 'false'" in page.locator('.step', has_text='mimic').inner_text()
    assert 'fires at 9.0' in page.locator('.step', has_text='timer after').inner_text()
    never, once = (page.locator('.step', has_text=name) for name in ('OnProcessExit', 'OnProcessStart'))
    assert 'never fired' in never.inner_text() and 'fired once' in once.inner_text()
    of = 'step => getComputedStyle(step).borderLeftStyle + getComputedStyle(step.querySelector(".state-of")).color'
    assert never.evaluate(of) != once.evaluate(of), 'a handler that never fired looks like one that did'
    page.screenshot(path=shots / f'launch-handlers-{scheme}-{width}.png')


@pytest.mark.parametrize(('scheme', 'width'), LOOKS)
def test_the_names_of_values_are_broken_at_spaces_only_and_nothing_is_cut_off(
    handlers: Any, shots: Path, scheme: str, width: int
) -> None:
    desk = handlers(scheme, width)
    page = desk.page
    page.locator('.step', has_text='turtlesim_node').click()
    desk.until('.step-told', 'parameter background_r')
    lines = """cell => { const range = document.createRange(); range.selectNodeContents(cell.lastChild);
        return range.getClientRects().length; }"""
    assert page.locator('.step-told td.named', has_text='background_g').evaluate(lines) == 1
    assert page.locator('.step-told').evaluate('box => box.scrollWidth <= box.clientWidth')
    place = page.get_by_label('file and line to run to')
    assert place.input_value().startswith('demo.launch.py:')
    assert place.evaluate('field => field.scrollWidth <= field.clientWidth'), 'the place can be read'
    page.screenshot(path=shots / f'launch-values-{scheme}-{width}.png')
    desk.open('parameters')
    desk.frame()
    assert page.locator('.params').evaluate(
        'table => table.getBoundingClientRect().right <= table.parentNode.getBoundingClientRect().right + 1'
    )


def test_a_launch_is_stepped_in_a_notebook(lab: Lab, course: Path, shots: Path) -> None:
    code = "import edulaunch\nmachine = edulaunch.start('turtlesim', 'multisim.launch.py', step=True)\nmachine.view('launch')"
    cell = {'cell_type': 'code', 'id': 'step', 'metadata': {}, 'source': code, 'outputs': [], 'execution_count': None}
    kernel = {'kernelspec': {'name': 'python3', 'display_name': 'Python 3', 'language': 'python'}}
    notebook = {'cells': [cell], 'metadata': kernel, 'nbformat': 4, 'nbformat_minor': 5}
    (course / 'lessons' / 'step.ipynb').write_text(json.dumps(notebook))
    with lab.open('step') as page:
        desk = Desk(page.page)
        page.page.evaluate("() => { window.jupyterapp.commands.execute('notebook:run-all-cells') }")
        desk.until('.where', 'Before: Node turtlesim_node')
        desk.errors.clear()
        desk.press('to the next action, also')
        desk.until('.where', 'multisim.launch.py')
        desk.press('to the next event')
        desk.until('.where', 'Before the event: turtlesim_node-1 started')
        page.page.screenshot(path=shots / 'launch-lab.png')
        desk.press('back to the previous action or event')
        desk.until('.where', 'Before: node ')
        page.page.get_by_text('● Live').click()
        desk.press('play or pause')
        desk.until('.where', 'The launch runs.')
        page.page.locator('.step', has_text='turtlesim_node').first.click()
        desk.press('send SIGINT to turtlesim_node-1')
        desk.until('.step', 'ended, exit code 0')
        assert desk.page.locator('.step-told button', has_text='Kill').is_disabled(), 'it has ended'
        desk.press('start turtlesim_node-1 again')
        desk.until('.step', 'run 2')
        desk.press('step through the launch again')
        desk.until('.where', 'Before: Node turtlesim_node')
        assert desk.errors == [] and page.requests == []


def test_a_launch_of_a_terminal_stops_where_the_page_wants_it(beside_terminal: Desk, shots: Path) -> None:
    desk = beside_terminal
    desk.open('launch')
    desk.until('.step', 'turtle_tf2_listener')
    desk.page.get_by_label('stop each new launch').check()
    desk.open('terminal')
    desk.page.get_by_label('command for the machine', exact=True).fill('ros2 launch turtlesim multisim.launch.py &')
    desk.page.keyboard.press('Enter')
    desk.open('launch')
    desk.until('.where', 'Before: Node turtlesim_node')
    desk.until('.state', 'paused')
    desk.press('to the next action, also')
    desk.page.screenshot(path=shots / 'launch-terminal.png')
    desk.press('play or pause')
    desk.until('.step', 'running, pid')
    assert desk.errors == []

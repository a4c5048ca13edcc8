"""The launch as a page shows it without a script."""

from __future__ import annotations

from html.parser import HTMLParser
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.view.launch_outline import DEEPEST, MOST_ROWS, launch_outline, state_of
from edulaunch.desk.view.page import recorded_page
from edulaunch.desk.view.replay import outline_of, timeline_of

FILE = """
from launch import LaunchDescription
from launch.actions import DeclareLaunchArgument, RegisterEventHandler, TimerAction, LogInfo
from launch.conditions import IfCondition
from launch.event_handlers import OnProcessExit
from launch.substitutions import LaunchConfiguration
from launch_ros.actions import Node


def generate_launch_description():
    sim = Node(package='turtlesim', executable='turtlesim_node', parameters=[{'background_r': 7}])
    return LaunchDescription([
        DeclareLaunchArgument('second', default_value='false'),
        sim,
        Node(package='turtlesim', executable='mimic', condition=IfCondition(LaunchConfiguration('second'))),
        RegisterEventHandler(OnProcessExit(target_action=sim, on_exit=[LogInfo(msg='gone')])),
        TimerAction(period=9.0, actions=[LogInfo(msg='late')]),
        TimerAction(period=0.5, actions=[Node(package='turtlesim', executable='turtlesim_node', name='other')]),
    ])
"""


@pytest.fixture(scope='module')
def run(tmp_path_factory: pytest.TempPathFactory) -> Any:
    path = tmp_path_factory.mktemp('outline') / 'demo.launch.py'
    path.write_text(FILE, encoding='utf-8')
    return edulaunch.run(path, duration_s=2)


class _Text(HTMLParser):
    """Collects the text of a page, and checks that each element is closed by its own end."""

    def __init__(self) -> None:
        super().__init__()
        self.texts: list[str] = []
        self.open: list[str] = []

    def handle_starttag(self, tag: str, attrs: Any) -> None:
        self.open.append(tag)

    def handle_endtag(self, tag: str) -> None:
        assert self.open.pop() == tag

    def handle_data(self, data: str) -> None:
        if self.open[-1] != 'style':
            self.texts.append(data)


def text_of(html: str) -> str:
    parser = _Text()
    parser.feed(html)
    assert parser.open == []
    return ''.join(parser.texts)


def test_each_action_has_its_place_and_its_state(run: Any) -> None:
    text = text_of(outline_of(run))
    assert 'include demo.launch.py' in text
    assert 'demo.launch.py:11' in text and 'demo.launch.py:15' in text
    assert 'running, pid ' in text
    assert "left out: second is 'false'" in text
    assert 'never fired' in text and 'Waits for ' in text
    assert 'fires at 9.00 s' in text and 'ran out at 0.50 s' in text
    assert 'waits for the timer' in text


def test_a_value_has_the_chain_of_its_origin(run: Any) -> None:
    text = text_of(outline_of(run))
    assert 'parameter background_r7' in text.replace('\n', '')
    assert "'false' — default demo.launch.py:13" in text


def test_a_place_is_told_once_and_a_condition_without_a_name_is_told_as_it_is() -> None:
    chain = [
        {'value': 1, 'origin': 'sim.yaml line 3', 'file': '/x/sim.yaml', 'line': 3, 'counts': False, 'argument': []},
        {'value': 2, 'origin': 'default', 'file': '/x/a.launch.py', 'line': 4, 'counts': True, 'argument': []},
    ]
    values = [{'kind': 'parameter', 'name': 'r', 'value': 2, 'chain': chain}]
    shown = [row(0, values=values), row(1, state='left out', condition="if 'false'")]
    text = text_of(launch_outline([{'rows': shown}], 0))
    assert 'sim.yaml:3' not in text and 'sim.yaml line 3' in text and 'default a.launch.py:4' in text
    assert "left out: if 'false' is not true" in text


def test_an_event_names_the_handlers_that_it_fired(run: Any) -> None:
    text = text_of(outline_of(run))
    assert 'Events of this launch: ' in text and 'turtlesim_node-1 started' in text


def test_the_page_of_a_recording_shows_it_where_no_script_runs(run: Any, tmp_path: Path) -> None:
    inside = recorded_page(timeline_of(run), 'demo').split('<main id="desk">')[1].split('</main>')[0]
    assert 'include demo.launch.py' in text_of(inside)
    assert '<main id="desk"></main>' in recorded_page(timeline_of(run), 'demo', small=False)  # the frame of a notebook


def row(number: int, parent: int = -1, **other: Any) -> dict[str, Any]:
    usual = {'kind': 'log', 'text': 'x', 'file': 'a.launch.py', 'line': 1, 'details': [], 'state': 'taken', 'time': 0, 'order': 1}
    return {**usual, 'number': number, 'parent': parent, **other}


def test_what_a_program_chose_is_never_markup() -> None:
    hostile = '<script>alert(1)</script>\x00'
    chain = [{'value': hostile, 'origin': hostile, 'file': hostile, 'line': 1, 'counts': True, 'argument': []}]
    values = [{'kind': 'parameter', 'name': hostile, 'value': hostile, 'chain': chain}]
    rows = [
        row(0, text=hostile, file=hostile, details=[['a', hostile, hostile, 3]], values=values, handlers=[hostile]),
        row(1, state='failed', error=hostile),
        row(2, kind='event', text=hostile, fired=[0, 99]),
    ]
    found = launch_outline([{'rows': rows}], 1)
    assert '<script' not in found and '\x00' not in found and '&lt;script&gt;' in found
    text_of(found)


def test_a_deep_or_long_launch_stays_readable() -> None:
    deep = launch_outline([{'rows': [row(number, number - 1) for number in range(5000)]}], 1)
    assert deep.count('<details') <= DEEPEST + 1
    assert f'the first {MOST_ROWS} of 5000 actions' in text_of(deep)


@pytest.mark.parametrize(
    ('other', 'words'),
    [
        ({'order': 0, 'time': None, 'state': 'waiting'}, 'waiting'),
        ({'state': 'failed', 'error': 'KeyError: x'}, 'failed: KeyError: x'),
        ({'process': 'a-1', 'runs': [[7, 0, 5, 0]]}, 'ended, exit code 0'),
        ({'process': 'a-1', 'runs': [[7, 0, 5, 0], [8, 6, 7, -2]]}, 'ended by signal 2, run 2'),
        ({'process': 'a-1', 'runs': [[7, 0, 5, 1]]}, 'died, exit code 1'),
        ({'process': 'a-1', 'runs': [[7, 0, 500, 0]]}, 'running, pid 7'),
        ({'handlers': ['x'], 'fired_at': [1, 2]}, 'fired 2 times'),
        ({'due': 2_000_000}, 'cancelled by the shutdown'),
        ({'state': 'visiting'}, 'is visited'),
    ],
)
def test_states(other: dict[str, Any], words: str) -> None:
    shutdown = row(1, kind='event', event='Shutdown', time=3)
    step = row(0, **other)
    assert state_of(step, {0: step, 1: shutdown}, 10)[1] == words


def test_a_run_without_a_launch_has_no_outline() -> None:
    assert launch_outline([], 1) == ''

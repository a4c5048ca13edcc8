"""The live page that a command in a terminal brings with it."""

from __future__ import annotations

import re
import signal
import sys
import urllib.error
import urllib.request

import pytest

from edulaunch.machine.page_beside import tab_of
from tests.machine.shells import Desk, Shell

pytest.importorskip('tornado')


def address(shell: Shell) -> str:
    shell.until(lambda output: re.search(r'the view is at (http://\S+)\r?\n', output))
    found = re.search(r'the view is at (http://\S+)', shell.output)
    assert found
    return found[1]


def page(url: str) -> str | None:
    """What is there; None when nobody serves it."""
    try:
        with urllib.request.urlopen(url, timeout=10) as answer:
            return str(answer.read().decode())
    except urllib.error.URLError:
        return None


def test_a_launch_brings_its_page_which_goes_with_it(desk: Desk) -> None:
    shell = desk.ros2('launch turtlesim multisim.launch.py --view', BROWSER='true')
    url = address(shell)
    assert 'openDesk' in (page(url) or '')
    shell.until('Spawning turtle')
    shell.type('\x03')
    assert shell.end() == 0
    assert page(url) is None


def test_the_page_goes_when_the_terminal_is_killed(desk: Desk) -> None:
    shell = desk.ros2('launch turtlesim multisim.launch.py --view', BROWSER='true')
    url = address(shell)
    shell.send(signal.SIGKILL)
    shell.wait_for(lambda: page(url) is None)


def test_a_tool_with_a_window_is_the_page_at_its_tab(desk: Desk) -> None:
    shell = desk.ros2('run rqt_plot rqt_plot', BROWSER='true')
    assert 'tab: "plot"' in (page(address(shell)) or '')
    shell.type('\x03')
    assert shell.end() == 0


def test_the_shell_function_opens_it_too(desk: Desk) -> None:
    program = [sys.executable, '-m', 'edulaunch', 'env', '--answer']
    shell = Shell('rviz2', cwd=desk.folder, env={**desk.env, 'BROWSER': 'true'}, program=program)
    desk.shells.append(shell)
    assert 'tab: "frames"' in (page(address(shell)) or '')


@pytest.mark.parametrize(
    ('line', 'tab'),
    [
        ('launch a b --view', 'graph'),
        ('launch a b', None),
        ('topic list', None),
        ('run', None),
        ('run rviz2 rviz2', None),  # nobody sits at the terminal of a test
    ],
)
def test_who_wants_a_page(line: str, tab: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('os.isatty', lambda number: False)
    assert tab_of(line.split()) == tab


@pytest.mark.parametrize(
    ('line', 'tab'), [('run rviz2 rviz2', 'frames'), ('run rqt_graph rqt_graph', 'graph'), ('run rqtx x', None)]
)
def test_who_opens_a_window(line: str, tab: str | None, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr('os.isatty', lambda number: True)
    assert tab_of(line.split()) == tab

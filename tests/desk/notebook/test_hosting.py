"""What a desk in a notebook means for the launches of later cells."""

from __future__ import annotations

import asyncio
from pathlib import Path
from typing import Any

import pytest

from edulaunch.desk.machine.desk_widget import Page
from edulaunch.desk.view.viewer import Viewer


@pytest.fixture(autouse=True)
def _own_place(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setenv('XDG_RUNTIME_DIR', str(tmp_path))


def nodes_after(desk: Any, line: str) -> list[str]:
    """The nodes of the recording after a page looked on, a line was typed in its terminal, and a launch file was started again."""

    async def cells() -> list[str]:
        desk.ros2('launch sim.launch.py --for 1')
        hosting = desk.terminal.machine.hosting
        page = Page(Viewer(hosting, lambda message: None))
        hosting.pages.append(page)
        page.ask()
        if line:
            hosting.do_for(page.viewer, {'op': 'line', 'line': line, 'pane': 0})
        hosting.session.run(3.0)
        desk.write('other.launch.py', (desk.folder / 'sim.launch.py').read_text().replace("name='sim'", "name='other'"))
        recording = desk.ros2('launch other.launch.py --for 1')
        hosting.pages.remove(page)
        return [node.name for node in recording.nodes if '_ros2cli' not in node.name]

    return asyncio.run(cells())


def test_somebody_who_looks_on_does_not_keep_the_machine_of_the_launch_before(desk: Any) -> None:
    assert nodes_after(desk, '') == ['/other']


@pytest.mark.parametrize('line', ['ros2 run demo_nodes_py talker', 'ros2 run demo_nodes_py talker &'])
def test_a_program_of_the_desks_terminal_does(desk: Any, line: str) -> None:
    assert nodes_after(desk, line) == ['/sim', '/talker', '/other']


def test_one_that_has_ended_does_not(desk: Any) -> None:
    assert nodes_after(desk, 'ros2 node list') == ['/other']

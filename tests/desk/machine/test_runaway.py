"""A program that never gives its turn back, on a machine that others share."""

from __future__ import annotations

from pathlib import Path

import pytest

from tests.desk.machine.shells import Desk
from tests.desk.machine.workspace import make_package

BUSY = """import sys
from rclpy.node import Node
import rclpy


def main():
    rclpy.init()
    Node('busy')
    print('busy now')
    while True:
        pass
"""
NEVER_S = '3600'
"""A limit that ends no turn while a test runs: what ends it is what the test does."""


@pytest.fixture
def packages(desk: Desk) -> Path:
    """A workspace around the folder in which the terminals are."""
    return make_package(desk.folder, {'busy': BUSY})


def test_it_is_named_and_ended_and_the_others_go_on(desk: Desk, packages: Path) -> None:
    desk.env['EDULAUNCH_TURN_LIMIT_S'] = '1'
    talker = desk.ros2('run demo_nodes_py talker')
    talker.until('Publishing: "Hello World: 1"')
    busy = desk.ros2('run mine busy')
    busy.until('busy now')
    assert busy.end() == 1
    assert 'busy.py' in busy.output and 'this loop never waits' in busy.output
    before = talker.output.count('Publishing')
    talker.until(lambda output: output.count('Publishing') > before)


def test_ctrl_c_ends_it_at_once(desk: Desk, packages: Path) -> None:
    desk.env['EDULAUNCH_TURN_LIMIT_S'] = NEVER_S
    busy = desk.ros2('run mine busy')
    busy.until('busy now')
    busy.type('\x03')
    busy.until('KeyboardInterrupt')
    busy.end()
    assert 'never waits' not in busy.output


def test_closing_its_terminal_ends_it_at_once(desk: Desk, packages: Path) -> None:
    desk.env['EDULAUNCH_TURN_LIMIT_S'] = NEVER_S
    busy = desk.ros2('run mine busy')
    busy.until('busy now')
    busy.close()
    desk.shells.remove(busy)
    assert desk.said('node list') == ''

"""`edulaunch compare`: both worlds, from the command line."""

from __future__ import annotations

import json
import socket
import subprocess
from collections.abc import Callable
from pathlib import Path

import pytest

from edulaunch.extras.comparing.for_real import is_empty
from edulaunch.extras.native.environment import Environment

pytestmark = pytest.mark.real
Run = Callable[..., subprocess.CompletedProcess[str]]


def test_a_talker_and_a_listener_are_the_same_in_both_worlds(real: Environment, edulaunch: Run) -> None:
    done = edulaunch('compare', 'demo_nodes_cpp', 'talker_listener_launch.py')
    assert (done.returncode, done.stdout.splitlines()[0]) == (0, 'The real run does not differ from the simulation.'), (
        done.stdout + done.stderr
    )
    assert 'nodes 2/2, endpoints 22/22, parameters 12/12, topics and frames 1/1' in done.stdout


CHEATER = """
import os
import rclpy
from rclpy.node import Node
from std_msgs.msg import Int32, String

class Cheater(Node):
    def __init__(self, real):
        super().__init__('cheater')
        self.declare_parameter('world', 'real' if real else 'simulated')
        self.number = self.create_publisher(Int32, 'number', 10)
        self.extra = self.create_publisher(String, 'extra', 10) if real else None
        self.create_timer(0.1 if real else 0.2, self.tick)
        self.get_logger().info('for real' if real else 'as if')
        self.real = real

    def tick(self):
        self.number.publish(Int32(data=7 if self.real else 8))
        if self.extra:
            self.extra.publish(String(data='x'))

rclpy.init()
try:
    rclpy.spin(Cheater(os.getpid() > 1100 or 'edulaunch.engine.sim.simulation' not in __import__('sys').modules))
except KeyboardInterrupt:
    pass
"""


def test_what_differs_is_told_and_is_an_exit_code(real: Environment, edulaunch: Run, tmp_path: Path) -> None:
    (tmp_path / 'cheater.py').write_text(CHEATER)
    (tmp_path / 'x.launch.xml').write_text('<launch><executable cmd="python3 cheater.py" name="cheater"/></launch>')
    done = edulaunch('compare', 'x.launch.xml', '--for', '10', '--json')
    found = {(row['kind'], row['name']): (row['simulated'], row['real']) for row in json.loads(done.stdout)['differences']}
    assert done.returncode == 1
    assert found[('parameter', 'world of /cheater')] == ("'simulated'", "'real'")
    assert found[('publisher', '/extra of /cheater')] == ('missing', 'std_msgs/msg/String')
    rates = {(row['kind'], row['name']): row['simulated'] for row in json.loads(done.stdout)['by_speed']}
    assert rates[('rate of messages', '/number')] == '5 Hz'
    assert found[('values in messages', '/number data')] == ('8', '7')
    assert found[('messages', '/extra')][0] == 'none'
    assert ('output', 'cheater') in found


def test_several_files_with_what_is_known(real: Environment, edulaunch: Run, tmp_path: Path) -> None:
    (tmp_path / 'cheater.py').write_text(CHEATER)
    (tmp_path / 'cheater.launch.xml').write_text('<launch><executable cmd="python3 cheater.py" name="cheater"/></launch>')
    (tmp_path / 'b.launch.xml').write_text('<launch><node pkg="demo_nodes_py" exec="talker"/></launch>')
    (tmp_path / 'b.yaml').write_text("- {file: '*cheater*', why: it cheats}\n- {file: '*b.launch*', kind: node, why: shy}\n")
    done = edulaunch('compare', '.', '--for', '4', '--jobs', '2', '--known', 'b.yaml')
    assert done.stdout.splitlines()[-1] == 'of 2: 1 equal, 1 known', done.stdout + done.stderr
    assert './cheater.launch.xml known it cheats' in [' '.join(line.split()) for line in done.stdout.splitlines()]
    assert 'a known difference did not occur: *b.launch*: shy' in done.stderr
    assert done.returncode == 0


def test_what_cannot_be_launched_cannot_be_compared(real: Environment, edulaunch: Run) -> None:
    done = edulaunch('compare', 'nowhere.launch.py')
    assert (done.returncode, done.stdout) == (2, '')
    assert "launch file 'nowhere.launch.py' does not exist." in done.stderr


def test_without_the_real_rclpy_it_says_how_to_get_it(edulaunch: Run, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv('EDULAUNCH_REAL_RCLPY', str(tmp_path / 'none'))
    done = edulaunch('compare', 'turtlesim', 'multisim.launch.py')
    assert done.returncode == 2
    assert 'the real rclpy is not installed.' in done.stderr


def test_a_domain_in_which_somebody_is_is_not_taken() -> None:
    domain = 28
    assert is_empty(domain)
    for port in (7400 + 250 * domain, 7410 + 250 * domain + 3):
        with socket.socket(socket.AF_INET, socket.SOCK_DGRAM) as somebody:
            somebody.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
            somebody.bind(('127.0.0.1', port))
            assert not is_empty(domain)
    assert is_empty(domain)

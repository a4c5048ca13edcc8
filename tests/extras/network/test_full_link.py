"""A machine on the network by the full link: commands on the real rclpy reach its simulated turtlesim, and its own reach real nodes."""

from __future__ import annotations

import os
import select
import subprocess
import time
from collections.abc import Callable, Iterator
from pathlib import Path

import pytest

from edulaunch.engine.graph.qos import TRANSIENT_LOCAL, QoS
from edulaunch.engine.packages import Index, Program
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.sim.pacing import RealTime
from edulaunch.extras.native import environment
from edulaunch.extras.native.command import command
from edulaunch.extras.network.network_link import Settings
from edulaunch.extras.network.rclpy_link import RclpyLink
from tests.extras.network.places import Place
from tests.extras.network.wires import LIMIT_S, own_domain

pytestmark = pytest.mark.real


class Machine:
    """A machine with a bridge, and programs on the real rclpy beside it."""

    def __init__(self, domain: int) -> None:
        self.place = Place(RclpyLink(), Settings(domain))
        self._time = RealTime(self.place.sim)
        self._time.is_wall = True
        self.env = {**os.environ, 'ROS_DOMAIN_ID': str(domain), 'ROS_AUTOMATIC_DISCOVERY_RANGE': 'LOCALHOST'}
        self.children: list[subprocess.Popen[str]] = []

    def start(self, *words: str) -> list[str]:
        """A simulated program; what it writes."""
        said: list[str] = []
        spec = ProcessSpec(argv=words, name=words[-1], env=dict(self.place.session.host.env))
        self.place.session.host.start(spec, lambda stream, text: said.append(text))
        return said

    def real(self, *words: str) -> subprocess.Popen[str]:
        """A command, or (package, executable), on the real rclpy."""
        index = Index()
        if words[0] == 'ros2':
            program: Program | None = Program('ros2', '', 'ros2', 'ros2')
        else:
            program = index.find_program(str(index.find_executable(*words)))
        assert program is not None
        return self._begin(program, index, words)

    def script(self, file: Path) -> subprocess.Popen[str]:
        """A program on the real rclpy."""
        return self._begin(Program('script', '', 'peer', str(file), file=str(file)), Index(), (str(file),))

    def _begin(self, program: Program, index: Index, words: tuple[str, ...]) -> subprocess.Popen[str]:
        started = command(environment.needed(), program, ProcessSpec((), 'real'), index)
        self.children.append(subprocess.Popen([*started, *words], env=self.env, stdout=subprocess.PIPE, text=True))
        return self.children[-1]

    def answer(self, *words: str) -> str:
        """What a command on the real rclpy says."""
        child = self.real(*words)
        self.until(lambda: child.poll() is not None)
        return child.communicate()[0]

    def until(self, condition: Callable[[], object]) -> None:
        """Let time pass until something is so."""
        end_s = time.monotonic() + LIMIT_S
        while not condition():
            assert time.monotonic() < end_s, 'it never came'
            select.select([self.place.link], [], [], 0.002)
            self.place.bridge.take()
            with streams_of_programs():
                self._time.advance()
            self.place.bridge.after_turn()

    def close(self) -> None:
        for child in self.children:
            child.kill()
            child.wait()
            if child.stdout is not None:
                child.stdout.close()
        self.place.close()


@pytest.fixture
def machine() -> Iterator[Machine]:
    if environment.found() is None:
        pytest.skip('the real rclpy is not installed: edulaunch network install')
    with own_domain() as domain:
        made = Machine(domain)
        yield made
        made.close()


def test_real_commands_reach_the_simulated_turtlesim(machine: Machine) -> None:
    machine.start('ros2', 'run', 'turtlesim', 'turtlesim_node')
    assert machine.answer('ros2', 'param', 'set', '/turtlesim', 'background_r', '200') == 'Set parameter successful\n'
    [node] = [node for node in machine.place.graph.nodes if node.name == 'turtlesim']
    assert machine.answer('ros2', 'param', 'get', '/turtlesim', 'background_r') == 'Integer value is: 200\n'
    spawned = machine.answer('ros2', 'service', 'call', '/spawn', 'turtlesim/srv/Spawn', '{x: 2.0, y: 3.0, name: leo}')
    assert "turtlesim.srv.Spawn_Response(name='leo')" in spawned
    assert {end.topic_name for end in node.endpoints if end.kind == 'publisher'} >= {'/leo/pose', '/turtle1/pose'}
    turned = machine.answer(
        'ros2', 'action', 'send_goal', '/leo/rotate_absolute', 'turtlesim/action/RotateAbsolute', '{theta: 0.1}'
    )
    assert 'Goal finished with status: SUCCEEDED' in turned
    assert 'x: 2.0\ny: 3.0\n' in machine.answer('ros2', 'topic', 'echo', '--once', '/leo/pose', 'turtlesim/msg/Pose')


def test_simulated_clients_are_answered_by_real_servers(machine: Machine) -> None:
    machine.real('demo_nodes_py', 'add_two_ints_server')
    machine.real('action_tutorials_py', 'fibonacci_action_server')
    sums = machine.start('ros2', 'run', 'demo_nodes_py', 'add_two_ints_client')
    machine.until(lambda: 'Result of add_two_ints: 5' in ''.join(sums))
    goal = machine.start('ros2', 'action', 'send_goal', 'fibonacci', 'action_tutorials_interfaces/action/Fibonacci', '{order: 2}')
    machine.until(lambda: 'Goal finished with status: SUCCEEDED' in ''.join(goal))
    value = machine.start('ros2', 'param', 'get', '/add_two_ints_server', 'use_sim_time')
    machine.until(lambda: 'Boolean value is: False' in ''.join(value))


HOSTILE = """
import rclpy
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import Int32, String

rclpy.init()
node = rclpy.create_node('hostile')
bad, number = node.create_publisher(String, '/bad', 1000), node.create_publisher(Int32, '/number', 10)
flood = node.create_publisher(String, '/flood', QoSProfile(depth=1000, reliability=ReliabilityPolicy.BEST_EFFORT))
broken = ['', '0001', '00010000', '00010000ffffff7f', '0001000004000000ffffffff', '00000000' + '00' * 5]

def attack():
    for data in broken:
        bad.publish(bytes.fromhex(data))
    bad.publish(String(data='whole'))
    number.publish(Int32(data=1))
    for _ in range(200):
        flood.publish(String(data='x' * 1000))

node.create_timer(0.05, attack)
rclpy.spin(node)
"""


def test_a_peer_that_sends_broken_bytes_another_type_and_far_too_much_does_no_harm(machine: Machine, tmp_path: Path) -> None:
    """What is no message is told and dropped, and all that is well is heard beside it."""
    heard = {name: machine.start('ros2', 'topic', 'echo', name, 'std_msgs/msg/String') for name in ('/bad', '/number', '/flood')}
    (tmp_path / 'hostile.py').write_text(HOSTILE)
    peer = machine.script(tmp_path / 'hostile.py')
    machine.until(lambda: ''.join(heard['/bad']).count('data: whole') >= 5 and ''.join(heard['/flood']).count('data: x') >= 100)
    told = machine.place.bridge.diagnostics.lines()
    assert any(line.startswith('/bad: dropped, ') for line in told), told
    assert 'data' not in ''.join(heard['/number']), 'an Int32 is no String'
    peer.kill()
    machine.until(lambda: not any(node.name == 'hostile' for node in machine.place.graph.nodes))


LOOSE = """
import sys
import rclpy
from rclpy.event_handler import PublisherEventCallbacks
from rclpy.qos import QoSProfile, ReliabilityPolicy
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('loose')
loose = QoSProfile(depth=1, reliability=ReliabilityPolicy.BEST_EFFORT)
told = PublisherEventCallbacks(incompatible_qos=lambda event: open('told', 'w').write(event.last_policy_kind.name))
node.create_publisher(String, '/strict', loose, event_callbacks=told)
talker = node.create_publisher(String, '/chatter', 10)
node.create_timer(0.05, lambda: talker.publish(String(data='hello')))
rclpy.spin(node)
"""


def test_a_quality_of_service_that_does_not_fit_is_told_on_both_sides_and_a_peer_that_was_killed_comes_back(
    machine: Machine, tmp_path: Path, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.chdir(tmp_path)
    (tmp_path / 'loose.py').write_text(LOOSE)
    policies: list[str] = []
    machine.place.subscription('/strict').on_incompatible = policies.append
    machine.place.subscription('/chatter')
    peer = machine.script(tmp_path / 'loose.py')
    machine.until(lambda: machine.place.heard and '/loose' in machine.place.nodes())
    machine.until(lambda: policies and (tmp_path / 'told').exists() and (tmp_path / 'told').read_text())
    assert (policies[0], (tmp_path / 'told').read_text()) == ('RELIABILITY', 'RMW_QOS_POLICY_RELIABILITY')
    peer.kill()
    machine.until(lambda: '/loose' not in machine.place.nodes())
    machine.place.heard.clear()
    machine.script(tmp_path / 'loose.py')
    machine.until(lambda: machine.place.heard and '/loose' in machine.place.nodes())


def test_two_thousand_messages_a_second_arrive_all_in_order(machine: Machine, tmp_path: Path) -> None:
    """Both ends keep all of them: what comes while the two are still being matched, or while this computer is busy, waits."""
    (tmp_path / 'fast.py').write_text("""
import time
import rclpy
from rclpy.qos import DurabilityPolicy, QoSProfile
from std_msgs.msg import String

rclpy.init()
node = rclpy.create_node('fast')
publisher = node.create_publisher(String, '/fast', QoSProfile(depth=5000, durability=DurabilityPolicy.TRANSIENT_LOCAL))
while not publisher.get_subscription_count():
    time.sleep(0.01)
begun = time.monotonic()
for number in range(4000):
    time.sleep(max(0.0, begun + number / 2000 - time.monotonic()))
    publisher.publish(String(data=str(number)))
rclpy.spin(node)
""")
    machine.place.subscription('/fast', qos=QoS(depth=5000, durability=TRANSIENT_LOCAL))
    machine.script(tmp_path / 'fast.py')
    machine.until(lambda: machine.place.heard[-1:] == [('3999',)])
    assert machine.place.heard == [(str(number),) for number in range(4000)]

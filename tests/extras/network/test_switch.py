"""The network as terminals switch it on and off; everything else does not know it."""

from __future__ import annotations

import os
import selectors
import subprocess
import sys
import time
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

from edulaunch.desk.cli.main import main
from edulaunch.desk.machine.live import LiveMachine
from edulaunch.desk.machine.terminals import Terminals
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.extras.network.network_link import Interface
from edulaunch.ros.serialization.cdr import encode
from edulaunch.runtime.session import Session
from tests.desk.machine.shells import Desk
from tests.extras.network.places import PUBLISHER, cls_of

TWIST = 'geometry_msgs/msg/Twist'
EDULAUNCH = [sys.executable, '-m', 'edulaunch']


@pytest.fixture
def desk(tmp_path: Path, domain: int) -> Iterator[Desk]:
    """Terminals in a domain of their own."""
    found = Desk(tmp_path / 'run', tmp_path / 'home')
    found.runtime.mkdir(mode=0o700)
    found.folder.mkdir()
    found.env['ROS_DOMAIN_ID'] = str(domain)
    yield found
    found.close()
    assert found.log() == ''


def edulaunch(desk: Desk, *words: str, **env: str) -> str:
    """What `edulaunch ...` says."""
    done = subprocess.run(
        [*EDULAUNCH, *words], cwd=desk.folder, env={**desk.env, **env}, capture_output=True, text=True, timeout=120, check=False
    )
    return done.stdout + done.stderr


@pytest.mark.processes
def test_nothing_of_the_network_is_loaded_while_it_is_off(tmp_path: Path) -> None:
    code = (
        'import sys\nfrom edulaunch.desk.cli.main import main\n'
        "main(['launch', 'turtlesim', 'multisim.launch.py', '--fast', '--for', '1'])\n"
        'from edulaunch.desk.machine import serving\n'
        "print([name for name in sys.modules if name.startswith(('edulaunch.extras.network', 'cyclonedds'))])\n"
    )
    done = subprocess.run([sys.executable, '-c', code], cwd=tmp_path, capture_output=True, text=True, timeout=120, check=True)
    assert done.stdout.endswith('\n[]\n')


@pytest.mark.terminals
def test_a_real_node_drives_a_turtle_of_a_launch_and_is_seen_in_other_terminals(desk: Desk, wire: Any) -> None:
    launch = desk.ros2('launch --network turtlesim multisim.launch.py')
    launch.until('Spawning turtle')
    real = wire.link()
    interface = Interface(TWIST, underlay_registry())
    command = real.add(real.add_node('/lab', 'joystick'), PUBLISHER, '/turtlesim1/turtle1/cmd_vel', interface, QoS())
    echo = desk.ros2('topic echo /turtlesim1/turtle1/pose --field linear_velocity')

    def drive() -> None:
        real.publish(command, encode(cls_of(TWIST), (1.5, 0.0, 0.0, 0.0, 0.0, 0.0)))
        real.take()
        echo.read(0)

    wire.until(lambda: '\n1.5' in echo.output.replace('\r', ''), drive)
    assert '/lab/joystick' in desk.said('node list')
    assert 'Node name: joystick' in desk.said('topic info -v /turtlesim1/turtle1/cmd_vel')
    status = edulaunch(desk, 'network', 'status')
    assert 'of this computer alone, by cyclonedds' in status and '  /lab/joystick' in status
    assert 'simulated time must equal real time' in edulaunch(desk, 'machine', 'pause')
    assert edulaunch(desk, 'network', 'off') == 'the network is off\n'
    assert '/lab/joystick' not in desk.said('node list')


@pytest.mark.terminals
def test_the_network_leaves_with_the_launch_that_joined_it(desk: Desk, wire: Any) -> None:
    other = desk.ros2('run demo_nodes_py listener')
    launch = desk.ros2('launch turtlesim multisim.launch.py --network-topics /turtlesim1')
    launch.until('Spawning turtle')
    assert 'joined the real ROS 2 network: domain ' in launch.output
    assert 'crossing: /turtlesim1;' in edulaunch(desk, 'network')
    launch.type('\x03')
    launch.end()
    assert 'left the real ROS 2 network' in launch.output
    assert edulaunch(desk, 'network').endswith('the network is off\n')
    assert not other.gone()


@pytest.mark.terminals
def test_what_makes_no_sense_is_told(desk: Desk) -> None:
    assert 'no machine is running' in edulaunch(desk, 'network')
    assert "did you mean 'SUBNET'" in edulaunch(desk, 'network', 'on', ROS_AUTOMATIC_DISCOVERY_RANGE='SUBNETT')
    assert 'unknown link' in edulaunch(desk, 'network', 'on', '--link', 'cyclone')
    said = edulaunch(desk, 'network', 'on')
    assert f'network: domain {desk.env["ROS_DOMAIN_ID"]} of this computer alone' in said and 'crossing: all topics' in said
    assert edulaunch(desk, 'network', 'off') == 'the network is off\n'


@pytest.mark.processes
def test_a_launch_without_a_machine_cannot_join(tmp_path: Path) -> None:
    code = (
        'from edulaunch.runtime.session import Session\nfrom edulaunch.engine.processes.spec import ProcessSpec\n'
        "words = ('ros2', 'launch', '--network', 'turtlesim', 'multisim.launch.py')\nsession, said = Session(), []\n"
        "spec = ProcessSpec(argv=words, name='ros2', cwd='.', env=dict(session.host.env))\n"
        'session.host.start(spec, lambda stream, text: said.append(text), said.append)\n'
        "session.run(1)\nprint(''.join(map(str, said)))\n"
    )
    done = subprocess.run(
        [sys.executable, '-c', code], cwd=tmp_path, capture_output=True, text=True, timeout=120, check=True, env=dict(os.environ)
    )
    assert '--network needs a machine that runs in real time' in done.stdout


def test_a_launch_with_a_machine_of_its_own_says_which_command_joins(capsys: pytest.CaptureFixture[str]) -> None:
    for option in ('--network', '--network-link=rclpy', '--network-topics=/tf', '--network-clock'):
        assert main(['launch', option, 'turtlesim', 'multisim.launch.py']) == 2
        assert 'help: type ros2 launch --network' in capsys.readouterr().err


def test_the_doctor_reports_the_real_network_while_it_is_on(monkeypatch: pytest.MonkeyPatch, domain: int) -> None:
    monkeypatch.setenv('ROS_DOMAIN_ID', str(domain))
    with selectors.DefaultSelector() as selector, Session(start_ns=time.time_ns() - 10**11) as session:
        machine = LiveMachine(selector=selector)
        machine.use(session)
        Terminals(machine)

        def report() -> str:
            said: list[str] = []
            spec = ProcessSpec(argv=('ros2', 'doctor', '--report', '-ep'), name='ros2', env=dict(session.host.env))
            session.host.start(spec, lambda stream, text: said.append(text))
            session.sim.run(session.sim.now_ns + 10**10)
            return ''.join(said)

        assert 'middleware name    : edulaunch (simulated)' in report()
        machine.join_network(True)
        assert 'middleware name    : cyclonedds ' in (told := report())
        assert f'real ROS 2 network                  : domain {domain} of this computer alone, by cyclonedds' in told
        machine.join_network(False)
        assert 'middleware name    : edulaunch (simulated)' in report()


def test_what_the_button_of_a_page_says(monkeypatch: pytest.MonkeyPatch, domain: int) -> None:
    monkeypatch.setenv('ROS_DOMAIN_ID', str(domain))
    with selectors.DefaultSelector() as selector, Session(start_ns=time.time_ns()) as session:
        machine = LiveMachine(selector=selector)
        machine.use(session)
        Terminals(machine)
        assert machine.is_on_network is False
        assert machine.join_network(True).startswith(f'network: domain {domain} of this computer alone, by ')
        assert machine.is_on_network is True
        assert machine.join_network(False) == 'the network is off'
        assert machine.is_on_network is False
        monkeypatch.setenv('ROS_DOMAIN_ID', 'home')
        assert machine.join_network(True).startswith("error: ROS_DOMAIN_ID is 'home'")

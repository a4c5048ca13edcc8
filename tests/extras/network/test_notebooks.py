"""The machines of notebooks on a network: their clock becomes that of the wall, and time goes on between cells."""

from __future__ import annotations

import asyncio
import time
from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest

import edulaunch
from edulaunch.desk.notebook.line import read_line
from edulaunch.desk.notebook.machine import NotebookMachine
from edulaunch.engine.graph.qos import QoS
from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.engine.sim.loops import outer_loop_set_aside
from edulaunch.extras.network.network_link import Interface
from edulaunch.ros.serialization.cdr import encode
from tests.extras.network.places import PUBLISHER, cls_of
from tests.extras.network.wires import LIMIT_S

TWIST = 'geometry_msgs/msg/Twist'
DRIVE = encode(cls_of(TWIST), (1.5, 0.0, 0.0, 0.0, 0.0, 0.0))


@pytest.fixture
def joystick(wire: Any, monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Callable[[], object]:
    """A real node in the domain of the notebook; drives a turtle a little each time."""
    monkeypatch.setenv('ROS_DOMAIN_ID', str(wire.settings.domain))
    monkeypatch.setenv('XDG_RUNTIME_DIR', str(tmp_path))
    tmp_path.chmod(0o700)
    real = wire.link()
    interface = Interface(TWIST, underlay_registry())
    command = real.add(real.add_node('/lab', 'joystick'), PUBLISHER, '/turtlesim1/turtle1/cmd_vel', interface, QoS())
    real.flush()

    def drive() -> list[str]:
        real.publish(command, DRIVE)
        real.take()
        return sorted(node.name for node in real.graph().nodes)

    return drive


async def until(condition: Callable[[], object]) -> None:
    end_s = time.monotonic() + LIMIT_S
    while not condition():
        assert time.monotonic() < end_s, 'it never came'
        await asyncio.sleep(0.005)


def moved(recording: Any) -> bool:
    return bool(recording.trajectory('/turtlesim1/turtle1').x[-1] > 5.6)


def test_a_machine_beside_cells_joins_and_leaves(joystick: Any) -> None:
    async def body() -> None:
        with edulaunch.start('turtlesim', 'multisim.launch.py') as machine:
            await until(lambda: machine.session.sim.elapsed_s > 1)
            assert machine.can_continue and machine.is_on_network is False
            machine.take({'op': 'network', 'on': True})
            assert machine.is_on_network and not machine.can_continue
            await until(lambda: len(joystick()) >= 2 and moved(machine.recording()))
            found = machine.recording()
            assert abs(found.start_ns + found.duration_s * 1e9 - time.time_ns()) < LIMIT_S * 1e9
            assert found.duration_s < LIMIT_S, 'what was recorded before stays near'
            assert '/lab/joystick' in machine.ros2('node list')
            machine.take({'op': 'network', 'on': False})
            await until(lambda: joystick() == [])
            assert machine.is_on_network is False and '/lab/joystick' not in machine.ros2('node list')

    asyncio.run(body())


def test_without_a_loop_it_says_why_it_does_not() -> None:
    with edulaunch.start('turtlesim', 'multisim.launch.py') as machine:
        assert machine.is_on_network is None
        assert machine.join_network(True) == 'a machine can join a network only while an asyncio loop runs, as in a notebook'


def test_the_machine_of_cells_joins_and_cells_hear_real_nodes(joystick: Any) -> None:
    said: list[str] = []

    async def body() -> None:
        machine = NotebookMachine(lambda stream, text: said.append(text), lambda: ())

        def cell(line: str) -> Any:
            with machine.hosting.cell(), outer_loop_set_aside():
                found = read_line(line)
                return machine.launch(found) if found.words[:1] == ['launch'] else machine.command(found)

        cell('launch turtlesim multisim.launch.py --for 1')
        hosting = machine.hosting
        assert hosting.join_network(True).startswith('the next %ros2 launch joins the network') and not hosting.is_on_network
        cell('launch turtlesim multisim.launch.py --for 1')
        session = machine.session
        assert session is not None and hosting.is_on_network and 'network: domain' in ''.join(said)
        await until(lambda: len(joystick()) >= 2 and moved(session.snapshot()))
        said.clear()
        began_ns = session.sim.now_ns
        cell('topic echo /turtlesim1/turtle1/pose --once')
        cell('node list')
        assert '/lab/joystick' in ''.join(said) and 'linear_velocity: ' in ''.join(said)
        assert session.sim.now_ns > began_ns and machine.session is session
        assert abs(session.sim.now_ns - time.time_ns()) < LIMIT_S * 1e9, 'its clock is that of the wall'
        hosting.join_network(False)
        await until(lambda: joystick() == [])
        session.close()
        assert hosting._server is not None
        hosting._server.close()

    asyncio.run(body())

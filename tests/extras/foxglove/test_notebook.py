"""`.foxglove()`: a machine and a recording are served on the loop of a notebook, and the end is told."""

from __future__ import annotations

import asyncio
import struct

import pytest

pytest.importorskip('tornado')

import edulaunch
from edulaunch.errors import UnusableInput
from tests.extras.foxglove.client import FoxgloveClient

POSE, TWIST = '/turtlesim1/turtle1/pose', '/turtlesim1/turtle1/cmd_vel'
LAUNCH = 'turtlesim', 'multisim.launch.py'


def x_of(client: FoxgloveClient) -> float:
    return float(struct.unpack_from('<f', client.data(1)[-1][1], 4)[0])


def test_a_client_drives_a_turtle_of_a_machine_and_is_told_its_end() -> None:
    async def talk() -> tuple[float, int | None]:
        machine = edulaunch.start(*LAUNCH)
        served = machine.foxglove()
        assert served.address in repr(served)
        client = await FoxgloveClient.connect(served.address)
        await client.subscribe(POSE, 1)
        await client.until(lambda: client.data(1))
        channel = {'id': 9, 'topic': TWIST, 'encoding': 'cdr', 'schemaName': 'geometry_msgs/msg/Twist'}
        await client.op('advertise', channels=[channel])
        await client.publish(9, b'\x00\x01\x00\x00' + struct.pack('<6d', 1.0, 0.0, 0.0, 0.0, 0.0, 0.0))
        await client.until(lambda: x_of(client) > 6.0)
        served.close()
        while not client.is_closed:
            await client.read()
        machine.close()
        return x_of(client), client.socket.close_code

    x, code = asyncio.run(talk())
    assert x > 6.0 and code == 1013


def test_a_recording_is_served_and_a_port_that_is_taken_is_named() -> None:
    recording = edulaunch.run(*LAUNCH, duration_s=1)

    async def talk() -> int:
        served = recording.foxglove()
        port = int(served.address.split(':')[2].partition('/')[0])
        with pytest.raises(UnusableInput, match=f'cannot serve on port {port}'):
            recording.foxglove(port)
        client = await FoxgloveClient.connect(served.address)
        await client.subscribe(POSE, 1)
        await client.until(lambda: [one for one in client.binary if one[:2] == b'\x05\x03'])
        await client.close()
        served.close()
        return len(client.data(1))

    assert asyncio.run(talk()) > 50


def test_without_a_loop_the_command_is_named() -> None:
    with pytest.raises(UnusableInput, match='asyncio loop of a notebook'):
        edulaunch.run(*LAUNCH, duration_s=0.1).foxglove()

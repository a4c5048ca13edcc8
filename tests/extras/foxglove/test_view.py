"""`edulaunch view --foxglove` as one types it: a client reads a turtle's pose with another library, and drives the turtle."""

from __future__ import annotations

import asyncio
import re
import signal
import struct
import sys
from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip('tornado')

import edulaunch
from edulaunch.desk.cli.main import main
from edulaunch.extras.foxglove.service import MOST_CLIENTS
from tests.desk.machine.conftest import desk_in
from tests.desk.machine.shells import Desk, Shell
from tests.extras.foxglove.client import FoxgloveClient

POSE, TWIST = '/turtle1/pose', '/turtle1/cmd_vel'


@pytest.fixture
def desk(tmp_path: Path) -> Iterator[Desk]:
    yield from desk_in(tmp_path)


def view(desk: Desk, *words: str) -> tuple[Shell, str]:
    """The command in a new terminal, and the address that it says."""
    program = [sys.executable, '-m', 'edulaunch']
    shell = Shell('view', *words, '--foxglove', cwd=desk.folder, env=desk.env, program=program)
    desk.shells.append(shell)
    address = re.search(r'ws://\S+/', shell.until('Ctrl-C ends it'))
    assert address is not None
    return shell, address[0]


async def drive(url: str) -> tuple[Any, Any]:
    """The first pose, and one after the turtle has gone east for a while, both as another library reads them."""
    dynamic = pytest.importorskip('mcap_ros2._dynamic')
    client = await FoxgloveClient.connect(url)
    await client.subscribe(POSE, 1)
    await client.until(lambda: client.data(1))
    channel = client.channels[POSE]
    read = dynamic.generate_dynamic(channel['schemaName'], channel['schema'])[channel['schemaName']]
    await client.op('advertise', channels=[{'id': 9, 'topic': TWIST, 'encoding': 'cdr', 'schemaName': 'geometry_msgs/msg/Twist'}])
    await client.publish(9, b'\x00\x01\x00\x00' + struct.pack('<6d', 1.0, 0.0, 0.0, 0.0, 0.0, 0.0))
    await client.until(lambda: read(client.data(1)[-1][1]).x > 6.0)
    await client.close()
    return read(client.data(1)[0][1]), read(client.data(1)[-1][1])


@pytest.mark.terminals
def test_a_client_reads_the_pose_and_drives_the_turtle(desk: Desk) -> None:
    turtle = desk.ros2('run turtlesim turtlesim_node')
    turtle.until('Spawning turtle')
    shell, url = view(desk)
    before, after = asyncio.run(drive(url))
    assert (round(before.x, 2), round(after.y, 2), after.linear_velocity) == (5.54, 5.54, 1.0)
    shell.send(signal.SIGINT)
    assert shell.end() == 0
    assert 'Publisher' not in desk.said('topic list') and TWIST in desk.said('topic list')


@pytest.mark.terminals
def test_clients_over_the_limit_and_clients_of_a_machine_that_ends_are_told_why(desk: Desk) -> None:
    desk.ros2('run turtlesim turtlesim_node').until('Spawning turtle')
    _, url = view(desk)

    async def crowd() -> tuple[Any, ...]:
        clients = [await FoxgloveClient.connect(url) for _ in range(MOST_CLIENTS)]
        for client in clients:
            await client.until(lambda: client.said('serverInfo'))  # noqa: B023  # called at once
        late = await FoxgloveClient.connect(url)
        assert not await late.read()
        program = [sys.executable, '-m', 'edulaunch']
        stop = Shell('machine', 'stop', cwd=desk.folder, env=desk.env, program=program)
        desk.shells.append(stop)
        await asyncio.to_thread(stop.end)
        for client in clients:
            while not client.is_closed:
                await client.read()
        ends = {(client.socket.close_code, client.socket.close_reason) for client in clients}
        return late.socket.close_code, late.socket.close_reason, ends

    code, reason, ends = asyncio.run(crowd())
    assert (code, reason) == (1013, '16 clients are connected already')
    assert ends == {(1001, 'the machine has ended, or the client has gone')}


@pytest.mark.terminals
def test_a_recording_plays_to_its_end(desk: Desk) -> None:
    recording = edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=1)
    recording.save(desk.folder / 'multi.rec')
    shell, url = view(desk, 'multi.rec')

    async def listen() -> list[tuple[int, bytes]]:
        client = await FoxgloveClient.connect(url)
        await client.subscribe('/turtlesim2/turtle1/pose', 1)
        await client.until(lambda: [one for one in client.binary if one[:2] == b'\x05\x03'])
        await client.close()
        return client.data(1)

    last_s, _ = recording.messages('/turtlesim2/turtle1/pose')[-1]
    assert asyncio.run(listen())[-1][0] == recording.start_ns + round(last_s * 1e9)
    shell.send(signal.SIGINT)
    assert shell.end() == 0 and not list(desk.place.glob('domain-*'))  # no machine was started


@pytest.mark.parametrize(
    ('words', 'sentence'),
    [
        (['nothing.rec', '--foxglove'], "cannot read the recording 'nothing.rec'"),
        (['nothing.rec', '--origin', 'http://x'], 'edulaunch view shows the machine, not a recording'),
        (['--foxglove', '--port', '99999'], 'cannot serve the page'),
    ],
)
def test_what_cannot_be_served_is_said(words: list[str], sentence: str, capsys: pytest.CaptureFixture[str]) -> None:
    assert main(['view', *words]) in (1, 2)
    assert sentence in capsys.readouterr().err

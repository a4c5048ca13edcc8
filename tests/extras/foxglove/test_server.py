"""The web sockets: who may come in, what a bad client costs, and that another library reads what a good one gets."""

from __future__ import annotations

import asyncio
import contextlib
import struct
from collections.abc import Awaitable, Callable
from typing import Any
from urllib.parse import urlsplit

import pytest

pytest.importorskip('tornado')

from tornado.httpclient import HTTPRequest
from tornado.websocket import websocket_connect

import edulaunch
from edulaunch.engine.recording import Recording
from edulaunch.extras.foxglove import protocol
from edulaunch.extras.foxglove.conversation import Conversation
from edulaunch.extras.foxglove.lines import HereLine, Line
from edulaunch.extras.foxglove.recorded import RecordingFeed
from edulaunch.extras.foxglove.server import serve
from tests.extras.foxglove.client import OLD, SDK, FoxgloveClient

TOPIC = '/turtlesim1/turtle1/pose'


@pytest.fixture(scope='module')
def recording() -> Recording:
    return edulaunch.run('turtlesim', 'multisim.launch.py', duration_s=2)


class Kept:
    """Lines of recordings that a server has opened, with what each client has said."""

    def __init__(self, recording: Recording) -> None:
        self.recording = recording
        self.clients: list[FoxgloveClient] = []
        self.is_broken = False
        self.lines: list[Line] = []
        self.said: list[str | bytes] = []
        self.turns = 0

    async def connect(self, url: str) -> FoxgloveClient:
        self.clients.append(await FoxgloveClient.connect(url))
        return self.clients[-1]

    async def open(self, subprotocol: str) -> Line:
        kept = self
        if self.lines:
            return self.lines.pop()

        class Counted(HereLine):
            async def say(self, message: str | bytes) -> None:
                kept.said.append(message)
                await super().say(message)

            async def turn(self) -> list[str | bytes]:
                kept.turns += 1
                assert not kept.is_broken, 'a mistake'
                return await super().turn()

        return Counted(Conversation(RecordingFeed(self.recording, 'a.rec', subprotocol == SDK)))


def with_server(recording: Recording, body: Callable[[str, Kept], Awaitable[Any]], **options: Any) -> Any:
    """Run `body(address, lines)` beside a server."""

    async def main() -> Any:
        kept = Kept(recording)
        address: asyncio.Future[str] = asyncio.get_running_loop().create_future()
        server = asyncio.create_task(serve(kept.open, opened=address.set_result, **options))
        try:
            return await body(await address, kept)
        finally:
            for client in kept.clients:
                await client.close()
            server.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await server

    return asyncio.run(main())


async def answer(url: str, subprotocols: list[str], **headers: str) -> str:
    """'in' and the subprotocol, or what the server says."""
    try:
        client = await websocket_connect(HTTPRequest(url, headers=headers), subprotocols=subprotocols)
    except Exception as error:
        return str(error)
    chosen = client.selected_subprotocol
    await FoxgloveClient(client).close()
    return f'in {chosen}'


def test_who_may_come_in(recording: Recording, capsys: pytest.CaptureFixture[str]) -> None:
    async def body(url: str, kept: Kept) -> list[str]:
        parts = urlsplit(url)
        foreign = {'Origin': 'http://evil.example'}
        return [
            await answer(url, [SDK]),
            await answer(url, [OLD, SDK]),
            await answer(url, [OLD]),
            await answer(url, [SDK], Origin=f'http://{parts.netloc}'),
            await answer(url, [SDK], Origin='https://app.foxglove.dev'),
            await answer(url, [SDK], Origin='http://localhost:8080'),
            await answer(url, [SDK], **foreign),
            await answer(url, [SDK], Origin='null'),
            await answer(url, ['graphql-ws']),
            await answer(url, []),
            await answer(url, [SDK], Host='evil.example'),
            await answer(f'ws://{parts.netloc}/' + 'x' * 32 + '/', [SDK]),
            await answer(f'ws://{parts.netloc}/', [SDK]),
        ]

    answers = with_server(recording, body, origins=['http://localhost:8080'])
    refused = 'HTTP 400: the subprotocol has to be foxglove.sdk.v1 or foxglove.websocket.v1'
    assert answers[:6] == [f'in {SDK}', f'in {SDK}', f'in {OLD}', *[f'in {SDK}'] * 3]
    assert answers[6:8] == ['HTTP 403: Forbidden'] * 2
    assert answers[8:10] == [refused] * 2
    assert answers[10:] == ['HTTP 404: Not Found'] * 3
    assert "warning: a page of 'http://evil.example' wanted to connect\n  help: add --origin" in capsys.readouterr().err


def test_another_library_reads_every_message(recording: Recording) -> None:
    dynamic = pytest.importorskip('mcap_ros2._dynamic')

    async def body(url: str, kept: Kept) -> None:
        client = await kept.connect(url)
        await client.raw(struct.pack('<BBfBQI', 3, 1, 1.0, 1, recording.start_ns, 0))
        await client.until(lambda: [one for one in client.binary if one[0] == 5 and one[1] == 1])
        for number, topic in enumerate(('/rosout', TOPIC)):
            await client.subscribe(topic, number)
        await client.raw(struct.pack('<BBfBQI', 3, 0, 100.0, 0, 0, 0))
        await client.until(lambda: [one for one in client.binary if one[0] == 5 and one[1] == 3])
        last_ns = recording.start_ns + round(recording.messages(TOPIC)[-1][0] * 1e9)
        await client.until(lambda: last_ns in [time_ns for time_ns, _ in client.data(1)[-1:]])
        for number, topic in enumerate(('/rosout', TOPIC)):
            channel = client.channels[topic]
            kind = channel['schemaName']
            read = dynamic.generate_dynamic(kind, channel['schema'])[kind]
            wanted = [row for row in recording.messages(topic) if row[0] > 0.0]
            heard = [row for row in client.data(number) if row[0] > recording.start_ns]
            for (time_ns, cdr), (time_s, message) in zip(heard, wanted, strict=True):
                assert time_ns - recording.start_ns == round(time_s * 1e9)
                assert_equal(read(cdr), message)

    with_server(recording, body)


def assert_equal(theirs: Any, ours: Any) -> None:
    """Field by field."""
    for name in ours.get_fields_and_field_types():
        one, other = getattr(theirs, name), getattr(ours, name)
        if hasattr(other, 'get_fields_and_field_types'):
            assert_equal(one, other)
        else:
            assert one == other, name


def test_what_no_client_may_say_is_answered_and_does_not_reach_the_line(recording: Recording) -> None:
    async def body(url: str, kept: Kept) -> None:
        client = await kept.connect(url)
        await client.socket.write_message('garbage')
        await client.raw(b'\x09')
        await client.op('subscribeConnectionGraph')
        await client.until(lambda: client.said('connectionGraphUpdate'))
        sentences = [one['message'] for one in client.said('status')]
        assert sentences == ['this message is not JSON', 'edulaunch does not know binary messages of the kind 09']
        assert kept.said == ['{"op": "subscribeConnectionGraph"}']

    with_server(recording, body)


def test_a_message_that_is_too_long_ends_the_connection(recording: Recording) -> None:
    async def body(url: str, kept: Kept) -> None:
        client = await kept.connect(url)
        await client.raw(b'\x01' * (protocol.LONGEST_MESSAGE + 1))
        while await client.read():
            pass
        assert kept.said == []
        again = await kept.connect(url)
        await again.until(lambda: again.said('serverInfo'))

    with_server(recording, body)


def test_a_mistake_of_ours_ends_the_client_and_not_the_server(recording: Recording, capsys: pytest.CaptureFixture[str]) -> None:
    async def body(url: str, kept: Kept) -> None:
        kept.is_broken = True
        client = await kept.connect(url)
        assert not await client.read()
        assert client.socket.close_code == 1011
        kept.is_broken = False
        again = await kept.connect(url)
        await again.until(lambda: again.said('serverInfo'))

    with_server(recording, body)
    assert 'AssertionError: a mistake' in capsys.readouterr().err


class Big:
    """A line that has 4 MiB for its client in each turn."""

    def __init__(self) -> None:
        self.turns = 0
        self.closed = asyncio.Event()

    async def say(self, message: str | bytes) -> None:
        """The test says nothing."""

    async def turn(self) -> list[str | bytes]:
        self.turns += 1
        return [bytes(4 << 20)]

    def close(self) -> None:
        self.closed.set()


def test_a_client_that_does_not_read_costs_no_turns_and_the_others_go_on(recording: Recording) -> None:
    async def body(url: str, kept: Kept) -> None:
        big, parts = Big(), urlsplit(url)
        kept.lines.append(big)
        reader, writer = await asyncio.open_connection(parts.hostname, parts.port, limit=1 << 16)
        head = f'GET {parts.path} HTTP/1.1\r\nHost: {parts.netloc}\r\nUpgrade: websocket\r\nConnection: Upgrade\r\n'
        head += (
            f'Sec-WebSocket-Key: dGhlIHNhbXBsZSBub25jZQ==\r\nSec-WebSocket-Version: 13\r\nSec-WebSocket-Protocol: {SDK}\r\n\r\n'
        )
        writer.write(head.encode())
        assert b' 101 ' in await reader.readline()
        good = await kept.connect(url)
        await good.subscribe(TOPIC, 1)
        await good.until(lambda: kept.turns > 40)
        waiting = big.turns
        assert waiting < 8
        await reader.readexactly(40 << 20)
        assert big.turns > waiting
        writer.close()
        await big.closed.wait()

    with_server(recording, body)

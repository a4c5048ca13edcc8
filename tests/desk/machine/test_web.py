"""Who gets the page: whoever knows the token, by the right name, from the page itself."""

from __future__ import annotations

import asyncio
import contextlib
import os
import socket
import sys
from collections.abc import AsyncIterator, Awaitable, Callable
from typing import Any
from urllib.parse import urlsplit

import pytest

pytest.importorskip('tornado')

from tornado.httpclient import AsyncHTTPClient, HTTPRequest, HTTPResponse  # noqa: E402
from tornado.websocket import WebSocketClientConnection, websocket_connect  # noqa: E402

from edulaunch.desk.machine import wire  # noqa: E402
from edulaunch.desk.machine.web import serve  # noqa: E402
from edulaunch.runtime.framing import frame  # noqa: E402


def with_server(body: Callable[[str, socket.socket], Awaitable[Any]]) -> Any:
    """Run `body(address, machine's end)` beside a server whose machine is a socket of the test."""
    here, there = socket.socketpair()
    there.setblocking(False)
    here.setblocking(False)

    async def main() -> Any:
        address: asyncio.Future[str] = asyncio.get_running_loop().create_future()
        server = asyncio.create_task(serve(lambda: (there, b'hello'), opened=address.set_result))
        try:
            return await body(await address, here)
        finally:
            server.cancel()
            with contextlib.suppress(asyncio.CancelledError):
                await server

    with here, there:
        return asyncio.run(main())


async def get(url: str, **headers: str) -> HTTPResponse:
    return await AsyncHTTPClient(force_instance=True).fetch(HTTPRequest(url, headers=headers), raise_error=False)


def test_the_page_needs_its_token_and_its_name() -> None:
    async def body(address: str, machine: socket.socket) -> list[int]:
        parts = urlsplit(address)
        wrong = f'{parts.scheme}://{parts.netloc}/' + 'x' * 32 + '/'
        answers = [
            await get(address),
            await get(wrong),
            await get(f'{parts.scheme}://{parts.netloc}/'),
            await get(address, Host='evil.example'),
        ]
        assert b'openDesk' in answers[0].body
        kept = ('Cache-Control', 'Referrer-Policy', 'X-Frame-Options', 'X-Content-Type-Options')
        for answer in answers:
            assert [answer.headers[name] for name in kept] == ['no-store', 'no-referrer', 'DENY', 'nosniff']
            policy = answer.headers['Content-Security-Policy']
            assert "default-src 'none'" in policy and "connect-src 'self'" in policy and "frame-ancestors 'none'" in policy
        return [answer.code for answer in answers]

    assert with_server(body) == [200, 404, 404, 404]


@pytest.mark.parametrize('origin', ['http://evil.example', 'null', 'https://127.0.0.1:1'])
def test_a_page_of_another_origin_gets_no_socket(origin: str) -> None:
    async def body(address: str, machine: socket.socket) -> str:
        request = HTTPRequest(address.replace('http', 'ws', 1) + 'socket', headers={'Origin': origin})
        try:
            await websocket_connect(request)
        except Exception as error:
            return str(error)
        return 'let in'

    assert '403' in with_server(body)


@contextlib.asynccontextmanager
async def page_of(address: str) -> AsyncIterator[WebSocketClientConnection]:
    headers = {'Origin': address[: address.index('/', 8)]}
    page = await websocket_connect(HTTPRequest(address.replace('http', 'ws', 1) + 'socket', headers=headers))
    yield page
    page.close()


def test_words_and_film_cross_in_both_directions() -> None:
    async def body(address: str, machine: socket.socket) -> None:
        loop = asyncio.get_running_loop()
        async with page_of(address) as page:
            assert await loop.sock_recv(machine, 5) == b'hello'
            await page.write_message('{"op": "next"}')
            assert await loop.sock_recv(machine, 100) == frame(wire.INPUT, b'{"op": "next"}\n')
            await loop.sock_sendall(machine, frame(wire.OUTPUT, b'{"delta"') + frame(wire.OUTPUT, b': {}}\n{"said": "x"}\n'))
            assert [await page.read_message(), await page.read_message()] == ['{"delta": {}}', '{"said": "x"}']
            machine.close()
            assert await page.read_message() is None

    with_server(body)


async def received(machine: socket.socket, most: int) -> bytes:
    """What comes to the machine: `most` bytes, or all until the page has gone."""
    got = b''
    receive = asyncio.get_running_loop().sock_recv
    while len(got) < most and (data := await asyncio.wait_for(receive(machine, 1 << 17), 60)):
        got += data
    return got


@pytest.mark.parametrize(('more', 'passes'), [(0, True), (1, False)])
def test_a_message_of_the_page_has_at_most_65536_bytes(more: int, passes: bool) -> None:
    async def body(address: str, machine: socket.socket) -> bytes:
        async with page_of(address) as page:
            await page.write_message('x' * (65536 + more))
            return await received(machine, len(b'hello' + frame(wire.INPUT, b'x' * 65536 + b'\n')))

    assert with_server(body) == b'hello' + (frame(wire.INPUT, b'x' * 65536 + b'\n') if passes else b'')


def test_lines_within_a_message_are_not_passed_on() -> None:
    async def body(address: str, machine: socket.socket) -> None:
        expected = b'hello' + frame(wire.INPUT, b'c\n')
        async with page_of(address) as page:
            await page.write_message('a\nb')
            await page.write_message('c')
            assert await received(machine, len(expected)) == expected

    with_server(body)


def test_the_machine_hears_that_a_page_was_closed() -> None:
    async def body(address: str, machine: socket.socket) -> bytes:
        async with page_of(address):
            pass
        return await received(machine, 100)

    assert with_server(body) == b'hello'


def test_a_page_too_many_is_closed_and_told_so(capsys: pytest.CaptureFixture[str]) -> None:
    async def body(address: str, machine: socket.socket) -> tuple[Any, ...]:
        async with page_of(address) as page:
            await asyncio.get_running_loop().sock_sendall(machine, frame(wire.ERRORS, b'30 pages are open'))
            return await page.read_message(), page.close_code, page.close_reason

    assert with_server(body) == (None, 1013, 'too many pages')
    assert capsys.readouterr().err == 'warning: 30 pages are open\n'


GUESS = """
import os, sys, urllib.error, urllib.request
'x'.encode('idna')  # what cannot be loaded later: Python itself may lie in a folder of root
os.setgid(65534); os.setuid(65534)
for path in ('', 'x' * 32 + '/', '../'):
    try:
        print(urllib.request.urlopen(sys.argv[1] + path, timeout=240).status)
    except urllib.error.HTTPError as error:
        print(error.code)
"""


@pytest.mark.processes
@pytest.mark.skipif(not hasattr(os, 'geteuid') or os.geteuid() != 0, reason='only root can become another user')
def test_another_user_of_this_computer_gets_nothing_without_the_token() -> None:
    async def body(address: str, machine: socket.socket) -> str:
        base = address[: address.index('/', 8) + 1]
        words = [sys.executable, '-c', GUESS, base]
        guess = await asyncio.create_subprocess_exec(*words, stdout=asyncio.subprocess.PIPE)
        said, _ = await guess.communicate()
        return said.decode()

    assert with_server(body).split() == ['404', '404', '404']

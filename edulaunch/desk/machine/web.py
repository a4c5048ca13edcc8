"""The web server of `edulaunch view`. It listens on the loopback interface and connects the browser to the machine.

A browser needs the token in the address. The server accepts a web socket only from its own page, so pages of other origins
receive nothing. Each page has one connection to the machine.
"""

from __future__ import annotations

import asyncio
import hmac
import secrets
import socket
import sys
import webbrowser
from collections.abc import Callable
from contextlib import suppress
from typing import Any

from tornado.httpserver import HTTPServer
from tornado.iostream import IOStream, StreamClosedError
from tornado.web import Application, HTTPError, RequestHandler
from tornado.websocket import WebSocketHandler

from edulaunch.desk.machine import wire
from edulaunch.desk.view.page import POLICY, live_page
from edulaunch.runtime.framing import Frames, frame

LONGEST_WORDS = 1 << 16
"""The maximum number of bytes in one message from the page."""
Connect = Callable[[], tuple[socket.socket, bytes]]
"""Returns a connected socket of the machine, and the first frame to send on it."""
Paths = list[tuple[str, type[RequestHandler]]]
"""Patterns of paths, each with its handler."""


class Guarded(RequestHandler):
    """A handler that serves the page only with the token, and only at the server's own address. It rejects other host names."""

    def set_default_headers(self) -> None:
        """Set the headers of every response, including error responses."""
        self.set_header('Content-Security-Policy', f"{POLICY}; base-uri 'none'; form-action 'none'; frame-ancestors 'none'")
        self.set_header('Cache-Control', 'no-store')
        self.set_header('Referrer-Policy', 'no-referrer')
        self.set_header('X-Frame-Options', 'DENY')
        self.set_header('X-Content-Type-Options', 'nosniff')

    def prepare(self) -> None:
        expected = self.application.settings
        given = self.path_args[0] if self.path_args else ''
        if self.request.host not in expected['hosts'] or not hmac.compare_digest(given.encode(), expected['token'].encode()):
            raise HTTPError(404)


class _Page(Guarded):
    def get(self, token: str) -> None:
        self.write(live_page('edulaunch', self.application.settings['tab']))


class _Socket(Guarded, WebSocketHandler):
    """A web socket that forwards messages between the page and the machine."""

    def check_origin(self, origin: str) -> bool:
        return origin in {f'http://{host}' for host in self.application.settings['hosts']}

    async def open(self, *args: str, **kwargs: str) -> None:
        try:
            connection, hello = self.application.settings['connect']()
        except OSError as error:
            self.close(1011, str(error)[:100])
            return
        self._machine = IOStream(connection)
        with suppress(StreamClosedError):
            await self._machine.write(hello)
        asyncio.get_running_loop().create_task(self._pass_on())

    async def _pass_on(self) -> None:
        frames, line = Frames(wire.FROM_MACHINE), b''
        try:
            while True:
                for kind, payload in frames.feed(await self._machine.read_bytes(1 << 18, partial=True)):
                    if kind == wire.ERRORS:
                        sys.stderr.write(f'warning: {payload.decode("utf-8", "replace")}\n')
                        self.close(1013, 'too many pages')
                    if kind != wire.OUTPUT:
                        continue
                    *lines, line = (line + payload).split(b'\n')
                    for text in lines:
                        await self.write_message(text)
        except Exception:  # one connection has ended, so close the other one
            self.close()

    def on_message(self, message: str | bytes) -> None:
        data = message.encode() if isinstance(message, str) else message
        if len(data) <= LONGEST_WORDS and b'\n' not in data and not self._machine.closed():
            self._machine.write(frame(wire.INPUT, data + b'\n'))

    def on_close(self) -> None:
        if hasattr(self, '_machine'):
            self._machine.close()


async def serve(connect: Connect, *, port: int = 0, tab: str = 'graph', opened: Callable[[str], object] | None = None) -> None:
    """Serve the page of the live view until the task is cancelled.

    :param connect: a function that returns a connection to the machine, and the first frame to send.
    :param port: a port of the loopback, or 0 for any free port.
    :param tab: the tab that the page shows first.
    :param opened: a function that is called with the address when the server is ready.
    :raises OSError: when the port is in use.
    """
    paths: Paths = [(r'/([\w-]+)/', _Page), (r'/([\w-]+)/socket', _Socket)]
    await serve_paths(paths, port=port, opened=opened, tab=tab, connect=connect, websocket_max_message_size=LONGEST_WORDS)


async def serve_paths(paths: Paths, *, port: int, opened: Callable[[str], object] | None, **settings: Any) -> None:
    """Serve guarded handlers on the loopback until the task is cancelled.

    The other parameters are those of :func:`open_paths`.

    :param opened: a function that is called with the address when the server is ready.
    :raises OSError: when the port is in use.
    """
    server, address = open_paths(paths, port=port, **settings)
    try:
        if opened is not None:
            opened(address)
        await asyncio.Event().wait()
    finally:
        server.stop()


def open_paths(paths: Paths, *, port: int, **settings: Any) -> tuple[HTTPServer, str]:
    """Return a server of guarded handlers on the running asyncio loop, and its address.

    :param paths: regular expressions of paths with their handlers. The first group of each expression must match the token.
    :param port: a port of the loopback, or 0 for any free port.
    :param settings: the settings of the handlers.
    :raises OSError: when the port is in use.
    """
    token = secrets.token_urlsafe(24)
    listener = socket.socket(socket.AF_INET)
    listener.setsockopt(socket.SOL_SOCKET, socket.SO_REUSEADDR, 1)
    try:
        listener.bind(('127.0.0.1', port))
    except (OSError, OverflowError):
        listener.close()
        raise
    listener.listen()
    listener.setblocking(False)
    number = listener.getsockname()[1]
    hosts = {f'127.0.0.1:{number}', f'localhost:{number}'}
    settings |= {'token': token, 'hosts': hosts, 'log_function': _quiet, 'default_handler_class': Guarded}
    server = HTTPServer(Application(paths, **settings))
    server.add_socket(listener)
    return server, f'http://127.0.0.1:{number}/{token}/'


def _quiet(handler: RequestHandler) -> None:
    """Do nothing, so that requests are not logged."""


def tell(address: str, more: str = '') -> None:
    """Print the address of the page.

    :param address: the URL of the live view.
    :param more: lines to print after the address.
    """
    sys.stdout.write(f'the live view is at {address}\n{more}')
    sys.stdout.flush()


def show(address: str) -> None:
    """Open the page in a browser if the computer has one."""
    with suppress(webbrowser.Error):
        webbrowser.open(address)

"""The web sockets, which accept clients and pass messages between a client and the object that handles it.

A client needs the token in the address, and the host name from the server's address. A page in a browser also needs an allowed
origin. While a client does not read, the server requests no further messages for it. Messages that are invalid or too long do not
reach the machine.
"""

from __future__ import annotations

import asyncio
import sys
import traceback
from collections.abc import Awaitable, Callable, Sequence
from typing import Any

from tornado.httpserver import HTTPServer
from tornado.iostream import StreamClosedError
from tornado.web import HTTPError
from tornado.websocket import WebSocketClosedError, WebSocketHandler

from edulaunch.desk.machine.web import Guarded, open_paths, serve_paths
from edulaunch.extras.foxglove import protocol, server_messages
from edulaunch.extras.foxglove.lines import Line

EVERY_S = 1 / 40
"""The seconds between two turns of a client."""
APP = 'https://app.foxglove.dev'
TOO_MUCH = 'this client asks for more than it reads'
PATH = r'/([\w-]+)/'
Open = Callable[[str], Awaitable[Line]]
"""A function that creates the connection of a client with a subprotocol."""


class Client(Guarded, WebSocketHandler):
    """One client."""

    _line: Line | None = None
    _talk: asyncio.Task[None] | None = None

    def prepare(self) -> None:
        super().prepare()
        offered = [word.strip() for word in self.request.headers.get('Sec-WebSocket-Protocol', '').split(',')]
        if not set(offered) & set(protocol.SUBPROTOCOLS):
            raise HTTPError(400, reason=f'the subprotocol has to be {" or ".join(protocol.SUBPROTOCOLS)}')

    def check_origin(self, origin: str) -> bool:
        own = {f'http://{host}' for host in self.settings['hosts']}
        if origin in self.settings['origins'] or origin in own:
            return True
        shown = repr(origin[:200])
        sys.stderr.write(f'warning: a page of {shown} wanted to connect\n  help: add --origin {shown} if you trust that page\n')
        return False

    def select_subprotocol(self, subprotocols: list[str]) -> str | None:
        return next(name for name in protocol.SUBPROTOCOLS if name in subprotocols)

    async def open(self, *args: str, **kwargs: str) -> None:
        try:
            self._line = await self.settings['open'](self.selected_subprotocol)
        except OSError as error:
            self.close(1011, str(error)[:100])
            return
        self._talk = asyncio.create_task(self._tell())

    async def _tell(self) -> None:
        """Request the next messages whenever the client has read the previous ones."""
        assert self._line is not None
        try:
            while True:
                for message in await self._line.turn():
                    await self.write_message(message, binary=isinstance(message, bytes))
                await asyncio.sleep(EVERY_S)
        except (WebSocketClosedError, StreamClosedError):
            self.close(1001, 'the machine has ended, or the client has gone')
        except OSError as error:
            self.close(1013, str(error)[:100])
        except ValueError as error:
            self.close(1008, str(error)[:100] or TOO_MUCH)
        except Exception:  # an error in edulaunch: the other clients continue
            traceback.print_exc()
            self.close(1011, 'edulaunch made a mistake')

    async def on_message(self, message: str | bytes) -> None:
        """Pass a valid message of the client on, before reading the next message."""
        if self._line is None:
            return
        try:
            try:
                protocol.parse(message)
            except protocol.ProtocolError as error:
                await self.write_message(server_messages.status(server_messages.ERROR, str(error)))
                return
            await self._line.say(message)
        except (WebSocketClosedError, StreamClosedError):
            self.close()
        except ValueError:
            self.close(1008, TOO_MUCH)

    def on_close(self) -> None:
        if self._talk is not None:
            self._talk.cancel()
        if self._line is not None:
            self._line.close()


async def serve(open_line: Open, *, port: int = 0, origins: Sequence[str] = (), opened: Callable[[str], object]) -> None:
    """Serve clients until the task is cancelled.

    :param port: a port of the loopback interface, or 0 for any free port.
    :param origins: the origins of pages that may connect in addition to the pages of Foxglove.
    :param opened: called with the address for clients when the server is ready.
    :raises OSError: when the port is in use.
    """
    await serve_paths(
        [(PATH, Client)],
        port=port,
        opened=lambda address: opened(address.replace('http', 'ws', 1)),
        **_settings(open_line, origins),
    )


def open_server(open_line: Open, *, port: int, origins: Sequence[str]) -> tuple[HTTPServer, str]:
    """Return a server on the running loop, and its address. The parameters and errors are those of :func:`serve`."""
    server, address = open_paths([(PATH, Client)], port=port, **_settings(open_line, origins))
    return server, address.replace('http', 'ws', 1)


def _settings(open_line: Open, origins: Sequence[str]) -> dict[str, Any]:
    return {
        'open': open_line,
        'origins': {APP, *origins},
        'websocket_max_message_size': protocol.LONGEST_MESSAGE,
        'websocket_ping_interval': 20,
    }

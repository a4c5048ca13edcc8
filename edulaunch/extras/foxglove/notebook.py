"""`machine.foxglove()` and `recording.foxglove()`: the server on the asyncio loop of a notebook."""

from __future__ import annotations

import asyncio
from collections.abc import Callable, Sequence
from itertools import count

from edulaunch.desk.machine.live import LiveMachine, in_its_turn
from edulaunch.engine.recording import Recording
from edulaunch.errors import UnusableInput
from edulaunch.extras.foxglove.conversation import Conversation
from edulaunch.extras.foxglove.lines import HereLine, Line
from edulaunch.extras.foxglove.live import LiveFeed
from edulaunch.extras.foxglove.protocol import SDK
from edulaunch.extras.foxglove.recorded import RecordingFeed
from edulaunch.extras.foxglove.server import open_server
from edulaunch.extras.foxglove.server_messages import Message

_numbers = count(1)


class Served:
    """A server for Foxglove and Lichtblick that runs beside the cells of a notebook.

    :ivar address: the address for the clients, with the secret token.
    """

    def __init__(self, make: Callable[[str], Conversation], port: int, origins: Sequence[str]) -> None:
        self.is_closed = False
        self._make = make
        self._server, self.address = open_server(self._open, port=port, origins=origins)

    async def _open(self, subprotocol: str) -> Line:
        return _Line(self._make(subprotocol), self)

    def __repr__(self) -> str:
        return 'a closed server' if self.is_closed else f'Foxglove and Lichtblick can connect to {self.address}'

    def close(self) -> None:
        """End the server, and notify its clients."""
        self.is_closed = True
        self._server.stop()


class _Line(HereLine):
    def __init__(self, conversation: Conversation, served: Served) -> None:
        super().__init__(conversation)
        self._served = served

    async def say(self, message: Message) -> None:
        with in_its_turn():
            await super().say(message)

    async def turn(self) -> list[Message]:
        if self._served.is_closed:
            raise OSError('the server has ended')
        with in_its_turn():
            return await super().turn()

    def close(self) -> None:
        with in_its_turn():
            super().close()


def foxglove(shown: LiveMachine | Recording, port: int = 0, origins: Sequence[str] = ()) -> Served:
    """Serve a machine or a recording to Foxglove and Lichtblick while the notebook's kernel runs.

    :param shown: the machine or the recording.
    :param port: a port of the loopback interface, or 0 for any free port.
    :param origins: the origins of pages that may connect in addition to the pages of Foxglove.
    :raises UnusableInput: without a running asyncio loop, and when the port is in use.
    """

    def make(subprotocol: str) -> Conversation:
        if isinstance(shown, Recording):
            return Conversation(RecordingFeed(shown, 'recording', subprotocol == SDK))
        return Conversation(LiveFeed(shown, next(_numbers)))

    try:
        asyncio.get_running_loop()
    except RuntimeError:
        raise UnusableInput(
            'foxglove() needs the asyncio loop of a notebook', help='use `edulaunch view --foxglove` in a terminal'
        ) from None
    try:
        return Served(make, port, origins)
    except (OSError, OverflowError) as error:
        raise UnusableInput(f'cannot serve on port {port}: {error}', help='leave out the port to use a free one') from None

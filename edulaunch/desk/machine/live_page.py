"""The machine's side of a live view: it sends changes on request, and handles requests. Each message is one line of JSON."""

from __future__ import annotations

import json
from collections.abc import Callable
from typing import Any

from edulaunch.desk.machine import wire
from edulaunch.desk.view import ViewedMachine
from edulaunch.desk.view.viewer import TypedIn, Viewer

LONGEST_LINE = 1 << 16


class LivePage:
    """The peer of a connection that a page uses. It receives the same frames as a terminal.

    :param machine: the machine that the page shows.
    :param send: a function that sends a frame to the page, from its kind and payload.
    :param forget: a function that is called once with this object when the page is closed.
    :param typed_in: the current folder and the environment of the terminal that opened the page. The page's own terminals use
        them.
    """

    def __init__(
        self,
        machine: ViewedMachine,
        send: Callable[[int, bytes], object],
        forget: Callable[[LivePage], object],
        typed_in: TypedIn | None = None,
    ) -> None:
        self._send = send
        self._forget = forget
        self._viewer = Viewer(machine, self._say, typed_in)
        self._line = b''

    def _say(self, message: dict[str, Any]) -> None:
        self._send(wire.OUTPUT, json.dumps(message, separators=(',', ':')).encode() + b'\n')

    def take(self, kind: int, payload: bytes) -> None:
        """Handle bytes from the page, which contain requests as lines.

        :raises ValueError: for invalid JSON, or a line that is too long.
        """
        if kind != wire.INPUT:
            return
        *lines, self._line = (self._line + payload).split(b'\n')
        if len(self._line) > LONGEST_LINE:
            raise ValueError('the line is too long')
        for line in lines:
            try:
                request = json.loads(line)
            except RecursionError:
                raise ValueError('lists that are nested too deeply') from None
            if isinstance(request, dict) and request.get('op') == 'next':
                self._viewer.show()
            else:
                self._viewer.take(request)

    def hang_up(self) -> None:
        """Handle the end of the connection."""
        self._forget(self)
        self._viewer.close()

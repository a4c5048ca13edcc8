"""The machine's end of a page: pieces of film on request, and what the page asks for. One line of JSON each way."""

from __future__ import annotations

import json
from typing import TYPE_CHECKING, Any

from edulaunch.desk.machine import wire
from edulaunch.desk.view.viewer import Viewer

if TYPE_CHECKING:
    from edulaunch.desk.machine.connection import Connection
    from edulaunch.desk.machine.terminals import Terminals

LONGEST_LINE = 1 << 16


class Desk:
    """Stands where a terminal would: it is fed the same frames."""

    def __init__(self, terminals: Terminals, connection: Connection) -> None:
        self._terminals = terminals
        self._connection = connection
        self._viewer = Viewer(terminals, self._say)
        self._line = b''

    def _say(self, message: dict[str, Any]) -> None:
        self._connection.send(wire.OUTPUT, json.dumps(message, separators=(',', ':')).encode() + b'\n')

    def take(self, kind: bytes, payload: bytes) -> None:
        """What the page says.

        :raises ValueError: for what is no JSON, or endless.
        """
        if kind != wire.INPUT:
            return
        *lines, self._line = (self._line + payload).split(b'\n')
        if len(self._line) > LONGEST_LINE:
            raise ValueError('an endless line')
        for line in lines:
            words = json.loads(line)
            if isinstance(words, dict) and words.get('op') == 'next':
                self._viewer.show()
            else:
                self._viewer.take(words)

    def hang_up(self) -> None:
        """The page is gone."""
        if self in self._terminals.pages:
            self._terminals.pages.remove(self)
        self._viewer.close()

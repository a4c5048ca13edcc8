"""The source of a conversation with a client: a feed is a running machine or a recording that is played."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Protocol

from edulaunch.extras.foxglove.protocol import Playback, Value
from edulaunch.extras.foxglove.server_messages import Graph

Key = tuple[str, str]
"""Topic and type."""
Row = tuple[int, Any]
"""Time in ns since 1970, and wire tuple."""


class Refused(Exception):
    """A feed cannot fulfil a request. The error message is for the user of the client."""


class Topic(NamedTuple):
    """A topic with a publisher, or a service. `registry` has its type."""

    name: str
    type: str
    cls: Any
    registry: Any


class Feed(Protocol):
    """The data that a server offers.

    :ivar name: the name of the server, which clients show.
    :ivar capabilities: the requests that clients may send, in the words of the protocol.
    """

    name: str
    capabilities: tuple[str, ...]

    def session(self) -> str:
        """Return a string that changes when a new session begins."""

    def details(self) -> dict[str, Any]:
        """Return the other fields of the server's first message."""

    def advance(self) -> list[bytes]:
        """Let time pass. Return the messages that inform a client about the new time."""

    def now_ns(self) -> int:
        """Return the current time, in ns since 1970."""

    def version(self) -> object:
        """Return a value that changes whenever topics, services or the graph may have changed."""

    def topics(self) -> Sequence[Topic]:
        """Return the current topics."""

    def services(self) -> Sequence[Topic]:
        """Return the current services."""

    def graph(self) -> Graph:
        """Return the nodes of each topic and service, by its name, under 'published', 'subscribed' and 'served'."""

    def end(self, key: Key) -> int:
        """Return the position of the next message of a topic."""

    def kept(self, key: Key) -> list[Row]:
        """Return the messages for a late subscriber: the last ones of a latched topic."""

    def rows(self, key: Key, first: int, most: int) -> tuple[list[Row], int, int]:
        """Return the last messages since a position (at most `most`), the position of the next one, and the number of missing
        ones.
        """

    def parameters(self) -> dict[str, Any]:
        """Return the current values by '/node.parameter'."""

    def parameter_version(self) -> object:
        """Return a value that changes whenever a parameter may have changed."""

    def set(self, values: Sequence[tuple[str, Value, str | None]], answer: Callable[[str], object]) -> None:
        """Set parameters. When this is done, `answer` is called with an error message, which is '' on success.

        :raises Refused: when that is not possible.
        """

    def advertise(self, topic: str, type_name: str, encoding: str) -> Callable[[bytes], object]:
        """Create a publisher. Return a function that publishes the bytes of a message, and raises Refused for other bytes.

        :param encoding: 'cdr' or 'json'.
        :raises Refused: when that is not possible.
        """

    def retire(self, publish: Callable[[bytes], object]) -> None:
        """Remove a publisher."""

    def call(self, service: Topic, request: bytes, answer: Callable[[bytes | str], object]) -> None:
        """Call a service. `answer` is called with its response, or with an error message.

        :raises Refused: when that is not possible.
        """

    def play(self, request: Playback) -> tuple[bytes, bool]:
        """Play, pause or seek; return the state, and whether the position has changed.

        :raises Refused: when that is not possible.
        """

    def close(self) -> None:
        """Handle the end of the client."""

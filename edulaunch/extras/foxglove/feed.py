"""The source of the data for a client. A feed is a running machine or a recording that is played."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Protocol

from edulaunch.extras.foxglove.protocol import Playback, Value
from edulaunch.extras.foxglove.server_messages import Graph

Key = tuple[str, str]
"""The name and the type of a topic."""
Row = tuple[int, Any]
"""The time of a message in ns since 1970, and its wire tuple."""


class Refused(Exception):
    """A feed cannot fulfil a request. Users of the client read the error message."""


class Topic(NamedTuple):
    """A topic with a publisher, or a service. `registry` contains its type."""

    name: str
    type: str
    cls: Any
    registry: Any


class Feed(Protocol):
    """The data that a server offers.

    :ivar name: the name of the server, which clients show.
    :ivar capabilities: the kinds of requests that clients may send, with the names of the protocol.
    """

    name: str
    capabilities: tuple[str, ...]

    def session(self) -> str:
        """Return a string that changes when a new session begins."""

    def details(self) -> dict[str, Any]:
        """Return further fields of the server's first message."""

    def advance(self) -> list[bytes]:
        """Advance the time of the feed. Return the messages that inform a client about the new time."""

    def now_ns(self) -> int:
        """Return the current time, in ns since 1970."""

    def version(self) -> object:
        """Return a value that changes whenever topics, services or the graph may have changed."""

    def topics(self) -> Sequence[Topic]:
        """Return the current topics."""

    def services(self) -> Sequence[Topic]:
        """Return the current services."""

    def graph(self) -> Graph:
        """Return the nodes of each topic and service by its name, under 'published', 'subscribed' and 'served'."""

    def end(self, key: Key) -> int:
        """Return the position of the next message of a topic."""

    def kept(self, key: Key) -> list[Row]:
        """Return the messages for a late subscriber: the last messages of a latched topic."""

    def rows(self, key: Key, first: int, most: int) -> tuple[list[Row], int, int]:
        """Return the last messages since a position (at most `most`), the position of the next message, and the number of missing
        messages.
        """

    def parameters(self) -> dict[str, Any]:
        """Return the current values of parameters by '/node.parameter'."""

    def parameter_version(self) -> object:
        """Return a value that changes whenever a parameter may have changed."""

    def set(self, values: Sequence[tuple[str, Value, str | None]], answer: Callable[[str], object]) -> None:
        """Set parameters. Afterwards, `answer` is called with an error message, which is '' on success.

        :raises Refused: when the feed cannot set parameters.
        """

    def advertise(self, topic: str, type_name: str, encoding: str) -> Callable[[bytes], object]:
        """Create a publisher. Return a function that publishes the bytes of a message, and raises Refused for invalid bytes.

        :param encoding: 'cdr' or 'json'.
        :raises Refused: when the publisher cannot be created.
        """

    def retire(self, publish: Callable[[bytes], object]) -> None:
        """Remove a publisher."""

    def call(self, service: Topic, request: bytes, answer: Callable[[bytes | str], object]) -> None:
        """Call a service. `answer` is called with the response, or with an error message.

        :raises Refused: when the service cannot be called.
        """

    def play(self, request: Playback) -> tuple[bytes, bool]:
        """Play, pause or seek. Return the state, and whether the position has changed.

        :raises Refused: when the feed is not a recording that can be controlled.
        """

    def close(self) -> None:
        """Release the resources of a client that has disconnected."""

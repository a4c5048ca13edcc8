"""What a conversation with a client needs to know: a feed is a machine that runs, or a recording that plays."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple, Protocol

from edulaunch.extras.foxglove.protocol import Playback, Value
from edulaunch.extras.foxglove.said import Graph

Key = tuple[str, str]
"""Topic and type."""
Row = tuple[int, Any]
"""Time in ns since 1970, and wire tuple."""


class Refused(Exception):
    """A feed cannot do what a client asks for. The text is for the user of the client."""


class Topic(NamedTuple):
    """A topic with a publisher, or a service. `registry` has its type."""

    name: str
    type: str
    cls: Any
    registry: Any


class Feed(Protocol):
    """What is served.

    :ivar name: of the server, as clients show it.
    :ivar capabilities: what clients may ask for, in the words of the protocol.
    """

    name: str
    capabilities: tuple[str, ...]

    def session(self) -> str:
        """Return a string that changes when a new session begins."""

    def details(self) -> dict[str, Any]:
        """Return what the server's first message says besides."""

    def advance(self) -> list[bytes]:
        """Time passes; returns what a client has to know about how it passes."""

    def now_ns(self) -> int:
        """Return the time of now, in ns since 1970."""

    def version(self) -> object:
        """Another value whenever topics, services or the graph may have changed."""

    def topics(self) -> Sequence[Topic]:
        """Return what is published now."""

    def services(self) -> Sequence[Topic]:
        """Return what is served now."""

    def graph(self) -> Graph:
        """Return who publishes, subscribes and serves: nodes by name under 'published', 'subscribed' and 'served'."""

    def end(self, key: Key) -> int:
        """Return the place of the next message of a topic."""

    def kept(self, key: Key) -> list[Row]:
        """Return the messages for a late subscriber: the last ones of a latched topic."""

    def rows(self, key: Key, first: int, most: int) -> tuple[list[Row], int, int]:
        """At most the last `most` messages since a place, the place of the next one, and how many are missing."""

    def parameters(self) -> dict[str, Any]:
        """Return the values of now, by '/node.parameter'."""

    def parameter_version(self) -> object:
        """Another value whenever a parameter may have changed."""

    def set(self, values: Sequence[tuple[str, Value, str | None]], answer: Callable[[str], object]) -> None:
        """Set parameters; `answer` is called with what went wrong, '' for nothing, when all of them are set.

        :raises Refused: when that is not possible.
        """

    def advertise(self, topic: str, type_name: str) -> Callable[[bytes], object]:
        """Return a new publisher. Returns what publishes CDR bytes, which raises Refused for bytes of another type.

        :raises Refused: when that is not possible.
        """

    def retire(self, publish: Callable[[bytes], object]) -> None:
        """A publisher leaves."""

    def call(self, service: Topic, request: bytes, answer: Callable[[bytes | str], object]) -> None:
        """Call a service. `answer` is called with its response, or with an error message.

        :raises Refused: when that is not possible.
        """

    def play(self, request: Playback) -> tuple[bytes, bool]:
        """Play, pause or seek; returns the state, and whether the place is another one.

        :raises Refused: when that is not possible.
        """

    def close(self) -> None:
        """The client is gone."""

"""The hooks through which a recorder sees the graph and the processes; this class records nothing."""

from __future__ import annotations

from collections.abc import Callable, Hashable, Iterable
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from edulaunch.engine.graph.node_entry import NodeEntry

Record = tuple[int, int, Any]
"""One publication: (time in ns, number of the publisher, wire tuple)."""


Look = Callable[[], Iterable[tuple[str, dict[str, Any]]]]
"""Returns unusual facts about a node at this moment, as (kind, plain data)."""


def _forget(_: Record) -> None:
    return None


class Tracer:
    """Its methods are called for everything that crosses a process boundary, before the receiver gets it. A recorder is a
    subclass.
    """

    def channel(self, publisher: Any) -> Callable[[Record], object]:
        """Return the function for the publications of this publisher. One call per publisher keeps publishing cheap."""
        return _forget

    def node_added(self, node: NodeEntry) -> None:
        """A node joined the graph."""

    def node_removed(self, node: NodeEntry) -> None:
        """A node left the graph."""

    def endpoint_added(self, kind: str, endpoint: Any) -> None:
        """An endpoint was added: kind is 'publisher', 'subscription', 'service' or 'client'."""

    def endpoint_removed(self, kind: str, endpoint: Any) -> None:
        """An endpoint was removed."""

    def request(self, client: Any, sequence: int, wire: Any, served: bool) -> None:
        """A service request was sent; `served` is whether a server accepted it."""

    def response(self, client: Any, sequence: int, wire: Any) -> None:
        """A reply was sent to its client."""

    def incompatible(self, publisher: Any, subscription: Any, policy: str) -> None:
        """Two endpoints of one topic are incompatible because of `policy` ('TYPE' when their types differ)."""

    def parameter(self, node: NodeEntry, name: str, value: Any, origin: str) -> None:
        """A parameter was declared or changed (value None: undeclared)."""

    def descriptor(
        self, node: NodeEntry, name: str, description: str, read_only: bool, limits: tuple[float, float, float] | None
    ) -> None:
        """The declared properties of a parameter: limits are the smallest and the largest value, and the step (0 allows any)."""

    def process_started(self, process: Any) -> None:
        """A program began."""

    def process_exited(self, process: Any) -> None:
        """A program ended."""

    def output(self, process: Any, stream: str, text: str) -> None:
        """A program wrote to 'stdout' or 'stderr'."""

    def log(self, process: Any, level: int, logger: str, message: str) -> None:
        """A program logged a message."""

    def note(self, process: Any, kind: str, text: str) -> None:
        """The engine noticed a problem that the user should know."""

    def temporary(self, path: str) -> None:
        """A program is about to make a temporary file or folder, whose name may differ in the next run."""

    def fact(self, process: Any, kind: str, key: Hashable, data: dict[str, Any]) -> None:
        """A program did something unusual: plain data, without messages. A repeated key counts another occurrence."""

    def fact_over(self, process: Any, kind: str, key: Hashable) -> None:
        """Withdraw the fact of that key, because it turned out not to be unusual."""

    def watch(self, node: NodeEntry, look: Look) -> None:
        """`look()` returns unusual facts about a node; it is called when the node is removed, or earlier if the recording
        ends.
        """

    def node_leaving(self, node: NodeEntry) -> None:
        """A node is about to leave, with all its endpoints."""

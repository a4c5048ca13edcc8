"""The hooks with which a recorder observes the graph and the processes. The class `Tracer` records nothing."""

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
    """The base class of recorders; each of its methods does nothing.

    The methods are called for everything that crosses a process boundary, before the receiver gets it.
    """

    def channel(self, publisher: Any) -> Callable[[Record], object]:
        """Return the function that records the messages of this publisher. The function is looked up only once, so that
        publishing is fast.
        """
        return _forget

    def node_added(self, node: NodeEntry) -> None:
        """A node was added to the graph."""

    def node_removed(self, node: NodeEntry) -> None:
        """A node was removed from the graph."""

    def endpoint_added(self, kind: str, endpoint: Any) -> None:
        """An endpoint was added. `kind` is 'publisher', 'subscription', 'service' or 'client'."""

    def endpoint_removed(self, kind: str, endpoint: Any) -> None:
        """An endpoint was removed."""

    def request(self, client: Any, sequence: int, wire: Any, served: bool) -> None:
        """A service request was sent; `served` states whether at least one server received it."""

    def response(self, client: Any, sequence: int, wire: Any) -> None:
        """A reply was sent to its client."""

    def incompatible(self, publisher: Any, subscription: Any, policy: str) -> None:
        """Two endpoints of one topic are incompatible because of `policy` ('TYPE' if their types differ)."""

    def parameter(self, node: NodeEntry, name: str, value: Any, origin: str) -> None:
        """A parameter was declared, changed or undeclared. The value None means that it was undeclared."""

    def descriptor(
        self, node: NodeEntry, name: str, description: str, read_only: bool, limits: tuple[float, float, float] | None
    ) -> None:
        """A parameter was declared with a descriptor. The limits are the smallest value, the largest value and the step (0: any
        step).
        """

    def process_started(self, process: Any) -> None:
        """A program started."""

    def process_exited(self, process: Any) -> None:
        """A program has ended."""

    def output(self, process: Any, stream: str, text: str) -> None:
        """A program wrote to 'stdout' or 'stderr'."""

    def log(self, process: Any, level: int, logger: str, message: str) -> None:
        """A program logged a message."""

    def note(self, process: Any, kind: str, text: str) -> None:
        """The engine noticed a problem that is reported to the user."""

    def temporary(self, path: str) -> None:
        """A program is about to create a temporary file or folder, whose name may differ in the next run."""

    def fact(self, process: Any, kind: str, key: Hashable, data: dict[str, Any]) -> None:
        """A program did something unusual; `data` describes it without sentences. A repeated key increases a count."""

    def fact_over(self, process: Any, kind: str, key: Hashable) -> None:
        """The fact with this key is withdrawn, because it turned out not to be unusual."""

    def watch(self, node: NodeEntry, look: Look) -> None:
        """Register `look`, which returns unusual facts about a node.

        A recorder calls `look` when the node is removed, or when the recording ends, whichever comes first.
        """

    def node_leaving(self, node: NodeEntry) -> None:
        """A node is about to be removed, together with all its endpoints."""

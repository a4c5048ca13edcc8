"""The peers with which services work over Cyclone DDS.

A reply contains the ID of its request. Cyclone DDS puts the ID into the message. Fast DDS puts it beside the message, where
cyclonedds for Python can neither write nor read it. Therefore, a service of this link is announced only if a compatible peer
exists, and a client calls only a compatible server. A hidden service is better than one that never replies.
"""

from __future__ import annotations

from edulaunch.extras.network.network_link import CLIENT, SERVICE, LinkDiagnostic, RemoteGraph

FAST_DDS = b'\x01\x0f'
"""The first bytes of gids of Fast DDS, as Cyclone DDS reports them. They are the number of the vendor."""
HELP = 'only topics cross to Fast DDS here; for all: edulaunch network install, then edulaunch network on --link rclpy'


def is_fast_dds(gid: bytes) -> bool:
    """Return whether a participant or endpoint uses Fast DDS, ROS 2's default middleware."""
    return gid[:2] == FAST_DDS


class ServicePeers:
    """The other programs on the network with services and clients."""

    def __init__(self) -> None:
        self._anybody = False
        self._served: set[str] = set()
        self._served_by_fast: set[str] = set()
        self._asked_by_fast: set[str] = set()
        self._reported: set[tuple[str, str]] = set()

    def look(self, remote: RemoteGraph) -> None:
        """Update the known peers."""
        self._anybody = any(not is_fast_dds(end.gid) for end in remote.endpoints) or any(
            not is_fast_dds(node.participant) for node in remote.nodes
        )
        for kind, is_fast, found in (
            (SERVICE, False, '_served'),
            (SERVICE, True, '_served_by_fast'),
            (CLIENT, True, '_asked_by_fast'),
        ):
            names = {end.name for end in remote.endpoints if end.kind == kind and is_fast_dds(end.gid) == is_fast}
            setattr(self, found, names)

    def is_wanted(self, kind: str, name: str) -> bool:
        """Return whether an endpoint of this link has a compatible peer. Other peers must never receive its requests, because
        they misread the ID.
        """
        return self._anybody if kind == SERVICE else name in self._served and name not in self._served_by_fast

    def diagnostic(self, kind: str, name: str) -> LinkDiagnostic | None:
        """Return a diagnostic if a peer needs a service that does not work. Return each diagnostic only once, and otherwise
        None.
        """
        there = self._asked_by_fast if kind == SERVICE else self._served_by_fast
        if name not in there or (kind, name) in self._reported:
            return None
        self._reported.add((kind, name))
        who = 'a real node has a client of' if kind == SERVICE else 'a real node has'
        return LinkDiagnostic(f'{kind} {name}', f'{who} the service {name}: its calls do not cross\n  help: {HELP}', name)

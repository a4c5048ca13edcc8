"""With whom services work over Cyclone DDS.

A reply says to which request it belongs. Cyclone DDS puts that into the message, Fast DDS beside it, where cyclonedds for Python
can neither write nor read it. So a service of ours is seen only when somebody is there who does it as we do, and a client of ours
asks only such a server: a service that nobody sees is better than one that never answers.
"""

from __future__ import annotations

from edulaunch.extras.network.link import CLIENT, SERVICE, LinkDiagnostic, RemoteGraph

FAST_DDS = b'\x01\x0f'
"""How gids begin there: the number of its vendor."""
HELP = (
    'only topics cross with Fast DDS over this link; for all: edulaunch network install, then edulaunch network on --link rclpy'
)


def is_fast_dds(gid: bytes) -> bool:
    """Whether a participant or endpoint is one of Fast DDS, ROS 2's usual middleware."""
    return gid[:2] == FAST_DDS


class ServicePeers:
    """Who else has services and clients."""

    def __init__(self) -> None:
        self._anybody = False
        self._served: set[str] = set()
        self._served_by_fast: set[str] = set()
        self._asked_by_fast: set[str] = set()
        self._reported: set[tuple[str, str]] = set()

    def look(self, remote: RemoteGraph) -> None:
        """Who is there now."""
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
        """Whether an endpoint of ours can be of use. A request of ours must never reach who takes its number for a part of it."""
        return self._anybody if kind == SERVICE else name in self._served and name not in self._served_by_fast

    def diagnostic(self, kind: str, name: str) -> LinkDiagnostic | None:
        """What to say, once, when somebody needs what does not work."""
        there = self._asked_by_fast if kind == SERVICE else self._served_by_fast
        if name not in there or (kind, name) in self._reported:
            return None
        self._reported.add((kind, name))
        who = 'a real node has a client of' if kind == SERVICE else 'a real node has'
        return LinkDiagnostic(f'{kind} {name}', f'{who} the service {name}: calls of it do not cross\n  help: {HELP}', name)

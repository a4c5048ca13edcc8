"""Discovery. DDS reports the endpoints, and ROS 2's topic `ros_discovery_info` reports the nodes that own them."""

from __future__ import annotations

from collections import deque
from collections.abc import Callable, Sequence
from typing import Any

from cyclonedds._clayer import ddspy_take, ddspy_take_endpoint, ddspy_take_participant, ddspy_write
from cyclonedds.builtin import (
    BuiltinDataReader,
    BuiltinTopicDcpsParticipant,
    BuiltinTopicDcpsPublication,
    BuiltinTopicDcpsSubscription,
)
from cyclonedds.core import InstanceState, Listener
from cyclonedds.pub import DataWriter
from cyclonedds.qos import Policy, Qos
from cyclonedds.sub import DataReader
from cyclonedds.topic import Topic

from edulaunch.engine.interfaces.registry import underlay_registry
from edulaunch.errors import InterfaceError
from edulaunch.extras.network.dds.mangling import remote_name
from edulaunch.extras.network.dds.qos import PLAIN, enclave_of, from_dds, qos_from
from edulaunch.extras.network.dds.types import idl_class
from edulaunch.extras.network.network_link import ENCLAVE, MARK, LinkDiagnostic, RemoteEndpoint, RemoteGraph, RemoteNode
from edulaunch.ros.serialization.cdr import decode, encode

INFO = 'rmw_dds_common/msg/ParticipantEntitiesInfo'
MOST_ENDPOINTS, MOST_NODES, MOST_PARTICIPANTS = 4000, 1000, 1000
AT_ONCE = 200
"""The number of discovery events that one turn of the machine handles."""
ANY = 0x7F
"""Samples in any state."""
OwnNode = tuple[str, str, Sequence[bytes], Sequence[bytes]]
"""A node of this link: its namespace, its name, and the gids of its readers and its writers."""


class Discovery:
    """Observes which nodes and endpoints join and leave the network, and announces the nodes of this link.

    :param wake: called in another thread when the network has changed.
    """

    def __init__(self, participant: Any, wake: Callable[[], object]) -> None:
        self.own = participant.guid.bytes
        self.diagnostics: list[LinkDiagnostic] = []
        self._endpoints: dict[bytes, RemoteEndpoint] = {}
        self._participant_of: dict[bytes, bytes] = {}
        self._nodes: dict[bytes, dict[RemoteNode, Sequence[bytes]]] = {}
        self._claims: dict[bytes, RemoteNode] = {}
        self._machines: set[bytes] = set()
        self._gone: deque[bytes] = deque(maxlen=MOST_PARTICIPANTS)
        self._listener = Listener(on_data_available=lambda reader: wake())
        topic = Topic(participant, 'ros_discovery_info', idl_class(INFO, underlay_registry()), qos=Qos(PLAIN))
        common = (PLAIN, Policy.Reliability.Reliable(10_000_000), Policy.Durability.TransientLocal)
        quietly = Qos(*common, Policy.History.KeepLast(100), Policy.IgnoreLocal.Participant)
        self._infos = DataReader(participant, topic, qos=quietly, listener=self._listener)
        self._teller = DataWriter(participant, topic, qos=Qos(*common, Policy.History.KeepLast(1)))
        self._builtin = [
            (BuiltinDataReader(participant, kind, listener=self._listener), take, make)
            for kind, take, make in (
                (BuiltinTopicDcpsParticipant, ddspy_take_participant, self._participant),
                (BuiltinTopicDcpsPublication, ddspy_take_endpoint, self._publication),
                (BuiltinTopicDcpsSubscription, ddspy_take_endpoint, self._subscription),
            )
        ]

    def tell(self, nodes: Sequence[OwnNode]) -> None:
        """Announce which endpoints of this link belong to which node."""
        cls = underlay_registry().get(INFO)
        wire = (self.own, tuple((namespace, name, _gids(readers), _gids(writers)) for namespace, name, readers, writers in nodes))
        ddspy_write(reference(self._teller), padded(encode(cls, wire)))

    def take(self) -> tuple[bool, bool]:
        """Handle some of the changes. Return whether there were any, and whether more may wait."""
        counts = []
        for reader, take, make in self._builtin:
            found = take(reference(reader), AT_ONCE, make, qos_from)
            counts.append(len(found) if isinstance(found, list) else 0)
        infos = ddspy_take(reference(self._infos), ANY, AT_ONCE)
        for data, info in infos if isinstance(infos, list) else ():
            if info.valid_data:
                self._info(data)
                counts.append(1)
        return any(counts), max(counts) >= AT_ONCE

    def graph(self) -> RemoteGraph:
        """Return all other nodes and endpoints on the network, without the internal nodes of links."""
        nodes = [node for nodes in self._nodes.values() for node in nodes if not node.name.startswith(MARK)]
        return RemoteGraph(
            nodes, [end for end in self._endpoints.values() if end.node is None or not end.node.name.startswith(MARK)]
        )

    def _participant(self, key: bytes, qos: Any, info: Any) -> None:
        if _is_alive(info):
            if enclave_of(qos) == ENCLAVE and len(self._machines) < MOST_PARTICIPANTS:
                self._machines.add(key)
                before = self._nodes.get(key, {})
                self._claim(key, {node._replace(is_simulated=True): gids for node, gids in before.items()})
        else:
            self._machines.discard(key)
            self._gone.append(key)
            for gid in [gid for gid, participant in self._participant_of.items() if participant == key]:
                self._forget(gid)
            self._claim(key, {})

    def _publication(self, *sample: Any) -> None:
        self._endpoint(True, *sample)

    def _subscription(self, *sample: Any) -> None:
        self._endpoint(False, *sample)

    def _endpoint(
        self,
        is_writer: bool,
        gid: bytes,
        participant: bytes,
        handle: int,
        topic: str,
        type_name: str,
        qos: Any,
        info: Any,
        _: Any,
    ) -> None:
        if not _is_alive(info):
            self._forget(gid)
            return
        if participant == self.own or topic is None or (found := remote_name(topic, type_name, is_writer)) is None:
            return
        if len(self._endpoints) >= MOST_ENDPOINTS and gid not in self._endpoints:
            text = f'the network has more than {MOST_ENDPOINTS} endpoints: later ones are ignored'
            self.diagnostics.append(LinkDiagnostic('endpoints', text))
            return
        policies, type_hash = from_dds(qos)
        self._participant_of[gid] = participant
        self._endpoints[gid] = RemoteEndpoint(gid, *found, type_hash, policies, self._claims.get(gid))

    def _forget(self, gid: bytes) -> None:
        self._endpoints.pop(gid, None)
        self._participant_of.pop(gid, None)

    def _info(self, data: bytes) -> None:
        """Handle the list of nodes that a participant announces."""
        try:
            participant, nodes = decode(underlay_registry().get(INFO), data)
        except InterfaceError as error:
            self.diagnostics.append(
                LinkDiagnostic('ros_discovery_info', f'a participant has published an invalid list of nodes: {error}')
            )
            return
        if participant == self.own or participant in self._gone:  # its last message may arrive after its end
            return
        if participant not in self._nodes and len(self._nodes) >= MOST_PARTICIPANTS:
            self.diagnostics.append(
                LinkDiagnostic('participants', f'more than {MOST_PARTICIPANTS} programs announce nodes: the others are not shown')
            )
            return
        claimed: dict[RemoteNode, Sequence[bytes]] = {}
        for namespace, name, readers, writers in nodes[:MOST_NODES]:
            node = RemoteNode(participant, namespace, name, participant in self._machines)
            claimed[node] = [gid for (gid,) in (*readers, *writers)][:MOST_ENDPOINTS]
        if len(nodes) > MOST_NODES:
            self.diagnostics.append(
                LinkDiagnostic('nodes', f'one program announces {len(nodes)} nodes: only {MOST_NODES} of them are shown')
            )
        self._claim(participant, claimed)

    def _claim(self, participant: bytes, nodes: dict[RemoteNode, Sequence[bytes]]) -> None:
        before = {gid for gids in self._nodes.pop(participant, {}).values() for gid in gids}
        claims = {gid: node for node, gids in nodes.items() for gid in gids}
        if nodes:
            self._nodes[participant] = nodes
        for gid in sorted(before.union(claims)):
            node = claims.get(gid)
            if node is None:
                self._claims.pop(gid, None)
            else:
                self._claims[gid] = node
            known = self._endpoints.get(gid)
            if known is not None and known.node != node:
                self._endpoints[gid] = known._replace(node=node)


def reference(entity: Any) -> Any:
    """Return the handle of a reader or writer in Cyclone DDS."""
    return entity._ref


def padded(cdr: bytes) -> bytes:
    """Return the bytes padded to a multiple of four, as DDS sends them."""
    return cdr + b'\0' * (-len(cdr) % 4)


def _gids(gids: Sequence[bytes]) -> tuple[tuple[bytes], ...]:
    return tuple((gid,) for gid in gids)


def _is_alive(info: Any) -> bool:
    return bool(info.valid_data) and info.instance_state == InstanceState.Alive

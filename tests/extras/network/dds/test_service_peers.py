"""With whom services work over Cyclone DDS, and what is said about the others."""

from __future__ import annotations

from edulaunch.engine.graph.qos import QoS
from edulaunch.extras.network.dds.service_peers import ServicePeers
from edulaunch.extras.network.network_link import CLIENT, PUBLISHER, SERVICE, RemoteEndpoint, RemoteGraph, RemoteNode

CYCLONE, FAST = b'\x01\x10' + bytes(14), b'\x01\x0f' + bytes(14)


def peers(*ends: tuple[bytes, str, str], nodes: tuple[bytes, ...] = ()) -> ServicePeers:
    """Who knows these endpoints: vendor, kind and name."""
    made = ServicePeers()
    remote = [RemoteEndpoint(gid, kind, name, 'std_srvs/srv/Trigger', '', QoS(), None) for gid, kind, name in ends]
    made.look(RemoteGraph([RemoteNode(gid, '/', 'node') for gid in nodes], remote))
    return made


def test_a_service_is_shown_as_soon_as_somebody_is_there_who_can_use_it() -> None:
    assert not peers().is_wanted(SERVICE, '/reset')
    assert not peers((FAST, CLIENT, '/reset'), (FAST, PUBLISHER, '/tf'), nodes=(FAST,)).is_wanted(SERVICE, '/reset')
    assert peers((CYCLONE, PUBLISHER, '/tf')).is_wanted(SERVICE, '/reset')
    assert peers(nodes=(FAST, CYCLONE)).is_wanted(SERVICE, '/reset')


def test_a_client_asks_only_who_understands_it() -> None:
    assert not peers(nodes=(CYCLONE,)).is_wanted(CLIENT, '/reset')
    assert not peers((FAST, SERVICE, '/reset')).is_wanted(CLIENT, '/reset')
    assert peers((CYCLONE, SERVICE, '/reset'), (FAST, SERVICE, '/other')).is_wanted(CLIENT, '/reset')
    assert not peers((CYCLONE, SERVICE, '/reset'), (FAST, SERVICE, '/reset')).is_wanted(CLIENT, '/reset')


def test_what_does_not_work_is_told_once_when_somebody_needs_it() -> None:
    there = peers((FAST, SERVICE, '/spawn'), (FAST, CLIENT, '/reset'))
    assert there.diagnostic(CLIENT, '/reset') is None and there.diagnostic(SERVICE, '/spawn') is None
    for kind, name, said in (
        (CLIENT, '/spawn', 'a real node has the service'),
        (SERVICE, '/reset', 'a real node has a client of the service'),
    ):
        diagnostic = there.diagnostic(kind, name)
        assert diagnostic is not None and diagnostic.text.startswith(f'{said} {name}: its calls do not cross\n  help: ')
        assert there.diagnostic(kind, name) is None

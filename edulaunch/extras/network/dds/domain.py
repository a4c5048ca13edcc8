"""The range of discovery: the configuration of a domain, from ROS 2's environment variables."""

from __future__ import annotations

import os
import socket
from contextlib import suppress
from html import escape

from cyclonedds.core import DDSException
from cyclonedds.domain import Domain

from edulaunch.extras.network.network_link import LinkError, Settings

MOST_PARTICIPANTS = 32
"""The number of participants on one computer that find each other without multicast, as in ROS 2's Cyclone DDS configuration."""
LOCALHOST = '127.0.0.1'
LARGE_FRAGMENTS = '<MaxMessageSize>65500B</MaxMessageSize><FragmentSize>8000B</FragmentSize>'
"""A packet on the loopback interface may have UDP's maximum size. Images in 1.3 kB fragments overflow the buffers."""
ANNOUNCED_EVERY = '3s'
"""The period of announcements. A static peer that starts later, or loses a packet, finds this program within this time."""
REPEATS = (
    '<HeartbeatInterval min="2ms" minsched="2ms" max="100ms">5ms</HeartbeatInterval>'
    '<MaxQueuedRexmitBytes>4MiB</MaxQueuedRexmitBytes>'
)
"""The period of heartbeats, after which a reliable publisher repeats missing samples; the default is 100 ms."""


class _Joined:
    """A DDS domain that this program has joined: its configuration, and the number of links that use it."""

    def __init__(self, number: int, text: str) -> None:
        self.text, self.domain, self.links = text, Domain(number, text), 0


_joined: dict[int, _Joined] = {}


def join(settings: Settings) -> None:
    """Join a domain until :func:`leave` is called. Several links of one program share the domain.

    :raises LinkError: for an invalid number, or when this program is in the domain with other settings.
    """
    number, text = settings.domain, configuration(settings)
    if number not in _joined:
        before = _open_files()
        try:
            _joined[number] = _Joined(number, text)
            if is_on_loopback(settings):
                _keep_on_loopback(_open_files() - before)
        except DDSException as error:
            raise LinkError(f'cannot join domain {number}: {error}') from None
    if _joined[number].text != text:
        raise LinkError(f'this program is already in domain {number} with other settings')
    _joined[number].links += 1


def _open_files() -> set[int]:
    """Return the numbers of this program's open files, without the file that lists them.

    The result is empty if the system does not report them.
    """
    try:
        return {number for number in map(int, os.listdir('/proc/self/fd')) if _is_open(number)}
    except OSError:
        return set()


def _is_open(number: int) -> bool:
    try:
        os.fstat(number)
    except OSError:
        return False
    return True


def _keep_on_loopback(files: set[int]) -> None:
    """Accept no packets from other devices. Cyclone DDS binds its sockets to all addresses, and has no setting for this."""
    for number in files:
        with suppress(OSError), socket.socket(fileno=os.dup(number)) as ear:
            if ear.family == socket.AF_INET and ear.type == socket.SOCK_DGRAM:
                ear.setsockopt(socket.SOL_SOCKET, socket.SO_BINDTODEVICE, b'lo')


def leave(number: int) -> None:
    """Leave a domain after a link and its entities have been closed."""
    joined = _joined[number]
    joined.links -= 1
    if not joined.links:
        joined.domain.__del__()  # cyclonedds has no other way to close it, and garbage collection may come late
        del _joined[number]


def is_on_loopback(settings: Settings) -> bool:
    """Return whether the settings limit discovery to this computer."""
    return settings.discovery_range == 'OFF' or (settings.discovery_range == 'LOCALHOST' and not settings.static_peers)


def configuration(settings: Settings) -> str:
    """Return Cyclone DDS's configuration for the loopback interface only, or for the computer's network.

    On the loopback interface, multicast is used, too, because programs without settings announce themselves in this way.
    These multicast packets do not leave the computer.
    """
    peers = [] if settings.discovery_range == 'OFF' else list(settings.static_peers)
    on_loopback = is_on_loopback(settings)
    multicast = settings.discovery_range == 'SUBNET' or (on_loopback and settings.discovery_range != 'OFF')
    if settings.discovery_range == 'LOCALHOST':
        peers.insert(0, LOCALHOST)
    fragments = LARGE_FRAGMENTS if on_loopback else ''
    interface = f'address="{LOCALHOST}" multicast="true"' if on_loopback else 'autodetermine="true"'
    named = ''.join(f'<Peer Address="{escape(peer)}"/>' for peer in peers)
    return (
        f'<CycloneDDS><Domain><General><Interfaces><NetworkInterface {interface}/></Interfaces>'
        f'<AllowMulticast>{str(multicast).lower()}</AllowMulticast>{fragments}</General>'
        f'<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>{MOST_PARTICIPANTS}</MaxAutoParticipantIndex>'
        f'<InitialLocatorPruneDelay>inf</InitialLocatorPruneDelay><SPDPInterval>{ANNOUNCED_EVERY}</SPDPInterval>'
        f'<Peers>{named}</Peers></Discovery><Internal>{REPEATS}</Internal></Domain></CycloneDDS>'
    )

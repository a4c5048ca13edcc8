"""How far this computer looks for others: the domain's configuration, from ROS 2's variables."""

from __future__ import annotations

import weakref
from html import escape

from cyclonedds.core import DDSException
from cyclonedds.domain import Domain

from edulaunch.network.link import LinkError, Settings

LAST_DOMAIN = 232
MOST_PARTICIPANTS = 32
"""How many participants on one computer find each other without multicast, as in ROS 2's own configuration of Cyclone DDS."""
LOCALHOST = '127.0.0.1'

_domains: weakref.WeakValueDictionary[tuple[int, str], Domain] = weakref.WeakValueDictionary()


def domain_of(settings: Settings) -> Domain:
    """The domain; whoever joins it keeps it. Two links of one program share it.

    :raises LinkError: when there is none of that number, or this program is in it already with other settings.
    """
    if not 0 <= settings.domain <= LAST_DOMAIN:
        raise LinkError(f'ROS_DOMAIN_ID {settings.domain} is not a domain: they go from 0 to {LAST_DOMAIN}')
    key = settings.domain, configuration(settings)
    found = _domains.get(key)
    if found is None:
        try:
            found = _domains[key] = Domain(*key)
        except DDSException as error:
            raise LinkError(f'cannot join domain {settings.domain}: {error}') from None
    return found


def configuration(settings: Settings) -> str:
    """Cyclone DDS's configuration: loopback alone, or the computer's network.

    On the loopback multicast is used too (it does not leave it): that is where programs without settings of their own call.
    """
    peers = [] if settings.discovery_range == 'OFF' else list(settings.static_peers)
    on_loopback = settings.discovery_range != 'SUBNET' and not peers
    multicast = settings.discovery_range == 'SUBNET' or (on_loopback and settings.discovery_range != 'OFF')
    if settings.discovery_range == 'LOCALHOST':
        peers.insert(0, LOCALHOST)
    interface = f'address="{LOCALHOST}" multicast="true"' if on_loopback else 'autodetermine="true"'
    named = ''.join(f'<Peer Address="{escape(peer)}"/>' for peer in peers)
    return (
        f'<CycloneDDS><Domain><General><Interfaces><NetworkInterface {interface}/></Interfaces>'
        f'<AllowMulticast>{str(multicast).lower()}</AllowMulticast></General>'
        f'<Discovery><ParticipantIndex>auto</ParticipantIndex><MaxAutoParticipantIndex>{MOST_PARTICIPANTS}</MaxAutoParticipantIndex>'
        f'<Peers>{named}</Peers></Discovery></Domain></CycloneDDS>'
    )

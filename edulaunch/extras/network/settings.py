"""How a terminal's environment says that a machine joins the network: ROS 2's own variables."""

from __future__ import annotations

from collections.abc import Mapping

from edulaunch.engine.nearest import did_you_mean
from edulaunch.extras.network.link import LinkError, Settings

LAST_DOMAIN = 232
RANGES = ('LOCALHOST', 'SUBNET', 'OFF', 'SYSTEM_DEFAULT')


def settings_of(env: Mapping[str, str]) -> Settings:
    """ROS_DOMAIN_ID, ROS_AUTOMATIC_DISCOVERY_RANGE and ROS_STATIC_PEERS.

    Where ROS 2 would look around on the whole subnet because nothing is said, this stays on the loopback.

    :raises LinkError: for what makes no sense.
    """
    domain = env.get('ROS_DOMAIN_ID', '').strip() or '0'
    if not domain.removeprefix('-').isdecimal():
        raise LinkError(f'ROS_DOMAIN_ID is {domain!r}, not a number')
    if not 0 <= int(domain) <= LAST_DOMAIN:
        raise LinkError(f'ROS_DOMAIN_ID {domain} is not a domain: they go from 0 to {LAST_DOMAIN}')
    wide = env.get('ROS_AUTOMATIC_DISCOVERY_RANGE', '').strip() or 'LOCALHOST'
    if wide not in RANGES:
        text = f'ROS_AUTOMATIC_DISCOVERY_RANGE is {wide!r}: LOCALHOST, SUBNET, OFF and SYSTEM_DEFAULT are known'
        raise LinkError(text, help=did_you_mean(wide, RANGES) or None)
    if env.get('ROS_LOCALHOST_ONLY') == '1' or wide == 'SYSTEM_DEFAULT':
        wide = 'LOCALHOST'
    peers = tuple(filter(None, (peer.strip() for peer in env.get('ROS_STATIC_PEERS', '').split(';'))))
    return Settings(int(domain), wide, peers if wide != 'OFF' else ())


def nobody_found(settings: Settings) -> str:
    """What to look at when no real node is there, in the order in which it is cheap."""
    if settings.discovery_range == 'OFF':
        return 'ROS_AUTOMATIC_DISCOVERY_RANGE is OFF: nobody is looked for'
    domain = f'do they have ROS_DOMAIN_ID={settings.domain}, in every terminal?'
    if settings.discovery_range == 'LOCALHOST' and not settings.static_peers:
        return f'{domain} On another computer: ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET edulaunch network on'
    if settings.static_peers:
        return f'{domain} Do they name this computer in ROS_STATIC_PEERS? Does a firewall stop UDP?'
    return f'{domain} Does the network let multicast through? If not, name each other in ROS_STATIC_PEERS'

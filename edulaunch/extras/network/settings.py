"""Read how a machine joins the network from the environment variables of a terminal. The variables have ROS 2's names."""

from __future__ import annotations

from collections.abc import Mapping

from edulaunch.engine.nearest import did_you_mean
from edulaunch.extras.network.network_link import LinkError, Settings

LAST_DOMAIN = 232
RANGES = ('LOCALHOST', 'SUBNET', 'OFF', 'SYSTEM_DEFAULT')


def settings_of(env: Mapping[str, str]) -> Settings:
    """Return the settings in ROS_DOMAIN_ID, ROS_AUTOMATIC_DISCOVERY_RANGE and ROS_STATIC_PEERS.

    Without a discovery range, ROS 2 searches the whole subnet, but a simulated machine stays on the loopback.

    :raises LinkError: for invalid values.
    """
    domain = env.get('ROS_DOMAIN_ID', '').strip() or '0'
    if not domain.removeprefix('-').isdecimal():
        raise LinkError(f'ROS_DOMAIN_ID is {domain!r}, not a number')
    if not 0 <= int(domain) <= LAST_DOMAIN:
        raise LinkError(f'ROS_DOMAIN_ID must be from 0 to {LAST_DOMAIN}, not {domain}')
    wide = env.get('ROS_AUTOMATIC_DISCOVERY_RANGE', '').strip() or 'LOCALHOST'
    if wide not in RANGES:
        text = f'ROS_AUTOMATIC_DISCOVERY_RANGE is {wide!r}: use LOCALHOST, SUBNET, OFF or SYSTEM_DEFAULT'
        raise LinkError(text, help=did_you_mean(wide, RANGES) or None)
    if env.get('ROS_LOCALHOST_ONLY') == '1' or wide == 'SYSTEM_DEFAULT':
        wide = 'LOCALHOST'
    peers = tuple(filter(None, (peer.strip() for peer in env.get('ROS_STATIC_PEERS', '').split(';'))))
    return Settings(int(domain), wide, peers if wide != 'OFF' else ())


def nobody_found(settings: Settings) -> str:
    """Return what to check if no real node is found. The easiest check comes first."""
    if settings.discovery_range == 'OFF':
        return 'ROS_AUTOMATIC_DISCOVERY_RANGE is OFF, so this machine does not search for nodes'
    domain = f'check that all terminals have ROS_DOMAIN_ID={settings.domain}.'
    if settings.discovery_range == 'LOCALHOST' and not settings.static_peers:
        return f'{domain} For nodes on another computer, type ROS_AUTOMATIC_DISCOVERY_RANGE=SUBNET edulaunch network on'
    if settings.static_peers:
        return f'{domain} Do they name this computer in ROS_STATIC_PEERS? Does a firewall stop UDP?'
    return f'{domain} Does the network let multicast through? If not, name each other in ROS_STATIC_PEERS'

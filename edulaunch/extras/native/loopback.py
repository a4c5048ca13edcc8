"""Keep programs on the real rclpy on this computer. Without this limit, DDS binds sockets that other computers can reach."""

from __future__ import annotations

import os
from collections.abc import Mapping

PROFILES = ('FASTRTPS_DEFAULT_PROFILES_FILE', 'FASTDDS_DEFAULT_PROFILES_FILE')
"""The environment variables for the configuration of Fast DDS."""
_PROFILE = os.path.join(os.path.dirname(__file__), 'loopback.xml')


def is_alone(env: Mapping[str, str]) -> bool:
    """Return whether an environment limits programs to this computer, that is, LOCALHOST and no static peers."""
    wide = env.get('ROS_AUTOMATIC_DISCOVERY_RANGE', '').strip()
    has_peers = any(peer.strip() for peer in env.get('ROS_STATIC_PEERS', '').split(';'))
    return (wide == 'LOCALHOST' or env.get('ROS_LOCALHOST_ONLY') == '1') and not has_peers


def confined(env: Mapping[str, str]) -> dict[str, str]:
    """Return the environment for a program on the real rclpy. On this computer, Fast DDS then uses only loopback and shared
    memory.

    A configuration of the user does not change.
    """
    own = {name: value for name, value in env.items() if not (name == PROFILES[0] and value == _PROFILE)}
    if is_alone(own) and not any(own.get(name) for name in PROFILES):
        own[PROFILES[0]] = _PROFILE
    return own

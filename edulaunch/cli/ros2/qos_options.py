"""The `--qos-*` options of `ros2 topic`."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING, Any

if TYPE_CHECKING:
    from rclpy.qos import QoSProfile

PRESETS = (
    'unknown',
    'default',
    'system_default',
    'sensor_data',
    'services_default',
    'parameters',
    'parameter_events',
    'action_status_default',
    'best_available',
)
POLICIES = {
    'history': ('system_default', 'keep_last', 'keep_all'),
    'reliability': ('system_default', 'reliable', 'best_effort', 'best_available'),
    'durability': ('system_default', 'transient_local', 'volatile', 'best_available'),
    'liveliness': ('system_default', 'automatic', 'manual_by_topic', 'best_available'),
}


def add_arguments(parser: argparse.ArgumentParser, default: str) -> None:
    """A preset, and each policy over it."""
    parser.add_argument(
        '--qos-profile', choices=PRESETS, default=default, help=f'Quality of service preset profile (default: {default})'
    )
    parser.add_argument('--qos-depth', metavar='N', type=int, help='Queue size setting (overrides depth of the profile)')
    for policy, values in POLICIES.items():
        parser.add_argument(
            f'--qos-{policy}', choices=values, help=f'Quality of service {policy} setting (overrides the profile)'
        )


def is_chosen(arguments: argparse.Namespace) -> bool:
    """Whether the command line says anything about reliability or durability."""
    return arguments.qos_reliability is not None or arguments.qos_durability is not None


def profile(arguments: argparse.Namespace) -> QoSProfile:
    """The profile that the options say."""
    from rclpy import qos

    preset = qos.QoSPresetProfiles.get_from_short_key(arguments.qos_profile)
    values: dict[str, Any] = {name: getattr(preset, name) for name in ('depth', *POLICIES)}
    kinds = {
        'history': qos.HistoryPolicy,
        'reliability': qos.ReliabilityPolicy,
        'durability': qos.DurabilityPolicy,
        'liveliness': qos.LivelinessPolicy,
    }
    for policy, kind in kinds.items():
        key = getattr(arguments, f'qos_{policy}')
        if key is not None:
            values[policy] = kind.get_from_short_key(key)
    if arguments.qos_depth is not None:
        values['depth'] = arguments.qos_depth
    return qos.QoSProfile(**values)

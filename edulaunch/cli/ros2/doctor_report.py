"""The sections of `ros2 doctor --report`."""

from __future__ import annotations

import platform
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import doctor_checks
from edulaunch.cli.ros2.output import say
from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.node import Node

Rows = list[tuple[str, str]]
GAP = 4
"""Columns between the longest name and the colon."""


def say_report(node: Node, names: Iterable[str], exclude_packages: bool) -> None:
    """Print the sections of these checks: a heading, and rows of name and value."""
    for name in names:
        if name in SECTIONS and not (exclude_packages and name == 'package'):
            heading, rows_of = SECTIONS[name]
            rows = rows_of(node)
            width = max((len(key) for key, _ in rows), default=0) + GAP
            say('\n'.join(['', f'   {heading}', *(f'{key:<{width}}: {value}' for key, value in rows)]))


def _network(node: Node) -> Rows:
    return [('inet', '127.0.0.1'), ('inet4', "['127.0.0.1']"), ('name', 'lo'), ('flags', 'simulated')]


def _packages(node: Node) -> Rows:
    return [(name, prefix) for name, prefix in current_process().index.packages().items()]


def _platform(node: Node) -> Rows:
    return [
        ('system', platform.system()),
        ('platform info', platform.platform()),
        ('release', platform.release()),
        ('processor', platform.machine()),
    ]


def _compatibility(node: Node) -> Rows:
    rows = []
    for topic, publisher, subscription, is_compatible, reason in doctor_checks.pairs(node):
        rows += [
            ('topic [type]', f'{topic} [{publisher.topic_type}]'),
            ('publisher node', publisher.node_name),
            ('subscriber node', subscription.node_name),
            ('compatibility status', 'OK' if is_compatible else reason),
        ]
    return rows or [('compatibility status', 'No publisher/subscriber pairs found')]


def _middleware(node: Node) -> Rows:
    return [('middleware name', 'edulaunch (simulated)')]


def _distribution(node: Node) -> Rows:
    return [('distribution name', 'jazzy'), ('distribution type', 'ros2'), ('distribution status', 'simulated by edulaunch')]


def _topics(node: Node) -> Rows:
    rows = []
    for name, publishers, subscriptions in doctor_checks.topics(node):
        rows += [('topic', name), ('publisher count', str(publishers)), ('subscriber count', str(subscriptions))]
    return rows or [('topic', 'none'), ('publisher count', '0'), ('subscriber count', '0')]


SECTIONS: dict[str, tuple[str, Callable[[Node], Rows]]] = {
    'network': ('NETWORK CONFIGURATION', _network),
    'package': ('PACKAGE VERSIONS', _packages),
    'platform': ('PLATFORM INFORMATION', _platform),
    'qos': ('QOS COMPATIBILITY LIST', _compatibility),
    'rmw': ('RMW MIDDLEWARE', _middleware),
    'ros2': ('ROS 2 INFORMATION', _distribution),
    'topic': ('TOPIC LIST', _topics),
}

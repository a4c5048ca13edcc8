"""`ros2 doctor` (or `ros2 wtf`): looks at the packages and the graph, and says what may be wrong, or all that it looks at."""

from __future__ import annotations

import argparse
import platform
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import cli_node, doctor_checks
from edulaunch.cli.ros2.output import complain, say
from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.node import Node


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """A report instead of the checks, and what counts."""
    parser.add_argument('check', nargs='?', choices=('hello',), help='hello: say that terminals of this machine hear each other')
    shown = parser.add_mutually_exclusive_group()
    shown.add_argument('-r', '--report', action='store_true', help='Print all reports.')
    shown.add_argument('-rf', '--report-failed', action='store_true', help='Print reports of failed checks only.')
    parser.add_argument('-ep', '--exclude-packages', action='store_true', help='Exclude package checks or report.')
    parser.add_argument('-iw', '--include-warnings', action='store_true', help='Include warnings as failed checks.')


def main(arguments: argparse.Namespace) -> int:
    """Print warnings, and how many checks passed; 1 when one failed."""
    if arguments.check == 'hello':
        say('All terminals of this simulated machine hear each other: there is no network between them.')
        return 0
    with cli_node.cli_node(argparse.Namespace(spin_time=None, no_daemon=False)) as node:
        if arguments.report:
            say_report(node, SECTIONS, arguments.exclude_packages)
            return 0
        results = doctor_checks.run(node, arguments.exclude_packages)
        failed = [name for name, found in results.items() if found.errors or (arguments.include_warnings and found.warnings)]
        for found in results.values():
            for line in (*found.warnings, *found.errors):
                complain(line)
        if not failed:
            say(f'\nAll {len(results)} checks passed\n')
            return 0
        say(f'\n{len(failed)}/{len(results)} check(s) failed\n\nFailed modules: {" ".join(failed)}\n')
        if arguments.report_failed:
            say_report(node, failed, arguments.exclude_packages)
    return 1


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

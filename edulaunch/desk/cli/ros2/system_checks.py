"""`ros2 doctor` (or `ros2 wtf`): check the packages and the graph, and print warnings or a full report.

The module also contains `ros2 daemon`, which explains that no daemon is needed, and `ros2 multicast`, which sends a datagram
between the terminals of one simulated machine.
"""

from __future__ import annotations

import argparse
import platform
from collections.abc import Callable, Iterable, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.desk.cli.ros2 import cli_node, graph_names
from edulaunch.desk.cli.ros2.output import complain, say
from edulaunch.engine.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.node import Node

UNCHECKED_TOPICS = ('/parameter_events', '/rosout')
Rows = list[tuple[str, str]]
GAP = 4
"""Columns between the longest name and its colon."""
ANSWERS = {'start': 'The daemon has not been started', 'status': 'The daemon is not running', 'stop': 'The daemon is not running'}
CHANNEL = '/_multicast'
"""The hidden topic that represents the network of the machine."""


class Found(NamedTuple):
    """The warnings and errors that a check has found."""

    warnings: list[str]
    errors: list[str]


def run_checks(node: Node, exclude_packages: bool) -> dict[str, Found]:
    """Run all checks. Return the result of each check by its name.

    :param node: the node of the command.
    :param exclude_packages: whether to leave out the check of the packages.
    """
    return {name: check(node) for name, check in CHECKS.items() if not (exclude_packages and name == 'package')}


def known_topics(node: Node) -> list[tuple[str, int, int]]:
    """Return (name, number of publishers, number of subscriptions) for each topic that is not internal to ROS 2."""
    return [
        (name, node.count_publishers(name), node.count_subscribers(name))
        for name, _ in node.get_topic_names_and_types()
        if name not in UNCHECKED_TOPICS and not graph_names.is_hidden(name)
    ]


def connected_pairs(node: Node) -> Iterator[tuple[str, Any, Any, bool, str]]:
    """Yield each pair of a publisher and a subscription of the same topic.

    Each tuple contains the topic, the publisher, the subscription, whether their QoS profiles are compatible, and the reason if
    they are not.
    """
    from rclpy.qos import QoSCompatibility, qos_check_compatible

    for topic, _ in node.get_topic_names_and_types():
        for publisher in node.get_publishers_info_by_topic(topic):
            for subscription in node.get_subscriptions_info_by_topic(topic):
                result, reason = qos_check_compatible(publisher.qos_profile, subscription.qos_profile)
                yield topic, publisher, subscription, result != QoSCompatibility.ERROR, reason


def _nothing(node: Node) -> Found:
    """Return no warnings, because the simulated machine has only one platform and no network."""
    return Found([], [])


def _packages(node: Node) -> Found:
    return Found([_warning(str(line)) for line in current_process().index.warnings], [])


def _topics(node: Node) -> Found:
    lines = []
    for name, publishers, subscriptions in known_topics(node):
        if publishers and not subscriptions:
            lines.append(_warning(f'Publisher without subscriber detected on {name}.'))
        elif subscriptions and not publishers:
            lines.append(_warning(f'Subscriber without publisher detected on {name}.'))
    return Found(lines, [])


def _compatibility(node: Node) -> Found:
    wrong = (f'{topic}: {reason}' for topic, _, _, is_compatible, reason in connected_pairs(node) if not is_compatible)
    return Found([], [_warning(line) for line in dict.fromkeys(wrong)])


def _warning(text: str) -> str:
    """Return a warning in the format of ROS 2.

    The file and line are always the same, because recordings must not depend on the lines of our code.
    """
    return f'ros2doctor/api/topic.py: 42: UserWarning: {text}'


CHECKS: dict[str, Callable[[Node], Found]] = {
    'network': _nothing,
    'package': _packages,
    'platform': _nothing,
    'qos': _compatibility,
    'topic': _topics,
}


def doctor_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options that choose a report, and the options that choose what to check."""
    parser.add_argument(
        'check', nargs='?', choices=('hello',), help='hello: check that the terminals of this machine reach each other'
    )
    shown = parser.add_mutually_exclusive_group()
    shown.add_argument('-r', '--report', action='store_true', help='Print all reports.')
    shown.add_argument('-rf', '--report-failed', action='store_true', help='Print reports of failed checks only.')
    parser.add_argument('-ep', '--exclude-packages', action='store_true', help='Exclude package checks or report.')
    parser.add_argument('-iw', '--include-warnings', action='store_true', help='Include warnings as failed checks.')


def doctor_verb(arguments: argparse.Namespace) -> int:
    """Print the warnings, and the number of passed checks. Return 1 if a check failed, otherwise 0."""
    if arguments.check == 'hello':
        say('All terminals share this simulated machine, so no network is between them.')
        return 0
    with cli_node.cli_node(argparse.Namespace(spin_time=None, no_daemon=False)) as node:
        if arguments.report:
            say_report(node, SECTIONS, arguments.exclude_packages)
            return 0
        results = run_checks(node, arguments.exclude_packages)
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


wtf_arguments, wtf_verb = doctor_arguments, doctor_verb


def say_report(node: Node, names: Iterable[str], exclude_packages: bool) -> None:
    """Print a section of the report for each check. A section has a heading, and rows with a name and a value.

    :param node: the node of the command.
    :param names: the names of the checks.
    :param exclude_packages: whether to leave out the section about the packages.
    """
    for name in names:
        if name in SECTIONS and not (exclude_packages and name == 'package'):
            heading, rows_of = SECTIONS[name]
            rows = rows_of(node)
            width = max((len(key) for key, _ in rows), default=0) + GAP
            say('\n'.join(['', f'   {heading}', *(f'{key:<{width}}: {value}' for key, value in rows)]))


def _network(node: Node) -> Rows:
    host = current_process().host
    real = host.where_on_network()
    if real is not None:
        among = [] if host.is_real else [('simulated nodes among each other', 'in memory')]
        return [('real ROS 2 network', real), *among]
    return [('inet', '127.0.0.1'), ('inet4', "['127.0.0.1']"), ('name', 'lo'), ('flags', 'simulated')]


def _package_rows(node: Node) -> Rows:
    return [(name, prefix) for name, prefix in current_process().index.packages().items()]


def _platform(node: Node) -> Rows:
    return [
        ('system', platform.system()),
        ('platform info', platform.platform()),
        ('release', platform.release()),
        ('processor', platform.machine()),
    ]


def _compatibility_rows(node: Node) -> Rows:
    rows = []
    for topic, publisher, subscription, is_compatible, reason in connected_pairs(node):
        rows += [
            ('topic [type]', f'{topic} [{publisher.topic_type}]'),
            ('publisher node', publisher.node_name),
            ('subscriber node', subscription.node_name),
            ('compatibility status', 'OK' if is_compatible else reason),
        ]
    return rows or [('compatibility status', 'No publisher/subscriber pairs found')]


def _middleware(node: Node) -> Rows:
    real = current_process().host.where_on_network()
    return [('middleware name', 'edulaunch (simulated)' if real is None else real.rpartition(', by ')[2])]


def _distribution(node: Node) -> Rows:
    status = 'launched' if current_process().host.is_real else 'simulated'
    return [('distribution name', 'jazzy'), ('distribution type', 'ros2'), ('distribution status', f'{status} by edulaunch')]


def _topic_rows(node: Node) -> Rows:
    rows = []
    for name, publishers, subscriptions in known_topics(node):
        rows += [('topic', name), ('publisher count', str(publishers)), ('subscriber count', str(subscriptions))]
    return rows or [('topic', 'none'), ('publisher count', '0'), ('subscriber count', '0')]


SECTIONS: dict[str, tuple[str, Callable[[Node], Rows]]] = {
    'network': ('NETWORK CONFIGURATION', _network),
    'package': ('PACKAGE VERSIONS', _package_rows),
    'platform': ('PLATFORM INFORMATION', _platform),
    'qos': ('QOS COMPATIBILITY LIST', _compatibility_rows),
    'rmw': ('RMW MIDDLEWARE', _middleware),
    'ros2': ('ROS 2 INFORMATION', _distribution),
    'topic': ('TOPIC LIST', _topic_rows),
}


def daemon_arguments(parser: argparse.ArgumentParser) -> None:
    """Add no arguments, because no verb of `ros2 daemon` has any here."""


def daemon_verb(arguments: argparse.Namespace) -> None:
    """Print that no daemon runs, and why the simulation does not need one."""
    say(f'{ANSWERS[arguments.verb]}: none is needed here, because each command queries the simulated machine directly')


def multicast_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the option for the time to wait."""
    parser.add_argument('--timeout', type=float, default=None, help='Maximum time to wait for datagrams (default: forever)')


def multicast_verb(arguments: argparse.Namespace) -> str | None:
    """Send a datagram, or wait for a datagram. Return an error message if that failed."""
    from std_msgs.msg import String

    if arguments.verb == 'receive':
        return _receive(String, arguments.timeout)
    say('Sending one UDP multicast datagram...')
    with cli_node.cli_node() as node:
        node.create_publisher(String, CHANNEL, 1).publish(String(data='Hello World!'))
    return None


def _receive(cls: Any, timeout_s: float | None) -> str | None:
    import rclpy

    done = rclpy.task.Future()
    say('Waiting for UDP multicast datagram...')
    with cli_node.cli_node() as node:
        node.create_subscription(cls, CHANNEL, done.set_result, 1)
        rclpy.spin_until_future_complete(node, done, timeout_sec=timeout_s)
        message: Any = done.result()
    if message is None:
        return 'No datagram received within the timeout'
    say(f'Received from 127.0.0.1:49150: {message.data!r}')
    return None

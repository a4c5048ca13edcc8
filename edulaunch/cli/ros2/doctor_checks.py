"""What `ros2 doctor` checks."""

from __future__ import annotations

import sys
from collections.abc import Callable, Iterator
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.cli.ros2.names import is_hidden
from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.node import Node

UNCHECKED_TOPICS = ('/parameter_events', '/rosout')


class Found(NamedTuple):
    """The lines that a check has to say."""

    warnings: list[str]
    errors: list[str]


def run(node: Node, exclude_packages: bool) -> dict[str, Found]:
    """The outcome of each check by its name."""
    return {name: check(node) for name, check in CHECKS.items() if not (exclude_packages and name == 'package')}


def topics(node: Node) -> list[tuple[str, int, int]]:
    """Name, publishers and subscriptions of each topic that is no part of ROS 2 itself."""
    return [
        (name, node.count_publishers(name), node.count_subscribers(name))
        for name, _ in node.get_topic_names_and_types()
        if name not in UNCHECKED_TOPICS and not is_hidden(name)
    ]


def pairs(node: Node) -> Iterator[tuple[str, Any, Any, bool, str]]:
    """Each publisher with each subscription of its topic: topic, both ends, whether they fit, and why not."""
    from rclpy.qos import QoSCompatibility, qos_check_compatible

    for topic, _ in node.get_topic_names_and_types():
        for publisher in node.get_publishers_info_by_topic(topic):
            for subscription in node.get_subscriptions_info_by_topic(topic):
                result, reason = qos_check_compatible(publisher.qos_profile, subscription.qos_profile)
                yield topic, publisher, subscription, result != QoSCompatibility.ERROR, reason


def _nothing(node: Node) -> Found:
    """The simulated machine has one platform and no network, so nothing can be wrong with them."""
    return Found([], [])


def _packages(node: Node) -> Found:
    return Found([_warning(str(line)) for line in current_process().index.warnings], [])


def _topics(node: Node) -> Found:
    lines = []
    for name, publishers, subscriptions in topics(node):
        if publishers and not subscriptions:
            lines.append(_warning(f'Publisher without subscriber detected on {name}.'))
        elif subscriptions and not publishers:
            lines.append(_warning(f'Subscriber without publisher detected on {name}.'))
    return Found(lines, [])


def _compatibility(node: Node) -> Found:
    wrong = (f'{topic}: {reason}' for topic, _, _, is_compatible, reason in pairs(node) if not is_compatible)
    return Found([], [_warning(line) for line in dict.fromkeys(wrong)])


def _warning(text: str) -> str:
    """A warning as Python prints it: with the file and line of the check."""
    return f'{__name__.replace(".", "/")}.py: {sys._getframe(1).f_lineno}: UserWarning: {text}'


CHECKS: dict[str, Callable[[Node], Found]] = {
    'network': _nothing,
    'package': _packages,
    'platform': _nothing,
    'qos': _compatibility,
    'topic': _topics,
}

"""What `ros2 topic hz`, `bw` and `delay` share: listen to a topic and print a report each second at most."""

from __future__ import annotations

import argparse
from typing import Any, Protocol

from edulaunch.cli.ros2 import cli_node
from edulaunch.cli.ros2.output import say
from edulaunch.cli.ros2.topic_class import topic_class
from edulaunch.sim.task import current_task

REPORT_EVERY_NS = 1_000_000_000


class Measure(Protocol):
    """Takes messages, gives reports."""

    def take(self, message: Any, now_ns: int) -> None:
        """One message (serialized when the measure asks for raw bytes)."""

    def report(self) -> str | None:
        """The lines to print, None when there is nothing to say."""


def add_arguments(parser: argparse.ArgumentParser, window: int) -> None:
    """The topic, and how many messages count."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_name', help="Name of the ROS topic to tap into (e.g. '/chatter')")
    parser.add_argument(
        '-w',
        '--window',
        metavar='WINDOW',
        type=_positive,
        default=window,
        help=f'window size, in # of messages, for calculating rate (default: {window})',
    )


def _positive(text: str) -> int:
    value = int(text)
    if value <= 0:
        raise argparse.ArgumentTypeError('Value must be positive')
    return value


def listen(
    arguments: argparse.Namespace, measure: Measure, *, verb: str, heading: str | None = None, raw: bool = False
) -> str | None:
    """Feed the measure and print its reports until interrupted; returns the text of an error."""
    import rclpy
    from rclpy.qos import qos_profile_sensor_data

    with cli_node.cli_node(arguments) as node:
        cls = topic_class(node, arguments.topic_name, None, verb=verb, wait=True)
        if isinstance(cls, str):
            return cls
        reports = Reports(measure)
        topic = node.resolve_topic_name(arguments.topic_name)
        node.create_subscription(cls, topic, reports.on_message, qos_profile_sensor_data, raw=raw)
        if heading is not None:
            say(heading.format(topic=topic))
        rclpy.spin(node)
    return None


class Reports:
    """Prints a report with the first message that comes a second or more after the last one."""

    def __init__(self, measure: Measure) -> None:
        self._measure = measure
        self._last_ns: int | None = None

    def on_message(self, message: Any) -> None:
        """Take one message."""
        now = current_task().sim.now_ns
        self._measure.take(message, now)
        if self._last_ns is None:
            self._last_ns = now
        elif now >= self._last_ns + REPORT_EVERY_NS:
            text = self._measure.report()
            if text is not None:
                self._last_ns = now
                say(text)


def spread(values: list[float]) -> tuple[float, float]:
    """Mean and (population) standard deviation."""
    mean = sum(values) / len(values)
    return mean, (sum((value - mean) ** 2 for value in values) / len(values)) ** 0.5

"""`ros2 topic bw|delay|hz`: measure the bandwidth, the delay and the rate of messages."""

from __future__ import annotations

import argparse
from collections import deque
from typing import Any, Protocol

from edulaunch.desk.cli.ros2 import cli_node, graph_names, listening
from edulaunch.desk.cli.ros2.output import positive_int, say
from edulaunch.engine.sim.task import current_task

REPORT_EVERY_NS = 1_000_000_000


class Measure(Protocol):
    """The interface of a measurement, which processes messages and returns reports about them."""

    def take(self, message: Any, now_ns: int) -> None:
        """Process one message.

        :param message: the message, or its serialized bytes if the measurement needs them.
        :param now_ns: the simulated time of arrival in nanoseconds.
        """

    def report(self) -> str | None:
        """Return the lines to print, or None if there is nothing to report."""


def _common_arguments(parser: argparse.ArgumentParser, window: int) -> None:
    """Add the argument for the topic, and the option for the size of the window.

    :param parser: the parser to extend.
    :param window: the default size of the window, in messages.
    """
    graph_names.add_name_arguments(parser, 'topic', 'tap into', '/chatter')
    parser.add_argument(
        '-w',
        '--window',
        metavar='WINDOW',
        type=positive_int,
        default=window,
        help=f'window size, in # of messages, for calculating rate (default: {window})',
    )


def listen(
    arguments: argparse.Namespace, measure: Measure, *, verb: str, heading: str | None = None, raw: bool = False
) -> str | None:
    """Pass each message of a topic to a measurement, and print the reports until Ctrl-C. Return an error message on failure.

    :param measure: the measurement.
    :param verb: the name of the verb for error messages.
    :param heading: a line to print first, or None. It may contain `{topic}`.
    :param raw: whether to pass serialized messages.
    """
    import rclpy
    from rclpy.qos import qos_profile_sensor_data

    with cli_node.cli_node(arguments) as node:
        cls = listening.topic_class(node, arguments.topic_name, None, verb=verb, wait=True)
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
    """Prints a report at most once a second, when a message arrives."""

    def __init__(self, measure: Measure) -> None:
        self._measure = measure
        self._last_ns: int | None = None

    def on_message(self, message: Any) -> None:
        """Process one message, and print a report if the last report is at least a second old."""
        now = current_task().sim.now_ns
        self._measure.take(message, now)
        if self._last_ns is None:
            self._last_ns = now
        elif now >= self._last_ns + REPORT_EVERY_NS:
            text = self._measure.report()
            if text is not None:
                self._last_ns = now
                say(text)


def mean(values: list[float]) -> float:
    """Return the arithmetic mean of some numbers."""
    return sum(values) / len(values)


def spread(values: list[float], window: int) -> str:
    """Return the line with the minimum, the maximum and the standard deviation of a population.

    :param values: the values in seconds.
    :param window: the number of messages to print.
    """
    middle = mean(values)
    deviation = mean([(value - middle) ** 2 for value in values]) ** 0.5
    return f'\tmin: {min(values):.3f}s max: {max(values):.3f}s std dev: {deviation:.5f}s window: {window}'


def bw_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 topic bw`."""
    _common_arguments(parser, 100)


def bw_verb(arguments: argparse.Namespace) -> str | None:
    """Print the bandwidth of a topic once a second."""
    return listen(arguments, Bandwidth(arguments.window), verb='echo', heading='Subscribed to [{topic}]', raw=True)


class Bandwidth:
    """Measures the bandwidth from the arrival times and sizes of the last messages."""

    def __init__(self, window: int) -> None:
        self._taken: deque[tuple[int, int]] = deque(maxlen=window)

    def take(self, message: bytes, now_ns: int) -> None:
        """Record the arrival time and the length of a message, including the CDR header."""
        self._taken.append((now_ns, len(message)))

    def report(self) -> str | None:
        """Return the two lines that `ros2 topic bw` prints, or None if no time has passed."""
        seconds = (current_task().sim.now_ns - self._taken[0][0]) / 1e9
        if seconds <= 0:
            return None
        sizes = [size for _, size in self._taken]
        unit, factor = _unit(max(sizes))
        shown = [
            f'{word}: {size / factor:.2f} {unit}'
            for word, size in (('mean', sum(sizes) / len(sizes)), ('min', min(sizes)), ('max', max(sizes)))
        ]
        rate = sum(sizes) / seconds
        rate_unit, rate_factor = _unit(rate)
        heading = f'{rate / rate_factor:.2f} {rate_unit}/s from {len(sizes)} messages'
        return f'{heading}\n\tMessage size {" ".join(shown)}'


def _unit(size: float) -> tuple[str, float]:
    return ('B', 1.0) if size < 1 else ('KB', 1e3) if size < 1e6 else ('MB', 1e6)


def delay_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 topic delay`."""
    _common_arguments(parser, 10000)


def delay_verb(arguments: argparse.Namespace) -> str | None:
    """Print the delay of the messages of a topic once a second."""
    return listen(arguments, Delay(arguments.window), verb='echo')


class Delay:
    """Measures the delays of the last messages."""

    def __init__(self, window: int) -> None:
        self._delays: deque[float] = deque(maxlen=window)

    def take(self, message: Any, now_ns: int) -> None:
        """Record the time between the stamp of the message's header and the arrival of the message.

        :raises RuntimeError: for a message without a header, with the message of ROS 2.
        """
        if not hasattr(message, 'header'):
            raise RuntimeError(
                'msg does not have header\n  help: only messages with a header have the time when they were created'
            )
        stamp = message.header.stamp
        self._delays.append((now_ns - stamp.sec * 1_000_000_000 - stamp.nanosec) / 1e9)

    def report(self) -> str:
        """Return the two lines that `ros2 topic delay` prints."""
        values = list(self._delays)
        return f'average delay: {mean(values):.3f}\n{spread(values, len(values))}'


def hz_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 topic hz`."""
    _common_arguments(parser, 10000)
    parser.add_argument('--filter', metavar='EXPR', help="only measure messages matching the Python expression, as in 'm.x > 1'")
    parser.add_argument('--wall-time', action='store_true', help='accepted; simulated time is the only one here')


def hz_verb(arguments: argparse.Namespace) -> str | None:
    """Print the rate of a topic once a second."""
    return listen(arguments, Rate(arguments.window, arguments.filter), verb='echo')


class Rate:
    """Measures the intervals between the last messages."""

    def __init__(self, window: int, expression: str | None) -> None:
        self._intervals: deque[float] = deque(maxlen=max(1, window - 1))
        self._last_ns: int | None = None
        self._passes = listening.message_filter(expression)

    def take(self, message: Any, now_ns: int) -> None:
        """Record the time since the previous message that passed the filter."""
        if not self._passes(message):
            return
        if self._last_ns is not None:
            self._intervals.append((now_ns - self._last_ns) / 1e9)
        self._last_ns = now_ns

    def report(self) -> str | None:
        """Return the two lines that `ros2 topic hz` prints, or None if there is no interval yet."""
        if not self._intervals:
            return None
        values = list(self._intervals)
        average = mean(values)
        return f'average rate: {1 / average if average else 0.0:.3f}\n{spread(values, len(values) + 1)}'

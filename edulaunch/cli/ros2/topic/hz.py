"""`ros2 topic hz`: how often messages come."""

from __future__ import annotations

import argparse
from collections import deque
from typing import Any

from edulaunch.cli.ros2 import measuring
from edulaunch.cli.ros2.message_filter import message_filter


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic hz`."""
    measuring.add_arguments(parser, 10000)
    parser.add_argument('--filter', metavar='EXPR', help="only measure messages matching the Python expression, as in 'm.x > 1'")
    parser.add_argument('--wall-time', action='store_true', help='accepted; simulated time is the only one here')


def main(arguments: argparse.Namespace) -> str | None:
    """Print a report each second."""
    return measuring.listen(arguments, Rate(arguments.window, arguments.filter), verb='echo')


class Rate:
    """Intervals between the last messages."""

    def __init__(self, window: int, expression: str | None) -> None:
        self._intervals: deque[float] = deque(maxlen=max(1, window - 1))
        self._last_ns: int | None = None
        self._passes = message_filter(expression)

    def take(self, message: Any, now_ns: int) -> None:
        """Note when it came."""
        if not self._passes(message):
            return
        if self._last_ns is not None:
            self._intervals.append((now_ns - self._last_ns) / 1e9)
        self._last_ns = now_ns

    def report(self) -> str | None:
        """The two lines of ROS 2."""
        if not self._intervals:
            return None
        values = list(self._intervals)
        mean, deviation = measuring.spread(values)
        return (
            f'average rate: {1 / mean if mean else 0.0:.3f}\n'
            f'\tmin: {min(values):.3f}s max: {max(values):.3f}s '
            f'std dev: {deviation:.5f}s window: {len(values) + 1}'
        )

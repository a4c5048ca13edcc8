"""`ros2 topic delay`: how old messages are when they come."""

from __future__ import annotations

import argparse
from collections import deque
from typing import Any

from edulaunch.cli.ros2 import measuring


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic delay`."""
    measuring.add_arguments(parser, 10000)


def main(arguments: argparse.Namespace) -> str | None:
    """Print a report each second."""
    return measuring.listen(arguments, Delay(arguments.window), verb='echo')


class Delay:
    """The last delays."""

    def __init__(self, window: int) -> None:
        self._delays: deque[float] = deque(maxlen=window)

    def take(self, message: Any, now_ns: int) -> None:
        """Note how long ago its header was stamped.

        :raises RuntimeError: for a message without header; in the words of ROS 2.
        """
        if not hasattr(message, 'header'):
            raise RuntimeError('msg does not have header\n  help: only stamped messages tell when they were made')
        stamp = message.header.stamp
        self._delays.append((now_ns - stamp.sec * 1_000_000_000 - stamp.nanosec) / 1e9)

    def report(self) -> str:
        """The two lines of ROS 2."""
        values = list(self._delays)
        mean, deviation = measuring.spread(values)
        return (
            f'average delay: {mean:.3f}\n\tmin: {min(values):.3f}s max: {max(values):.3f}s '
            f'std dev: {deviation:.5f}s window: {len(values)}'
        )

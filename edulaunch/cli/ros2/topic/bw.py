"""`ros2 topic bw`: how many bytes come."""

from __future__ import annotations

import argparse
from collections import deque

from edulaunch.cli.ros2 import measuring
from edulaunch.sim.task import current_task


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic bw`."""
    measuring.add_arguments(parser, 100)


def main(arguments: argparse.Namespace) -> str | None:
    """Print a report each second."""
    return measuring.listen(arguments, Bandwidth(arguments.window), verb='echo', heading='Subscribed to [{topic}]', raw=True)


class Bandwidth:
    """Times and sizes of the last messages."""

    def __init__(self, window: int) -> None:
        self._taken: deque[tuple[int, int]] = deque(maxlen=window)

    def take(self, message: bytes, now_ns: int) -> None:
        """Note when it came and how long it is, CDR header included."""
        self._taken.append((now_ns, len(message)))

    def report(self) -> str | None:
        """The two lines of ROS 2."""
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

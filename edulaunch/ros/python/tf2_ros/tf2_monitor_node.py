"""The program tf2_monitor, which reports the delay and the rate of transforms."""

from __future__ import annotations

import sys
from collections import deque
from collections.abc import Iterable
from typing import Any

import rclpy
from rclcpp_like import CppNode, program
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from rclpy.utilities import remove_ros_args
from tf2_msgs.msg import TFMessage
from tf2_py import TransformException

from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener

AUTHORITY = '<no authority available>'
CYCLE_S = 0.5
CYCLES = 21
KEPT = 1000
NEW_SHARE = 0.01  # weight of the newest net delay in its running average


class Delays:
    """The last 1000 delays of one frame or broadcaster, in seconds."""

    def __init__(self) -> None:
        self.values: deque[float] = deque(maxlen=KEPT)

    def __str__(self) -> str:
        return f'{sum(self.values) / len(self.values):g}'

    @property
    def worst(self) -> float:
        """The largest delay, in seconds."""
        return max(self.values)


class Monitor(CppNode):
    """Monitors /tf and /tf_static, and reports every 10.5 s.

    :param frames: the two ends of the chain to monitor, or an empty list for all frames.
    """

    def __init__(self, frames: tuple[str, str] | None) -> None:
        super().__init__('tf2_monitor_main')
        self.frames = frames
        self.buffer = Buffer()
        self.listener = TransformListener(self.buffer, self)
        self.chain: list[str] = []
        self.by_frame: dict[str, Delays] = {}
        self.all_messages = Delays()
        self.arrivals: deque[int] = deque(maxlen=KEPT)
        self.average, self.worst = 0.0, 0.0
        self.cycle = 0
        self.create_subscription(TFMessage, '/tf', lambda message: self.take(message, False), 100)
        qos = QoSProfile(depth=100, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(TFMessage, '/tf_static', lambda message: self.take(message, True), qos)
        self.create_timer(CYCLE_S, self.on_cycle)

    def age_s(self, stamp: Any) -> float:
        """Return the age of a stamp in seconds."""
        now_ns: int = self.get_clock().now().nanoseconds
        return float(now_ns - stamp.sec * 1_000_000_000 - stamp.nanosec) * 1e-9

    def take(self, message: TFMessage, is_static: bool) -> None:
        """Record the delay of each transform of a message."""
        delays = []
        for transform in message.transforms:
            delays.append(0.0 if is_static else self.age_s(transform.header.stamp))
            self.by_frame.setdefault(transform.child_frame_id, Delays()).values.append(delays[-1])
        self.all_messages.values.append(sum(delays) / max(1, len(delays)))
        self.arrivals.append(self.get_clock().now().nanoseconds)

    def on_cycle(self) -> None:
        """Compute the net delay every half second, and print the report every 21st time."""
        if self.frames is not None and not self._measure(*self.frames):
            return
        self.cycle += 1
        if self.cycle % CYCLES == 0:
            self.report()

    def _measure(self, first: str, second: str) -> bool:
        possible, reason = self.buffer.can_transform(first, second, Time(), return_debug_tuple=True)
        if not possible:
            self.get_logger().info(f'Waiting for transform {first} ->  {second}: {reason}', throttle_duration_sec=1.0)
            return False
        try:
            self.chain = self.chain or self.buffer._chain(
                target_frame=second, target_time=Time(), source_frame=first, source_time=Time(), fixed_frame=second
            )
            stamp = self.buffer.lookup_transform(first, second, Time()).header.stamp
        except TransformException as error:
            self.get_logger().warning(f'Transform Exception {error}')
            return False
        delay = self.age_s(stamp)
        self.average = NEW_SHARE * delay + (1.0 - NEW_SHARE) * self.average
        self.worst = max(self.worst, delay)
        return True

    def report(self) -> None:
        """Print the results so far. As in ROS, frames are printed to stdout, and the heading of the broadcasters to stderr."""
        lines = ['\n\n']
        shown: Iterable[str] = sorted(self.by_frame)
        if self.frames is None:
            lines.append('RESULTS: for all Frames')
        else:
            lines.append(f'RESULTS: for {self.frames[0]} to {self.frames[1]}')
            lines.append(f'Chain is: {" -> ".join(self.chain)}')
            lines.append(f'Net delay     avg = {self.average:g}: max = {self.worst:g}')
            shown = [frame for frame in shown if frame in self.chain]
        lines += ['', 'Frames:']
        lines += [
            f'Frame: {frame}, published by {AUTHORITY}, Average Delay: {self.by_frame[frame]}, '
            f'Max Delay: {self.by_frame[frame].worst:g}'
            for frame in shown
        ]
        sys.stdout.write('\n'.join(lines) + '\n')
        sys.stderr.write('\nAll Broadcasters:\n')
        if self.arrivals:
            rate = len(self.arrivals) / max(1e-8, (self.arrivals[-1] - self.arrivals[0]) * 1e-9)
            sys.stdout.write(
                f'Node: {AUTHORITY} {rate:g} Hz, Average Delay: {self.all_messages} Max Delay: {self.all_messages.worst:g}\n'
            )


def run() -> int:
    """Parse the arguments, and monitor until the program is stopped. Return the exit code."""
    arguments = remove_ros_args(sys.argv)[1:]
    if len(arguments) not in (0, 2):
        sys.stdout.write('TF_Monitor: usage: tf2_monitor framea frameb\n')
        return 1
    frames = (arguments[0], arguments[1]) if arguments else None
    what = f'{frames[0]} -> {frames[1]}' if frames else 'all frames'
    sys.stdout.write(f'Gathering data on {what} for 10 seconds...\n')
    rclpy.spin(Monitor(frames))
    return 0


main = program(run)

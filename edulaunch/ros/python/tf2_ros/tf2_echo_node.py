"""The program tf2_echo, which repeatedly prints the transform between two frames."""

from __future__ import annotations

import math
import sys

import rclpy
from geometry_msgs.msg import TransformStamped
from rclcpp_like import CppNode, program
from rclpy.time import Time
from rclpy.utilities import remove_ros_args
from tf2_py import TransformException

from edulaunch.engine.tf.quaternions import to_euler, to_matrix
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener

USAGE = """\
Usage: tf2_echo source_frame target_frame [echo_rate]

Prints the transform between the two frames: the pose of target_frame seen from source_frame.
It also turns coordinates that are given in target_frame into coordinates in source_frame.
The rate is in Hz of the node's time.
Without echo_rate it is 1.
"""


class Echo(CppNode):
    """Looks up the newest transform at a fixed rate."""

    def __init__(self, source: str, target: str, rate_hz: float) -> None:
        super().__init__('tf2_echo')
        self.source, self.target = source, target
        self.buffer = Buffer(node=self)
        self.listener = TransformListener(self.buffer, self)
        self.found = False
        self.look()
        self.create_timer(1.0 / rate_hz, self.look)

    def look(self) -> None:
        """Print the results of one cycle: the pose, or the reason why it is not available."""
        if not self.found:
            possible, reason = self.buffer.can_transform(self.source, self.target, Time(), return_debug_tuple=True)
            if not possible:
                self.get_logger().info(
                    f'Waiting for transform {self.source} ->  {self.target}: {reason}', throttle_duration_sec=1.0
                )
                return
            self.found = True
        try:
            sys.stdout.write(pose_text(self.buffer.lookup_transform(self.source, self.target, Time())))
        except TransformException as error:
            now = self.get_clock().now().nanoseconds * 1e-9
            sys.stdout.write(
                f'Failure at {now:.3f}\nException thrown:{error}\nThe current list of frames is:\n'
                f'{self.buffer.all_frames_as_string()}\n'
            )


def pose_text(found: TransformStamped) -> str:
    """Return the ten lines about one transform. As in ROS 2, nanoseconds are printed without leading zeros."""
    at, q = found.transform.translation, found.transform.rotation
    rotation = (q.x, q.y, q.z, q.w)
    angles = to_euler(rotation)
    rows = [(*row, shift) for row, shift in zip(to_matrix(rotation), (at.x, at.y, at.z), strict=True)]
    lines = [
        f'At time {found.header.stamp.sec}.{found.header.stamp.nanosec}',
        f'- Translation: {_listed((at.x, at.y, at.z))}',
        f'- Rotation: in Quaternion {_listed(rotation)}',
        f'- Rotation: in RPY (radian) {_listed(angles)}',
        f'- Rotation: in RPY (degree) {_listed(tuple(math.degrees(angle) for angle in angles))}',
        '- Matrix:',
        *(''.join(f' {number:6.3f}' for number in row) for row in [*rows, (0.0, 0.0, 0.0, 1.0)]),
    ]
    return '\n'.join(lines) + '\n'


def _listed(numbers: tuple[float, ...]) -> str:
    return f'[{", ".join(f"{number:.3f}" for number in numbers)}]'


def run() -> int:
    """Parse the arguments, and print until the program is stopped. Return the exit code."""
    arguments = remove_ros_args(sys.argv)[1:]
    if len(arguments) not in (2, 3):
        sys.stdout.write(USAGE)
        return 1
    rate_hz = 1.0
    if len(arguments) == 3:
        try:
            rate_hz = float(arguments[2])
        except ValueError:
            sys.stderr.write(f"Failed to convert rate argument '{arguments[2]}' to a floating-point number\n")
            return 2
    rclpy.spin(Echo(arguments[0], arguments[1], rate_hz))
    return 0


main = program(run)

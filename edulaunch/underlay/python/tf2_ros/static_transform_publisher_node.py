"""The program static_transform_publisher: publishes one transform on /tf_static and stays alive for late
listeners.
"""

from __future__ import annotations

import random
import string
import sys

import rclpy
from geometry_msgs.msg import TransformStamped
from rcl_interfaces.msg import ParameterDescriptor
from rclcpp_like import CppNode, run_program
from rclcpp_like.errors import CppError
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.parameter import Parameter
from rclpy.utilities import remove_ros_args

from tf2_ros.static_transform_arguments import USAGE, ArgumentError, Request, parse
from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster

NUMBERS = ('translation.x', 'translation.y', 'translation.z', 'rotation.x', 'rotation.y', 'rotation.z', 'rotation.w')


class StaticTransformPublisher(CppNode):
    """Publishes its transform once, at its start; read-only parameters show what was asked for."""

    def __init__(self, request: Request) -> None:
        suffix = ''.join(random.choices(string.ascii_letters + string.digits, k=16))
        asked = {
            **dict(zip(NUMBERS, request.transform, strict=True)),
            'frame_id': request.frame_id,
            'child_frame_id': request.child_frame_id,
        }
        super().__init__(
            f'static_transform_publisher_{suffix}',
            parameter_overrides=[Parameter(name, value=value) for name, value in asked.items()],
        )
        message = self._declared()
        if message.header.frame_id == message.child_frame_id:
            self.get_logger().error(
                f"cannot publish static transform from '{message.header.frame_id}' to '{message.child_frame_id}', exiting"
            )
            raise CppError('child_frame_id cannot equal frame_id')
        message.header.stamp = self.get_clock().now().to_msg()
        self.message = message
        self._broadcaster = StaticTransformBroadcaster(self)
        self._broadcaster.sendTransform(message)

    def _declared(self) -> TransformStamped:
        read_only = ParameterDescriptor(read_only=True)
        message = TransformStamped()
        for name in NUMBERS:
            part, axis = name.split('.')
            default = 1.0 if name == 'rotation.w' else 0.0
            setattr(getattr(message.transform, part), axis, self.declare_parameter(name, default, read_only).value)
        message.header.frame_id = self.declare_parameter('frame_id', '/frame', read_only).value
        message.child_frame_id = self.declare_parameter('child_frame_id', '/child', read_only).value
        return message

    def announce(self) -> None:
        """Say what is being published, in four lines of one log message."""
        at, turned = self.message.transform.translation, self.message.transform.rotation
        self.get_logger().info(
            'Spinning until stopped - publishing transform\n'
            f"translation: ('{at.x:.6f}', '{at.y:.6f}', '{at.z:.6f}')\n"
            f"rotation: ('{turned.x:.6f}', '{turned.y:.6f}', '{turned.z:.6f}', '{turned.w:.6f}')\n"
            f"from '{self.message.header.frame_id}' to '{self.message.child_frame_id}'"
        )


def run() -> int:
    """Parse, publish, stay; the exit code."""
    arguments = remove_ros_args(sys.argv)[1:]
    if '--help' in arguments or '-h' in arguments:
        sys.stdout.write(USAGE)
        return 0
    try:
        request = parse(arguments)
    except ArgumentError as reason:
        RcutilsLogger('').error(f'error parsing command line arguments: {reason}')
        sys.stdout.write(USAGE)
        return 1
    if request.old_style:
        RcutilsLogger('').warning('Old-style arguments are deprecated; see --help for new-style arguments')
    node = StaticTransformPublisher(request)
    node.announce()
    rclpy.spin(node)
    return 0


def main() -> None:
    """Run the program; its exit code is that of the original."""
    sys.exit(run_program(run))


if __name__ == '__main__':
    main()

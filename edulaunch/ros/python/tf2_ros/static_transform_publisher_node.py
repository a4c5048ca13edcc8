"""The program static_transform_publisher. It publishes one transform on /tf_static and keeps running for late subscriptions."""

from __future__ import annotations

import random
import re
import string
import sys
from typing import Any, NamedTuple

import rclpy
from geometry_msgs.msg import TransformStamped
from rcl_interfaces.msg import ParameterDescriptor
from rclcpp_like import CppError, CppNode, program
from rclpy.impl.rcutils_logger import RcutilsLogger
from rclpy.parameter import Parameter
from rclpy.utilities import remove_ros_args

from edulaunch.engine.tf.quaternions import from_euler
from edulaunch.engine.tf.transforms import Transform
from tf2_ros.static_transform_broadcaster import StaticTransformBroadcaster

USAGE = """\
usage: static_transform_publisher [--x X] [--y Y] [--z Z] [--qx QX] [--qy QY] [--qz QZ] [--qw QW]
                                  [--roll ROLL] [--pitch PITCH] [--yaw YAW]
                                  --frame-id FRAME_ID --child-frame-id CHILD_FRAME_ID

Publish one transform that never changes. What is left out is zero: no translation, no rotation.

required arguments:
  --frame-id FRAME_ID              parent frame
  --child-frame-id CHILD_FRAME_ID  child frame

optional arguments:
  --x X  --y Y  --z Z              translation in metres
  --qx QX  --qy QY  --qz QZ  --qw QW
                                   rotation as a quaternion
  --roll ROLL  --pitch PITCH  --yaw YAW
                                   rotation as angles in radians (not together with a quaternion)
  -h, --help                       show this text
"""

_QUATERNION, _EULER = ('qx', 'qy', 'qz', 'qw'), ('roll', 'pitch', 'yaw')
_NUMBERS = ('x', 'y', 'z', *_QUATERNION, *_EULER)
_NAMES = ('frame-id', 'child-frame-id')
_NUMBER = re.compile(r'\s*[+-]?(?:inf(?:inity)?|nan|(?:\d+\.?\d*|\.\d+)(?:e[+-]?\d+)?)', re.IGNORECASE)


class ArgumentError(Exception):
    """The command line is invalid. The message contains the reason with ROS 2's wording."""


class Request(NamedTuple):
    """The transform that the command line describes."""

    frame_id: str
    child_frame_id: str
    transform: Transform
    old_style: bool


def parse(arguments: list[str]) -> Request:
    """Parse the arguments after the program's name, without ROS arguments.

    :raises ArgumentError: when the arguments are invalid, with ROS 2's reason.
    """
    if not arguments:
        raise ArgumentError('Not enough arguments to parse')
    flags: dict[str, str] = {}
    rest: list[str] = []
    words = iter(arguments)
    for word in words:
        name = word[2:]
        if word.startswith('--') and name in (*_NUMBERS, *_NAMES):
            value = next(words, None)
            if value is None:
                raise ArgumentError(f'Not enough arguments for {word}')
            flags[name] = value
        else:
            rest.append(word)
    if not rest:
        return _from_flags(flags)
    if flags:
        raise ArgumentError('Cannot specify both new-style (flags) and old-style (arguments)')
    return _from_positions(rest)


def _from_flags(flags: dict[str, str]) -> Request:
    numbers = {name: _number(f'--{name}', text) for name, text in flags.items() if name in _NUMBERS}
    euler = [name for name in _EULER if name in numbers]
    if euler and any(name in numbers for name in _QUATERNION):
        raise ArgumentError('Cannot specify both quaternion and Euler rotations')
    x, y, z = (numbers.get(name, 0.0) for name in ('x', 'y', 'z'))
    if euler:
        rotation = from_euler(*(numbers.get(name, 0.0) for name in _EULER))
    elif any(name in numbers for name in _QUATERNION):
        qx, qy, qz, qw = (numbers.get(name, float(name == 'qw')) for name in _QUATERNION)
        rotation = (qx, qy, qz, qw)
    else:
        rotation = (0.0, 0.0, 0.0, 1.0)
    return _checked(flags.get('frame-id', ''), flags.get('child-frame-id', ''), (x, y, z, *rotation), False)


def _from_positions(words: list[str]) -> Request:
    """Return the request for positional arguments: x y z yaw pitch roll frame child, or x y z qx qy qz qw frame child."""
    if len(words) < 8:
        raise ArgumentError('Not enough arguments to parse')
    if len(words) > 9:
        raise ArgumentError('Extra unparsed arguments on command-line')
    names = ('x', 'y', 'z', *(_QUATERNION if len(words) == 9 else _EULER[::-1]))
    numbers = [_number(f'--{name}', text) for name, text in zip(names, words, strict=False)]
    x, y, z = numbers[:3]
    if len(words) == 9:
        rotation = (numbers[3], numbers[4], numbers[5], numbers[6])
    else:
        rotation = from_euler(numbers[5], numbers[4], numbers[3])
    return _checked(words[-2], words[-1], (x, y, z, *rotation), True)


def _checked(frame_id: str, child_frame_id: str, transform: Transform, old_style: bool) -> Request:
    if not frame_id:
        raise ArgumentError('Frame id must not be empty')
    if not child_frame_id:
        raise ArgumentError('Child frame id must not be empty')
    return Request(frame_id, child_frame_id, transform, old_style)


def _number(option: str, text: str) -> float:
    """Return the float at the start of a string, as C++ does. Characters after the number are ignored."""
    match = _NUMBER.match(text)
    if match is None:
        raise ArgumentError(f'Failed to parse {option} argument as float')
    return float(match.group())


NUMBERS = ('translation.x', 'translation.y', 'translation.z', 'rotation.x', 'rotation.y', 'rotation.z', 'rotation.w')


class StaticTransformBroadcasterNode(CppNode):
    """Publishes one static transform at its start: the component tf2_ros::StaticTransformBroadcasterNode.

    Read-only parameters contain the transform: `translation.x` to `translation.z` in metres, the quaternion `rotation.x` to
    `rotation.w`, `frame_id` and `child_frame_id`.
    """

    def __init__(self, **options: Any) -> None:
        suffix = ''.join(random.choices(string.ascii_letters + string.digits, k=16))
        super().__init__(f'static_transform_publisher_{suffix}', **options)
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
        """Log the published transform, in one message of four lines."""
        at, turned = self.message.transform.translation, self.message.transform.rotation
        self.get_logger().info(
            'Spinning until stopped - publishing transform\n'
            f"translation: ('{at.x:.6f}', '{at.y:.6f}', '{at.z:.6f}')\n"
            f"rotation: ('{turned.x:.6f}', '{turned.y:.6f}', '{turned.z:.6f}', '{turned.w:.6f}')\n"
            f"from '{self.message.header.frame_id}' to '{self.message.child_frame_id}'"
        )


def run() -> int:
    """Parse the arguments, publish, and spin. Return the exit code."""
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
    values = {**dict(zip(NUMBERS, request.transform, strict=True)), 'frame_id': request.frame_id}
    values['child_frame_id'] = request.child_frame_id
    node = StaticTransformBroadcasterNode(parameter_overrides=[Parameter(name, value=value) for name, value in values.items()])
    node.announce()
    rclpy.spin(node)
    return 0


main = program(run)

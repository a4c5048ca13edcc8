"""The program robot_state_publisher, which publishes the transforms of a robot's links, and the program xacro."""

from __future__ import annotations

import os
import sys
from importlib.util import find_spec
from typing import Any

import rclpy
from geometry_msgs.msg import TransformStamped
from rcl_interfaces.msg import ParameterDescriptor
from rclcpp_like import CppError, CppNode, program
from rclpy.parameter import Parameter
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.time import Time
from rclpy.utilities import remove_ros_args
from sensor_msgs.msg import JointState
from std_msgs.msg import String
from tf2_ros import StaticTransformBroadcaster, TransformBroadcaster

from edulaunch.engine.processes.current import current_process
from edulaunch.errors import MissingExtra
from robot_state_publisher._joints import Joint, read_joints


class RobotStatePublisher(CppNode):
    """Publishes fixed joints on /tf_static, and the moving joints in messages on /joint_states on /tf.

    The parameters and their defaults:

    - `robot_description`, the URDF: no default
    - `publish_frequency`, the maximum rate on /tf in Hz: 20.0
    - `ignore_timestamp`, which removes this limit: false
    - `frame_prefix`, the prefix of all frames: ''
    """

    def __init__(self, description: str = '', **options: Any) -> None:
        super().__init__('robot_state_publisher', **options)
        self._joints: dict[str, Joint] = {}
        self._published_ns: dict[str, int] = {}
        self._last_ns = 0
        self.declare_parameter('robot_description', description)
        self.declare_parameter('publish_frequency', 20.0)
        self.declare_parameter('ignore_timestamp', False)
        self.declare_parameter('frame_prefix', '', ParameterDescriptor(description='prefix of all frames'))
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self._fixed, self._moving = StaticTransformBroadcaster(self), TransformBroadcaster(self)
        self._descriptions = self.create_publisher(String, 'robot_description', latched)
        self._set_up(self.get_parameter('robot_description').value)
        self.create_subscription(JointState, 'joint_states', self._on_joint_states, 10)
        self.add_post_set_parameters_callback(self._on_parameters)
        self.get_logger().info('Robot initialized')

    def _set_up(self, description: str) -> None:
        if not description:
            raise CppError('robot_description parameter must not be empty')
        try:
            joints = read_joints(description)
        except ValueError as error:
            self.get_logger().error(f'Error parsing the robot description: {error}')
            raise CppError('Unable to initialize urdf::model from robot description') from None
        self._joints = {joint.name: joint for joint in joints}
        self._descriptions.publish(String(data=description))
        self._publish_fixed()

    def _on_parameters(self, parameters: list[Parameter]) -> None:
        for parameter in parameters:
            if parameter.name == 'robot_description':
                try:
                    self._set_up(parameter.value)
                except CppError as error:
                    self.get_logger().warning(str(error))
            elif parameter.name == 'frame_prefix':
                self._publish_fixed()

    def _publish_fixed(self) -> None:
        now = self.get_clock().now().to_msg()
        fixed = [self._transform(joint, 0.0, now) for joint in self._joints.values() if not joint.is_moving]
        if fixed:
            self._fixed.sendTransform(fixed)

    def _on_joint_states(self, state: JointState) -> None:
        """Publish the joints of the message and the joints that mimic them, unless the last publication was too recent."""
        if len(state.name) != len(state.position):
            text = 'Robot state publisher ignored a JointState message about joint(s) with mismatched sizes of name and position'
            self.get_logger().error(text) if state.position else None
            return
        now = self.get_clock().now().nanoseconds
        if now < self._last_ns:
            self.get_logger().warning('Moved backwards in time, re-publishing joint transforms!')
            self._published_ns.clear()
        self._last_ns = now
        stamp_ns = Time.from_msg(state.header.stamp).nanoseconds
        last = min((self._published_ns.get(name, 0) for name in state.name), default=0)
        shortest = round(1e9 / self.get_parameter('publish_frequency').value)
        if self.get_parameter('ignore_timestamp').value or stamp_ns >= last + shortest:
            self._publish_moving(dict(zip(state.name, state.position, strict=True)), state.header.stamp)
            self._published_ns.update(dict.fromkeys(state.name, stamp_ns))

    def _publish_moving(self, positions: dict[str, float], stamp: Any) -> None:
        for joint in self._joints.values():
            if joint.mimic is not None and joint.mimic.joint in positions:
                positions[joint.name] = positions[joint.mimic.joint] * joint.mimic.multiplier + joint.mimic.offset
        moving = [
            self._transform(joint, positions[joint.name], stamp)
            for joint in self._joints.values()
            if joint.is_moving and joint.name in positions
        ]
        if moving:
            self._moving.sendTransform(moving)

    def _transform(self, joint: Joint, position: float, stamp: Any) -> TransformStamped:
        prefix = self.get_parameter('frame_prefix').value
        message = TransformStamped()
        message.header.stamp = stamp
        message.header.frame_id, message.child_frame_id = prefix + joint.parent, prefix + joint.child
        place, turn = message.transform.translation, message.transform.rotation
        (place.x, place.y, place.z), (turn.x, turn.y, turn.z, turn.w) = joint.transform(position)
        return message


def _work() -> None:
    files = remove_ros_args(sys.argv)[1:]
    if not files:
        rclpy.spin(RobotStatePublisher())
        return
    try:
        with open(_from_here(files[0]), encoding='utf-8') as file:
            rclpy.spin(RobotStatePublisher(file.read()))
    except OSError as error:
        raise CppError(f'{files[0]}: {error.strerror}') from None


main = program(_work)


BANNER = 4
"""The number of comments that the library puts before a description."""


def _from_here(path: str) -> str:
    """Return the absolute path for a path that is relative to the folder of the terminal. The library itself runs in the
    machine's folder.
    """
    return os.path.join(current_process().cwd or '', path)


def run_xacro() -> int:
    """Run the program xacro: expand the macros of a robot description with the library xacro, and print the result.

    `xacro FILE name:=value ... [-o OUT]` returns 2 for a file that the library cannot expand.
    """
    if find_spec('xacro') is None:
        raise SystemExit(str(MissingExtra('the program xacro', 'the Python package xacro', 'urdf')))
    import xacro

    options, file = xacro.process_args(sys.argv[1:])
    try:
        document = xacro.process_file(_from_here(file), **vars(options))
        for _ in range(BANNER):  # remove the comments with the path of the file, which differs on each machine
            document.removeChild(document.firstChild)
        text = document.toprettyxml(indent='  ')
    except Exception as error:  # expressions in the file are Python, so they may raise any exception
        print(f'error: {error}\nwhen processing file: {file}', file=sys.stderr)
        return 2
    if options.output is None:
        print(text, end='')
        return 0
    with open(_from_here(options.output), 'w', encoding='utf-8') as out:
        out.write(text)
    return 0

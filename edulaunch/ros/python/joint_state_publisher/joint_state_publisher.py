"""The program joint_state_publisher, which publishes a position for each joint of the robot description."""

from __future__ import annotations

import sys
from math import pi
from typing import Any

import rclpy
from rclpy.node import Node
from rclpy.qos import DurabilityPolicy, QoSProfile
from rclpy.utilities import remove_ros_args
from robot_state_publisher._joints import Joint, Mimic, read_joints
from sensor_msgs.msg import JointState
from std_msgs.msg import String

from edulaunch.ros.running import run

DEFAULTS: dict[str, Any] = {
    'rate': 10,
    'publish_default_positions': True,
    'publish_default_velocities': False,
    'publish_default_efforts': False,
    'use_mimic_tags': True,
    'use_smallest_joint_limits': True,
    'delta': 0.0,
}


class JointStatePublisher(Node):
    """Publishes /joint_states at `rate` (Hz). The topics of `source_list` and the parameters `zeros.JOINT` set the positions.

    Other free joints are at 0, or in the middle of their limits if the limits exclude 0. A joint that mimics another joint
    follows that joint.

    :param description: the URDF string. If it is empty, the node waits for the topic robot_description.
    """

    def __init__(self, description: str = '') -> None:
        super().__init__(
            'joint_state_publisher', allow_undeclared_parameters=True, automatically_declare_parameters_from_overrides=True
        )
        for name, value in DEFAULTS.items():
            if not self.has_parameter(name):
                self.declare_parameter(name, value)
        self._positions: dict[str, float] = {}
        self._limits: dict[str, tuple[float, float]] = {}
        self._followers: dict[str, Mimic] = {}
        self._states = self.create_publisher(JointState, 'joint_states', 10)
        for topic in self._given('source_list', []):
            self.create_subscription(JointState, topic, self._on_source, 10)
        if description:
            self._read(description)
        else:
            self.get_logger().info('Waiting for robot_description to be published on the robot_description topic...')
        latched = QoSProfile(depth=1, durability=DurabilityPolicy.TRANSIENT_LOCAL)
        self.create_subscription(String, 'robot_description', lambda message: self._read(message.data), latched)
        self._step = float(self._given('delta', 0.0))
        self._timer = self.create_timer(1.0 / self.get_parameter('rate').value, self._on_timer)

    def _given(self, name: str, default: Any) -> Any:
        return self.get_parameter(name).value if self.has_parameter(name) else default

    def _read(self, description: str) -> None:
        try:
            joints = [joint for joint in read_joints(description) if joint.is_moving]
        except ValueError as error:
            self.get_logger().warning(f'Invalid robot_description given, ignoring: {error}')
            return
        self._followers = {joint.name: mimic for joint in joints if (mimic := self._mimic(joint)) is not None}
        self._limits = {joint.name: _limits(joint) for joint in joints}
        self._positions = {joint.name: self._given(f'zeros.{joint.name}', _middle(*self._limits[joint.name])) for joint in joints}

    def _mimic(self, joint: Joint) -> Mimic | None:
        """Return which joint a joint follows and how, from the parameters or from the `mimic` tag."""
        name = f'dependent_joints.{joint.name}'
        parent = self._given(f'{name}.parent', None)
        if parent is not None:
            return Mimic(parent, float(self._given(f'{name}.factor', 1.0)), float(self._given(f'{name}.offset', 0.0)))
        return joint.mimic if self.get_parameter('use_mimic_tags').value else None

    def _on_source(self, state: JointState) -> None:
        for name, position in zip(state.name, state.position, strict=False):
            if name in self._positions and name not in self._followers:
                self._positions[name] = position

    def _on_timer(self) -> None:
        if not self._positions:
            return
        if self._step:
            self._swing()
        state = JointState()
        state.header.stamp = self.get_clock().now().to_msg()
        state.name = list(self._positions)
        if self.get_parameter('publish_default_positions').value:
            state.position = [self._position(name) for name in self._positions]
        if self.get_parameter('publish_default_velocities').value:
            state.velocity = [0.0] * len(state.name)
        if self.get_parameter('publish_default_efforts').value:
            state.effort = [0.0] * len(state.name)
        self._states.publish(state)

    def _position(self, name: str, seen: tuple[str, ...] = ()) -> float:
        follows = self._followers.get(name)
        if follows is None or name in seen or follows.joint not in self._positions:
            return float(self._positions.get(name, 0.0))
        return self._position(follows.joint, (*seen, name)) * follows.multiplier + follows.offset

    def _swing(self) -> None:
        """Move each free joint by `delta`, back and forth within its limits."""
        turns = False
        for name, (lower, upper) in self._limits.items():
            if name in self._followers:
                continue
            moved = self._positions[name] + self._step
            turns |= not lower < moved < upper
            self._positions[name] = min(max(moved, lower), upper)
        if turns:
            self._step = -self._step


def _limits(joint: Joint) -> tuple[float, float]:
    return (-pi, pi) if joint.kind == 'continuous' else (joint.lower, joint.upper)


def _middle(lower: float, upper: float) -> float:
    return 0.0 if lower <= 0.0 <= upper else (lower + upper) / 2.0


def work() -> None:
    """Spin the node. A file on the command line is the robot description."""
    files = remove_ros_args(sys.argv)[1:]
    description = ''
    if files:
        with open(files[0], encoding='utf-8') as file:
            description = file.read()
    rclpy.spin(JointStatePublisher(description))


def main(args: list[str] | None = None) -> None:
    """Run the program."""
    run(work, args)


if __name__ == '__main__':
    main()

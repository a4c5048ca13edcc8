"""Publishers and subscribers of `chatter`.

These are talker and listener, their variants talker_qos and listener_qos for any quality of service, and listener_serialized.
"""

from __future__ import annotations

import sys
from collections.abc import Callable

import rclpy
from rclpy.node import Node
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from rclpy.utilities import remove_ros_args
from std_msgs.msg import String

from edulaunch.ros.running import run, spin

PERIOD_S = 1.0


class Talker(Node):
    """Publishes a message every second, counting from 0."""

    def __init__(self, node_name: str = 'talker', qos: QoSProfile | int = 10) -> None:
        super().__init__(node_name)
        self.count = 0
        self._chatter = self.create_publisher(String, 'chatter', qos)
        self._timer = self.create_timer(PERIOD_S, self._on_timer)

    def _on_timer(self) -> None:
        message = String(data=f'Hello World: {self.count}')
        self.count += 1
        self.get_logger().info(f'Publishing: "{message.data}"')
        self._chatter.publish(message)


class Listener(Node):
    """Logs each message."""

    def __init__(self, node_name: str = 'listener', qos: QoSProfile | int = 10) -> None:
        super().__init__(node_name)
        self.count = 0
        self._chatter = self.create_subscription(String, 'chatter', self._on_message, qos)

    def _on_message(self, message: String) -> None:
        self.count += 1
        self.get_logger().info(f'I heard: [{message.data}]')


class SerializedListener(Node):
    """Receives messages in serialized form."""

    def __init__(self) -> None:
        super().__init__('serialized_subscriber')
        self._chatter = self.create_subscription(String, 'chatter', self._on_bytes, 10, raw=True)

    def _on_bytes(self, serialized: bytes) -> None:
        self.get_logger().info(f'I heard: "{serialized!r}"')


MakeNode = Callable[[str, QoSProfile], 'Talker | Listener']


def _run_with_quality(verb: str, node_stem: str, make_node: MakeNode) -> None:
    """Run a node with the requested quality of service, until it has handled enough messages."""
    import argparse

    parser = argparse.ArgumentParser(formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument('--reliable', action='store_true', help=f'{verb} reliably instead of best effort')
    parser.add_argument('-n', '--number_of_cycles', type=int, default=20, help='messages before ending')
    options = parser.parse_args(remove_ros_args(sys.argv)[1:])
    qos = QoSProfile(depth=10) if options.reliable else qos_profile_sensor_data

    def body() -> None:
        node = make_node(f'{node_stem}_qos', qos)
        node.get_logger().info('Reliable ' + node_stem if options.reliable else 'Best effort ' + node_stem)
        while rclpy.ok() and node.count < options.number_of_cycles:
            rclpy.spin_once(node)

    run(body)


def talker() -> None:
    """Publish a numbered greeting every second."""
    spin(Talker)


def listener() -> None:
    """Log each message."""
    spin(Listener)


def listener_serialized() -> None:
    """Log the bytes of each message."""
    spin(SerializedListener)


def talker_qos() -> None:
    """Publish a fixed number of messages like talker. The reliability is best effort unless --reliable is given."""
    _run_with_quality('publish', 'talker', Talker)


def listener_qos() -> None:
    """Log a fixed number of messages like listener. The reliability is best effort unless --reliable is given."""
    _run_with_quality('listen', 'listener', Listener)

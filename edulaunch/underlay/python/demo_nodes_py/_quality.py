"""The options of talker_qos and listener_qos, and how long these programs run."""

from __future__ import annotations

from collections.abc import Callable

import rclpy
from rclpy.qos import QoSProfile, qos_profile_sensor_data
from rclpy.utilities import remove_ros_args

from demo_nodes_py._chatter import Listener, Talker
from demo_nodes_py._running import run

MakeNode = Callable[[str, QoSProfile], 'Talker | Listener']


def run_with_quality(arguments: list[str], verb: str, node_stem: str, make_node: MakeNode) -> None:
    """Run a node with the quality of service that was asked for, until it has handled enough messages."""
    import argparse

    parser = argparse.ArgumentParser(formatter_class=argparse.ArgumentDefaultsHelpFormatter)
    parser.add_argument('--reliable', action='store_true', help=f'{verb} reliably instead of best effort')
    parser.add_argument('-n', '--number_of_cycles', type=int, default=20, help='messages before ending')
    options = parser.parse_args(remove_ros_args(arguments)[1:])
    qos = QoSProfile(depth=10) if options.reliable else qos_profile_sensor_data

    def body() -> None:
        node = make_node(f'{node_stem}_qos', qos)
        node.get_logger().info('Reliable ' + node_stem if options.reliable else 'Best effort ' + node_stem)
        while rclpy.ok() and node.count < options.number_of_cycles:
            rclpy.spin_once(node)

    run(body)

"""`ros2 topic echo`: print messages."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from edulaunch.cli.ros2 import cli_node, printing, qos_options
from edulaunch.cli.ros2.output import complain
from edulaunch.cli.ros2.topic_class import topic_class

if TYPE_CHECKING:
    from rclpy.node import Node
    from rclpy.qos import QoSProfile


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 topic echo`."""
    cli_node.add_arguments(parser)
    parser.add_argument('topic_name', help="Name of the ROS topic to listen to (e.g. '/chatter')")
    parser.add_argument('message_type', nargs='?', help="Type of the ROS message (e.g. 'std_msgs/msg/String')")
    printing.add_arguments(parser)
    parser.add_argument('--once', action='store_true', help='Print the first message received and then exit')
    parser.add_argument('--timeout', metavar='N', type=float, help='Set a timeout in seconds for waiting')
    parser.add_argument('--include-hidden-topics', action='store_true', help='Consider hidden topics as well')
    qos_options.add_arguments(parser, 'sensor_data')


def main(arguments: argparse.Namespace) -> str | int | None:
    """Print each message that comes, until interrupted."""
    import rclpy

    with cli_node.cli_node(arguments) as node:
        cls = topic_class(node, arguments.topic_name, arguments.message_type, verb='echo')
        if isinstance(cls, str):
            return cls
        topic = node.resolve_topic_name(arguments.topic_name)
        done = rclpy.task.Future()
        printer = printing.Printer(arguments, done)
        node.create_subscription(cls, topic, printer.on_message, _suitable_profile(node, topic, arguments), raw=arguments.raw)
        rclpy.spin_until_future_complete(node, done, timeout_sec=arguments.timeout)
    return None


def _suitable_profile(node: Node, topic: str, arguments: argparse.Namespace) -> QoSProfile:
    """Sensor data, but as reliable and as durable as all publishers are; what only some offer is said."""
    from rclpy.qos import DurabilityPolicy, ReliabilityPolicy

    profile = qos_options.profile(arguments)
    offered = [endpoint.qos_profile for endpoint in node.get_publishers_info_by_topic(topic)]
    if qos_options.is_chosen(arguments) or not offered:
        return profile
    reliable = sum(each.reliability == ReliabilityPolicy.RELIABLE for each in offered)
    kept = sum(each.durability == DurabilityPolicy.TRANSIENT_LOCAL for each in offered)
    for count, policy, falls_back in (
        (reliable, 'ReliabilityPolicy.RELIABLE', 'ReliabilityPolicy.BEST_EFFORT'),
        (kept, 'DurabilityPolicy.TRANSIENT_LOCAL', 'DurabilityPolicy.VOLATILE'),
    ):
        if 0 < count < len(offered):
            complain(
                f'Some, but not all, publishers are offering {policy}. '
                f'Falling back to {falls_back} as it will connect to all publishers'
            )
    profile.reliability = ReliabilityPolicy.RELIABLE if reliable == len(offered) else ReliabilityPolicy.BEST_EFFORT
    profile.durability = DurabilityPolicy.TRANSIENT_LOCAL if kept == len(offered) else DurabilityPolicy.VOLATILE
    return profile

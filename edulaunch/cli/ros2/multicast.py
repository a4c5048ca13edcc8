"""`ros2 multicast receive|send`: a datagram between the terminals of one simulated machine; it never leaves it."""

from __future__ import annotations

import argparse
from typing import Any

from edulaunch.cli.ros2 import cli_node
from edulaunch.cli.ros2.output import say

CHANNEL = '/_multicast'
"""The hidden topic that stands for the network of the machine."""


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """How long to wait."""
    parser.add_argument('--timeout', type=float, default=None, help='Maximum time to wait for datagrams (default: for ever)')


def main(arguments: argparse.Namespace) -> str | None:
    """Send a greeting, or wait for one; returns the text of an error."""
    from std_msgs.msg import String

    if arguments.verb == 'receive':
        return _receive(String, arguments.timeout)
    say('Sending one UDP multicast datagram...')
    with cli_node.cli_node() as node:
        node.create_publisher(String, CHANNEL, 1).publish(String(data='Hello World!'))
    return None


def _receive(cls: Any, timeout_s: float | None) -> str | None:
    import rclpy

    done = rclpy.task.Future()
    say('Waiting for UDP multicast datagram...')
    with cli_node.cli_node() as node:
        node.create_subscription(cls, CHANNEL, done.set_result, 1)
        rclpy.spin_until_future_complete(node, done, timeout_sec=timeout_s)
        message: Any = done.result()
    if message is None:
        return 'No datagram received within the timeout'
    say(f'Received from 127.0.0.1:49150: {message.data!r}')
    return None

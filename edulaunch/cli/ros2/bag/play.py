"""`ros2 bag play`: publish what a bag holds."""

from __future__ import annotations

import argparse
import os
from importlib.util import find_spec
from typing import TYPE_CHECKING, Any

from edulaunch.cli.ros2 import cli_node
from edulaunch.cli.ros2.interface_class import interface_class
from edulaunch.cli.ros2.output import with_help
from edulaunch.errors import InterfaceError
from edulaunch.processes.current import current_process

if TYPE_CHECKING:
    from rclpy.node import Node


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options of ROS 2 that choose messages and their times."""
    parser.add_argument('bag_path', help='Bag to open')
    parser.add_argument(
        '-r', '--rate', type=_positive, default=1.0, help='rate at which to play back messages. Valid range > 0.0.'
    )
    parser.add_argument('--topics', nargs='+', default=None, metavar='topic', help='Space-delimited list of topics to play.')
    parser.add_argument(
        '--start-offset', type=float, default=0.0, help='Start the playback player this many seconds into the bag file.'
    )
    parser.add_argument('-l', '--loop', action='store_true', help='enables loop playback when playing a bagfile.')
    parser.add_argument('-d', '--delay', type=float, default=0.0, help='Sleep duration before play (each loop), in seconds.')


def _positive(text: str) -> float:
    value = float(text)
    if value <= 0:
        raise argparse.ArgumentTypeError('Value must be positive')
    return value


def main(arguments: argparse.Namespace) -> str | None:
    """Publish each message at its time; ends after the last one unless looping."""
    folder = os.path.join(current_process().spec.cwd or '', arguments.bag_path)
    if not os.path.isfile(os.path.join(folder, 'metadata.yaml')):
        return with_help(
            f"[ERROR] [ros2bag]: bag path '{arguments.bag_path}' does not exist!", 'give the folder that `ros2 bag record` made'
        )
    if find_spec('rosbags') is None:
        return with_help("bags cannot be read, because 'rosbags' is not installed", 'pip install edulaunch[bags]')
    with cli_node.cli_node(name='rosbag2_player') as node:
        log = node.get_logger()
        log.info(f'Set rate to {arguments.rate:g}')
        messages = _load(node, folder, arguments)
        while messages:
            cli_node.pause(node, arguments.delay)
            log.info('Playback until timestamp: -1')
            _play(node, messages, arguments)
            if not arguments.loop or not node.context.ok():
                break
    return None


def _load(node: Node, folder: str, arguments: argparse.Namespace) -> list[tuple[int, Any, Any]]:
    """(nanoseconds after the beginning, publisher, message) of all that is to be played, in order of time."""
    from rosbags.rosbag2 import Reader

    from edulaunch.interfaces.cdr import deserialize

    publishers: dict[int, Any] = {}
    found = []
    with Reader(folder) as reader:
        for connection in reader.connections:
            if arguments.topics is None or connection.topic in arguments.topics:
                publishers[connection.id] = _publisher(node, connection)
        begin = reader.start_time + round(arguments.start_offset * 1e9)
        for connection, time_ns, data in reader.messages():
            publisher = publishers.get(connection.id)
            if publisher is not None and time_ns >= begin:
                found.append((time_ns - begin, publisher, deserialize(bytes(data), publisher.msg_type)))
    return found


def _publisher(node: Node, connection: Any) -> Any:
    try:
        return node.create_publisher(interface_class(connection.msgtype, 'msg'), connection.topic, 10)
    except InterfaceError as error:
        node.get_logger().warning(f"Ignoring a topic '{connection.topic}', reason: {error.message}.")
        return None


def _play(node: Node, messages: list[tuple[int, Any, Any]], arguments: argparse.Namespace) -> None:
    begin_ns = current_process().sim.now_ns
    for offset_ns, publisher, message in messages:
        if not cli_node.pause_until(node, begin_ns + round(offset_ns / arguments.rate)):
            return
        publisher.publish(message)

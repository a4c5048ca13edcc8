"""The program view_frames: listens to tf2 for a while and draws the tree of frames."""

from __future__ import annotations

import argparse
import sys
import time
from datetime import datetime
from typing import Any

import rclpy
import yaml
from rclpy.node import Node
from rclpy.utilities import remove_ros_args
from tf2_msgs.srv import FrameGraph
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener

from ._tree_page import draw_pdf, prepare


def generate_dot(data: dict[Any, dict[str, Any]], recorded_time: float) -> str:
    """The graphviz text of a tree of frames as `all_frames_as_yaml` describes it."""
    if not data:
        return 'digraph G { "No tf data received" }'
    lines = ['digraph G {']
    root = ''
    for child, facts in data.items():
        label = (
            f' Broadcaster: {facts["broadcaster"]}\\nAverage rate: {facts["rate"]}\\n'
            f'Buffer length: {facts["buffer_length"]}\\n'
            f'Most recent transform: {facts["most_recent_transform"]}\\n'
            f'Oldest transform: {facts["oldest_transform"]}\\n'
        )
        lines.append(f'"{facts["parent"]}" -> "{child}"[label="{label}"];')
        if facts['parent'] not in data:
            root = facts['parent']
    lines += [
        'edge [style=invis];',
        ' subgraph cluster_legend { style=bold; color=black; label ="view_frames Result";',
        f'"Recorded at time: {recorded_time}"[ shape=plaintext ] ;',
        f'}}->"{root}";',
        '}',
    ]
    return '\n'.join(lines)


def listen(node: Node, seconds: float) -> None:
    """Let the node receive for that long."""
    start = time.time()
    while time.time() - start < seconds:
        rclpy.spin_once(node, timeout_sec=0.1)


def ask_for_frames(node: Node) -> Any:
    """The answer of the node's own service tf2_frames."""
    client = node.create_client(FrameGraph, 'tf2_frames')
    client.wait_for_service()
    future = client.call_async(FrameGraph.Request())
    rclpy.spin_until_future_complete(node, future)
    return future.result()


def draw(data: dict[Any, dict[str, Any]], name: str) -> None:
    """Write <name>.gv and <name>.pdf."""
    now = time.time()
    with open(f'{name}.gv', 'w', encoding='utf-8') as file:
        file.write(generate_dot(data, now))
    draw_pdf(data, now, f'{name}.pdf')


def main() -> int:
    """Run the program until Ctrl-C or a shutdown."""
    parser = argparse.ArgumentParser(prog='view_frames', description='Draw the tree of tf2 frames.')
    parser.add_argument('-t', '--wait-time', type=float, default=5.0, help='how long to listen, in seconds')
    parser.add_argument('-o', '--output', help='name of the files to write, without ending')
    rclpy.init()
    arguments = parser.parse_args(remove_ros_args(sys.argv)[1:])
    node = rclpy.create_node('view_frames')
    prepare()
    buffer = Buffer(node=node)
    listener = TransformListener(buffer, node)
    node.get_logger().info(f'Listening to tf data for {arguments.wait_time} seconds...')
    listen(node, arguments.wait_time)
    node.get_logger().info('Generating graph...')
    result = ask_for_frames(node)
    node.get_logger().info(f'Result:{result}')
    name = arguments.output or f'frames_{datetime.now().strftime("%Y-%m-%d_%H.%M.%S")}'
    node.get_logger().info(f'Exporting graph in {name}.pdf file...')
    draw(yaml.safe_load(result.frame_yaml) or {}, name)
    listener.unregister()
    node.destroy_node()
    rclpy.shutdown()
    return 0


if __name__ == '__main__':
    sys.exit(main())

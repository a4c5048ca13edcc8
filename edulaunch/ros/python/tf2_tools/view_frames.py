"""The program view_frames, which receives transforms for a while and draws the tree of frames."""

from __future__ import annotations

import argparse
import sys
import time
from datetime import datetime
from io import BytesIO
from typing import Any

import rclpy
import yaml
from rclpy.node import Node
from rclpy.utilities import remove_ros_args
from tf2_msgs.srv import FrameGraph
from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener

COLUMN, ROW = 3.6, 2.2


"""The size of a frame in inches, including the facts on the arrow above it."""


def prepare() -> None:
    """Import the drawing library now, so that later no import delays the drawing."""
    import matplotlib.backends.backend_pdf
    import matplotlib.figure  # noqa: F401


def draw_pdf(data: dict[Any, dict[str, Any]], recorded_time: float, path: str) -> None:
    """Draw the tree of frames into a PDF file, with parents above their children.

    Each arrow shows the broadcaster, the rate, the buffer length and the age of transforms.

    :param data: the transforms by child frame, in the form of `all_frames_as_yaml`.
    """
    from matplotlib.backends.backend_pdf import FigureCanvasPdf
    from matplotlib.figure import Figure

    places, levels = _places(data)
    width = max((x for x, _ in places.values()), default=0.0) + 1.0
    figure = Figure(figsize=(max(4.0, width * COLUMN), 1.2 + levels * ROW))
    FigureCanvasPdf(figure)
    axes = figure.add_axes((0, 0, 1, 1))
    axes.set_axis_off()
    axes.set_xlim(-0.5, width - 0.5)
    axes.set_ylim(-levels - 0.1, 0.8)
    for child, facts in data.items():
        (x, y), (above_x, above_y) = places[child], places[facts['parent']]
        axes.annotate('', (x, y + 0.14), (above_x, above_y - 0.14), arrowprops={'arrowstyle': '-|>', 'color': 'black'})
        axes.text(
            (x + above_x) / 2, (y + above_y) / 2, _facts(facts), ha='center', va='center', fontsize=8, backgroundcolor='white'
        )
    for name, (x, y) in places.items():
        box = {'boxstyle': 'round4,pad=0.5', 'facecolor': 'white', 'edgecolor': 'black'}
        axes.text(x, y, str(name), ha='center', va='center', fontsize=11, bbox=box)
    title = f'view_frames Result\nRecorded at time: {recorded_time}'
    axes.text(width / 2 - 0.5, 0.75, title if data else 'No tf data received', ha='center', va='top', fontsize=10)
    page = BytesIO()  # matplotlib would write its own files into the current folder of the real process
    figure.savefig(page, format='pdf', metadata={'CreationDate': None})
    with open(path, 'wb') as file:
        file.write(page.getvalue())


def _facts(facts: dict[str, Any]) -> str:
    return (
        f'Broadcaster: {facts["broadcaster"]}\nAverage rate: {facts["rate"]}\nBuffer length: {facts["buffer_length"]}\n'
        f'Most recent transform: {facts["most_recent_transform"]}\nOldest transform: {facts["oldest_transform"]}'
    )


def _places(data: dict[Any, dict[str, Any]]) -> tuple[dict[Any, tuple[float, float]], int]:
    """Return the column and the height of each frame, and the number of levels. Leaves are side by side, and a parent is above
    the middle of its children.
    """
    children: dict[Any, list[Any]] = {}
    for child, facts in data.items():
        children.setdefault(facts['parent'], []).append(child)
    places: dict[Any, tuple[float, float]] = {}
    column = 0.0
    waiting = [(root, 0, False) for root in children if root not in data][::-1]
    while waiting:
        frame, level, is_done = waiting.pop()
        below = children.get(frame, ())
        if below and not is_done:
            waiting += [(frame, level, True), *((child, level + 1, False) for child in reversed(below))]
            continue
        places[frame] = (sum(places[child][0] for child in below) / len(below) if below else column, float(-level))
        column += 0.0 if below else 1.0
    return places, 1 + max((int(-height) for _, height in places.values()), default=0)


def generate_dot(data: dict[Any, dict[str, Any]], recorded_time: float) -> str:
    """Return the graphviz source of a tree of frames. `data` has the form of `all_frames_as_yaml`."""
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
    """Spin the node for `seconds` of simulated time."""
    start = time.time()
    while time.time() - start < seconds:
        rclpy.spin_once(node, timeout_sec=0.1)


def ask_for_frames(node: Node) -> Any:
    """Return the response of the node's own service tf2_frames."""
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
    """Run the program until Ctrl-C or a shutdown. Return the exit code."""
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

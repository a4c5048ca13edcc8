"""A value that a parameter file overrides is not said to come from the launch file, and the other way round."""

from __future__ import annotations

from pathlib import Path

import pytest

import edulaunch

FILE = """\
from launch import LaunchDescription
from launch_ros.actions import Node

def generate_launch_description():
    return LaunchDescription([
        Node(package='turtlesim', executable='turtlesim_node', name='sim', {namespace}
             parameters=[{{'background_g': 10}}, {file!r}, {{'background_g': 20}}]),
    ])
"""


@pytest.mark.parametrize(
    ('namespace', 'pattern', 'value', 'origin'),
    [
        ('', '/**', 20, 'order.launch.py line 7'),
        ('', 'sim', 140, 'values.yaml line 3'),  # a block for the node itself comes after the dictionaries, which are for /**
        ("namespace='hall',", '/**', 140, 'values.yaml line 3'),  # a full name: now the dictionaries are for the node itself...
        ("namespace='hall',", '/hall/sim', 20, 'order.launch.py line 7'),
    ],
)
def test_value_and_origin_belong_together(tmp_path: Path, namespace: str, pattern: str, value: int, origin: str) -> None:
    values = tmp_path / 'values.yaml'
    values.write_text(f'{pattern}:\n  ros__parameters:\n    background_g: 140\n')
    file = tmp_path / 'order.launch.py'
    file.write_text(FILE.format(namespace=namespace, file=str(values)))
    recording = edulaunch.run(str(file), duration_s=0.1)
    (node,) = (node.name for node in recording.nodes)
    green = recording.parameters(node)['background_g']
    assert (green.value, green.origin) == (value, origin)

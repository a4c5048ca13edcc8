"""Parameters with declared ranges: what the page is told of them, and sliders of a lesson's own."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import Any

import pytest

pytest.importorskip('ipywidgets')

import edulaunch  # noqa: E402
from edulaunch import UnusableInput  # noqa: E402
from edulaunch.desk.machine.started import Machine  # noqa: E402
from edulaunch.desk.view.replay import RecorderSource, timeline_of  # noqa: E402
from edulaunch.desk.view.timeline import Timeline  # noqa: E402
from edulaunch.engine.recording import Recording  # noqa: E402

NODE = """
import rclpy
from rcl_interfaces.msg import FloatingPointRange, IntegerRange, ParameterDescriptor as D
rclpy.init()
node = rclpy.create_node('arm')
node.declare_parameter('gain', 1.0, D(description='how hard', floating_point_range=[FloatingPointRange(from_value=0.0, to_value=4.0)]))
node.declare_parameter('count', 3, D(integer_range=[IntegerRange(from_value=1, to_value=9, step=2)]))
node.declare_parameter('name', 'left', D(read_only=True))
node.declare_parameter('plain', 7)
node.declare_parameter('on', False)
rclpy.spin(node)
"""
LAUNCH = """
from launch import LaunchDescription
from launch.actions import ExecuteProcess
def generate_launch_description():
    return LaunchDescription([ExecuteProcess(cmd=['python3', {path!r}])])
"""


@pytest.fixture
def machine(tmp_path: Path) -> Iterator[Machine]:
    (tmp_path / 'arm.py').write_text(NODE)
    (tmp_path / 'arm.launch.py').write_text(LAUNCH.format(path=str(tmp_path / 'arm.py')))
    with edulaunch.start(tmp_path / 'arm.launch.py') as machine:
        machine.run(1)
        yield machine


def test_the_film_says_what_parameters_were_declared_to_be(machine: Machine) -> None:
    told = [
        ['/arm', 'gain', 'how hard', False, [0.0, 4.0, 0.0]],
        ['/arm', 'count', '', False, [1, 9, 2]],
        ['/arm', 'name', '', True, None],
    ]
    assert declared(Timeline(RecorderSource(machine.session.recorder)).delta()) == told
    saved = Recording.from_bytes(machine.recording().to_bytes())
    timeline = timeline_of(saved)
    assert declared(timeline) == told
    assert {row[2]: row[5] for row in timeline['parameters'] if row[2] in ('gain', 'count', 'name')} == {
        'gain': True,
        'count': False,
        'name': False,
    }


def declared(timeline: dict[str, Any]) -> list[list[Any]]:
    """What the node itself declares; rclpy adds one that is read-only."""
    rows = [row[1:] for row in timeline['descriptors']]
    assert rows[0][1] == 'start_type_description_service'
    return rows[1:]


@pytest.mark.parametrize(('name', 'to', 'limits'), [('gain', 2.5, (0.0, 4.0)), ('count', 5, (1, 9)), ('on', True, None)])
def test_a_slider_sets_the_parameter(machine: Machine, name: str, to: Any, limits: Any) -> None:
    slider = machine.slider('/arm', name)
    if limits is not None:
        assert (slider.min, slider.max) == limits
    slider.value = to
    machine.run(3)
    assert machine.recording().parameters('/arm')[name].value == to


def test_a_parameter_without_a_range_needs_limits(machine: Machine) -> None:
    with pytest.raises(UnusableInput, match=r'plain declares no range'):
        machine.slider('/arm', 'plain')
    assert machine.slider('/arm', 'plain', (0, 10)).max == 10


def test_a_read_only_parameter_cannot_be_moved(machine: Machine) -> None:
    with pytest.raises(UnusableInput, match='is not a number'):
        machine.slider('/arm', 'name')


@pytest.mark.parametrize(('node', 'name', 'near'), [('/arn', 'gain', "'/arm'"), ('/arm', 'gian', "'gain'"), ('/x', 'y', '/arm')])
def test_what_is_not_there_is_named_with_the_nearest(machine: Machine, node: str, name: str, near: str) -> None:
    with pytest.raises(UnusableInput) as caught:
        machine.slider(node, name)
    assert near in str(caught.value.help)

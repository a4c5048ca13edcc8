"""`ros2 lifecycle ...` in the simulation."""

from __future__ import annotations

from typing import Any

import pytest

NODE = """
import rclpy
from rclpy.lifecycle import LifecycleNode, TransitionCallbackReturn


class Lidar(LifecycleNode):
    def on_activate(self, state):
        return TransitionCallbackReturn.FAILURE


rclpy.init()
rclpy.spin(Lidar('lidar', namespace='front'))
"""


@pytest.fixture
def lidar(machine: Any) -> Any:
    """The machine, on which a lifecycle node runs beside turtlesim."""
    (machine.folder / 'lidar.py').write_text(NODE)
    machine.run('python3 lidar.py')
    return machine


def test_nodes_are_those_with_a_lifecycle(lidar: Any) -> None:
    assert lidar.read('ros2 lifecycle nodes') == '/front/lidar\n'
    assert lidar.read('ros2 lifecycle nodes -c') == '1\n'


def test_get_tells_the_state_of_one_node_or_of_all(lidar: Any) -> None:
    assert lidar.read('ros2 lifecycle get front/lidar') == 'unconfigured [1]\n'
    assert lidar.read('ros2 lifecycle get') == '/front/lidar: unconfigured [1]\n'


def test_list_tells_what_the_node_can_do_now(lidar: Any) -> None:
    assert lidar.read('ros2 lifecycle list /front/lidar') == (
        '- configure [1]\n\tStart: unconfigured\n\tGoal: configuring\n- shutdown [5]\n\tStart: unconfigured\n\tGoal: shuttingdown\n'
    )
    assert lidar.read('ros2 lifecycle list /front/lidar -a').count('\tGoal: ') > 20


@pytest.mark.parametrize('transition', ['configure', '1'])
def test_set_makes_a_transition_by_label_or_number(lidar: Any, transition: str) -> None:
    assert lidar.read(f'ros2 lifecycle set /front/lidar {transition}') == 'Transitioning successful\n'
    assert lidar.read('ros2 lifecycle get /front/lidar') == 'inactive [2]\n'


def test_a_transition_that_fails_is_said_and_the_status_is_0_as_in_ros(lidar: Any) -> None:
    lidar.read('ros2 lifecycle set /front/lidar configure')
    typed = lidar.run('ros2 lifecycle set /front/lidar activate')
    assert (typed.code, typed.out, typed.err) == (0, '', 'Transitioning failed\n')


def test_a_transition_that_cannot_be_made_now_is_an_error(lidar: Any) -> None:
    assert lidar.fails('ros2 lifecycle set /front/lidar activate') == (
        'Unknown transition requested, available ones are:\n- configure [1]\n- shutdown [5]\n'
    )


def test_a_node_without_a_lifecycle_is_not_found(lidar: Any) -> None:
    assert lidar.fails('ros2 lifecycle get /sim') == 'Node not found\n  help: see `ros2 lifecycle nodes`\n'
    assert lidar.fails('ros2 lifecycle get lidar') == "Node not found\n  help: did you mean '/front/lidar'?\n"

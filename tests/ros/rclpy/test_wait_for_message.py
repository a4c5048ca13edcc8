"""rclpy.wait_for_message."""

from __future__ import annotations

import pytest
import rclpy
from rclpy import wait_for_message as waiting
from rclpy._rclpy_pybind11 import RCLError
from rclpy.node import Node
from std_msgs.msg import String

from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World


def test_one_message_can_be_waited_for_without_spinning(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        world.say(waiting.wait_for_message(String, node, 'c', time_to_wait=0.1))
        found, message = waiting.wait_for_message(String, node, 'c')
        world.say((found, message.data))

    def speaking() -> None:
        rclpy.init()
        publisher = Node('talker').create_publisher(String, 'c', 10)
        sleep(1.3)
        publisher.publish(String(data='x'))

    world.start(program)
    world.start(speaking, name='talker')
    assert world.run(2) == [(100.0, 'main', (False, None)), (1300.0, 'main', (True, 'x'))]


def test_waiting_for_a_message_of_a_context_that_is_down_is_an_error(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        with pytest.raises(AttributeError, match="^type object 'int' has no attribute '_TYPE_SUPPORT'"):
            waiting.wait_for_message(3, node, 'c')
        rclpy.shutdown()
        with pytest.raises(RCLError, match='^failed to initialize wait set: the given context is not valid'):
            waiting.wait_for_message(String, node, 'c', time_to_wait=0.1)
        world.say('refused')

    assert ros(body) == ['refused']

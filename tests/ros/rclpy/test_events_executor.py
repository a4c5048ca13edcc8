"""rclpy.experimental.EventsExecutor."""

from __future__ import annotations

import rclpy
from rclpy.experimental import EventsExecutor
from rclpy.node import Node

from .conftest import Ros, World, everything_ready


def test_an_events_executor_goes_by_the_order_of_arrival(ros: Ros, world: World) -> None:
    def body() -> None:
        with EventsExecutor() as executor:
            executor.add_node(everything_ready(world, 'n', 't'))
            for number in (1, 2):
                executor.create_task(world.say, ('n', f'task {number}'))
            for _ in range(6):
                executor.spin_once()

    assert ros(body) == [('n', what) for what in ('task 1', 'task 2', 'service', 'guard', 'subscription', 'timer')]


def test_an_events_executor_spins_until_ros_is_shut_down(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.create_timer(0.5, lambda: world.say('tick') or rclpy.shutdown())
        rclpy.spin(node, EventsExecutor())
        world.say('over')

    assert ros(body) == ['tick', 'over']

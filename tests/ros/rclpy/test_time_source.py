"""rclpy.time_source: what rules the clocks of nodes."""

from __future__ import annotations

import pytest
import rclpy
from rclpy.clock import Clock, ClockType, ROSClock
from rclpy.node import Node
from rclpy.parameter import Parameter
from rclpy.time_source import TimeSource
from rosgraph_msgs.msg import Clock as ClockMessage

from .conftest import Ros, World


def listens(*nodes: Node) -> list[list[str]]:
    return [[subscription.topic_name for subscription in node.subscriptions] for node in nodes]


def test_it_can_be_made_alone_and_be_given_a_node_later(ros: Ros, world: World) -> None:
    def body() -> None:
        source, clock = TimeSource(), ROSClock()
        source.attach_clock(clock)
        plain, ruled = Node('a'), Node('b')
        source.attach_node(plain)
        source.ros_time_is_active = True
        world.say((clock.ros_time_is_active, listens(plain, ruled)))
        source.attach_node(ruled)  # its use_sim_time is false
        world.say((clock.ros_time_is_active, listens(plain, ruled)))
        ruled.set_parameters([Parameter('use_sim_time', value=True)])
        source.detach_node()
        world.say((clock.ros_time_is_active, source.ros_time_is_active))
        with pytest.raises(TypeError, match='Node must be of type rclpy.node.Node'):
            source.attach_node(1)  # type: ignore[arg-type]
        with pytest.raises(ValueError, match='Only clocks with type ROS_TIME can be attached.'):
            source.attach_clock(Clock(clock_type=ClockType.SYSTEM_TIME))

    assert ros(body) == [(True, [['/clock'], []]), (False, [[], []]), (True, True)]


def test_a_late_clock_gets_the_last_time(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', parameter_overrides=[Parameter('use_sim_time', value=True)])
        source, late = TimeSource(node=node), ROSClock()
        message = ClockMessage()
        message.clock.sec = 9
        node.create_publisher(ClockMessage, '/clock', 1).publish(message)
        for _ in range(2):
            rclpy.spin_once(node, timeout_sec=0)
        source.attach_clock(late)
        world.say((late.now().nanoseconds, node.get_clock().now().nanoseconds))

    assert ros(body) == [(9_000_000_000, 9_000_000_000)]

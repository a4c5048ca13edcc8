"""A program's own subclasses of rclpy's classes may have any public attributes that those of ROS 2 do not have."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from rclpy.action import ActionClient, ActionServer
from rclpy.client import Client
from rclpy.clock import Clock, JumpThreshold
from rclpy.context import Context
from rclpy.executors import SingleThreadedExecutor
from rclpy.publisher import Publisher
from rclpy.subscription import Subscription
from rclpy.task import Future, Task
from rclpy.waitable import Waitable
from std_msgs.msg import String

from .conftest import Ros

OURS = {
    Clock: ['now_ns'],
    JumpThreshold: ['reached'],
    Client: ['asked', 'awaited', 'await_server', 'node_name', 'note_deadlock'],
    ActionClient: ['asked', 'awaited', 'await_server', 'node_name', 'note_deadlock'],
    ActionServer: ['goal_changed', 'now_ns', 'send_feedback'],
    Context: ['end_by_signal', 'park', 'track_node', 'untrack_node'],
    SingleThreadedExecutor: ['cannot_serve', 'forget_work', 'note_nested_spin', 'running_entity', 'spin_ready'],
    Future: ['ended', 'wake_when_done', 'source'],
    Task: ['raise_if_failed'],
    Waitable: ['ask', 'category', 'is_async', 'run_callback', 'signal'],
    Publisher: ['connect'],
    Subscription: ['category', 'connect', 'is_async', 'run_callback', 'signal', 'take_wires'],
}


def never(*_: Any) -> None:
    raise AssertionError('rclpy called a method of the program')


@pytest.mark.parametrize('kind', OURS, ids=lambda kind: kind.__name__)
def test_the_classes_have_no_such_names(kind: type) -> None:
    assert [name for name in OURS[kind] if hasattr(kind, name)] == []


def test_such_methods_of_a_program_are_never_called(ros: Ros) -> None:
    own = {kind: type(f'Own{kind.__name__}', (kind,), dict.fromkeys(names, never)) for kind, names in OURS.items()}

    def body() -> None:
        context = own[Context]()
        context.init()
        node = rclpy.create_node('robot', context=context)
        executor, heard, future = own[SingleThreadedExecutor](context=context), [], own[Future]()
        executor.add_node(node)
        publisher = node.create_publisher(String, 'x', 1, publisher_class=own[Publisher])

        def on_message(message: Any) -> None:
            heard.append(message.data)
            future.set_result(1)

        node.create_subscription(String, 'x', on_message, 1)
        node.create_timer(0.1, lambda: publisher.publish(String(data='hello')))
        executor.spin_until_future_complete(future, 5.0)
        executor.shutdown()
        node.destroy_node()
        context.shutdown()
        assert heard == ['hello']

    ros(body)

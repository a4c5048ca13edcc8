"""tf2_ros.TransformListener."""

from __future__ import annotations

from typing import Any

import rclpy
import tf2_ros
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_msgs.msg import TFMessage

from edulaunch.engine.graph.qos import TRANSIENT_LOCAL, QoS

from .listening import listening, stamped


def test_a_dropped_listener_hears_nothing(stage, program):
    names: list[str] = []

    def body() -> None:
        rclpy.init()
        node, buffer = Node('forgetful'), tf2_ros.Buffer()
        tf2_ros.TransformListener(buffer, node)
        node.create_timer(0.5, lambda: names.append(buffer.all_frames_as_yaml()))
        rclpy.spin(node)

    program(body)
    stage.until(100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'turtle1', 1.0, 1.0)]))
    stage.until(600)
    assert names == ['[]']


def test_a_listener_may_have_callbacks_of_its_own(stage, program):
    heard: list[str] = []

    class Curious(tf2_ros.TransformListener):
        def callback(self, data: TFMessage) -> None:
            heard.append('moving')
            super().callback(data)

        def static_callback(self, data: TFMessage) -> None:
            heard.append('static')
            super().static_callback(data)

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        node.keep = Curious(buffer, node)
        node.create_timer(0.15, lambda: heard.append(buffer.all_frames_as_string()))

    listening(stage, program, use)
    hand = stage.graph.add_node(None, 'early', '/')
    latched = stage.graph.create_publisher(hand, '/tf_static', TFMessage, QoS(durability=TRANSIENT_LOCAL))
    stage.until(100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'a', 1.0, 1.0)]))
    latched.publish(TFMessage.to_wire(TFMessage(transforms=[stamped('world', 'b', 0.0, 1.0)])))
    stage.until(200)
    assert heard == ['moving', 'static', 'Frame a exists with parent world.\nFrame b exists with parent world.\n']


def test_with_a_thread_of_its_own_the_wait_ends_when_the_data_comes(stage, program):
    log: list[tuple[float, float]] = []

    def body() -> None:
        rclpy.init()
        node, buffer = Node('threaded'), tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(buffer, node, spin_thread=True)
        found = buffer.lookup_transform('world', 'late', Time(), timeout=Duration(seconds=1.0))
        log.append((stage.tape.now_ms(), found.transform.translation.x))
        listener.unregister()

    program(body)
    stage.until(101)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', 1.0, 7.0)]))
    stage.until(2000)
    assert log == [(120.0, 7.0)]


def test_another_callback_takes_the_place_of_the_listeners(stage, program):
    heard: list[str] = []
    frames: list[str] = []

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        node.keep.tf_sub.callback = lambda message: heard.append(message.transforms[0].child_frame_id)
        node.create_timer(0.15, lambda: frames.append(buffer.all_frames_as_yaml()))

    listening(stage, program, use)
    stage.until(100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'a', 1.0, 1.0)]))
    stage.until(200)
    assert (heard, frames) == (['a'], ['[]'])


def test_a_listener_feeds_the_buffer_that_it_has_now(stage: Any, program: Any) -> None:
    seen = []

    def body() -> None:
        rclpy.init()
        node = Node('n')
        first, second = tf2_ros.Buffer(), tf2_ros.Buffer()
        listener = tf2_ros.TransformListener(first, node)
        publisher = node.create_publisher(TFMessage, '/tf', 10)
        for child in 'abc':
            publisher.publish(TFMessage(transforms=[stamped('world', child, 1.0, 0.0)]))
            rclpy.spin_once(node, timeout_sec=0.1)
            listener.buffer = second
        seen.extend(buffer.all_frames_as_yaml().count('parent') for buffer in (first, second))

    program(body)
    stage.until(1000)
    assert seen == [1, 2]

"""tf2_ros.TransformBroadcaster and StaticTransformBroadcaster."""

from __future__ import annotations

import rclpy
import tf2_ros
from rclpy.node import Node
from rclpy.time import Time
from tf2_msgs.msg import TFMessage

from edulaunch.engine.graph.qos import TRANSIENT_LOCAL, QoS

from .listening import listening, stamped


def test_what_one_program_broadcasts_another_one_looks_up(stage, program):
    seen: list[tuple[float, float]] = []

    def broadcaster() -> None:
        rclpy.init()
        node = Node('broadcaster')
        sender = tf2_ros.TransformBroadcaster(node)

        def send() -> None:
            now = node.get_clock().now().nanoseconds * 1e-9
            sender.sendTransform(stamped('world', 'turtle1', now, stage.tape.now_ms()))

        node.create_timer(0.1, send)
        rclpy.spin(node)

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        def look() -> None:
            found = buffer.lookup_transform('world', 'turtle1', Time())
            seen.append((stage.tape.now_ms(), found.transform.translation.x))

        node.create_timer(0.27, look)

    program(broadcaster)
    listening(stage, program, use)
    stage.until(800)
    assert seen == [(270.0, 200.0), (540.0, 500.0)]


def test_a_static_broadcaster_repeats_all_frames_but_never_changes_one(stage, program):
    def body() -> None:
        rclpy.init()
        sender = tf2_ros.StaticTransformBroadcaster(Node('static'))
        sender.sendTransform(stamped('world', 'a', 1.0, 1.0))
        sender.sendTransform([stamped('world', 'a', 1.0, 9.0), stamped('world', 'b', 1.0, 2.0)])

    program(body)
    stage.until(10)
    sent = [
        [(one.child_frame_id, one.transform.translation.x) for one in message.transforms]
        for message in stage.messages('/tf_static')
    ]
    assert sent == [[('a', 1.0)], [('a', 1.0), ('b', 2.0)]]


def test_a_late_listener_gets_static_frames(stage, program):
    found: list[float] = []
    hand = stage.graph.add_node(None, 'early', '/')
    publisher = stage.graph.create_publisher(hand, '/tf_static', TFMessage, QoS(depth=1, durability=TRANSIENT_LOCAL))
    publisher.publish(TFMessage.to_wire(TFMessage(transforms=[stamped('world', 'lamp', 0.0, 3.0)])))
    stage.until(1000)
    listening(
        stage,
        program,
        lambda node, buffer: node.create_timer(
            0.1, lambda: found.append(buffer.lookup_transform('world', 'lamp', Time(seconds=5)).transform.translation.x)
        ),
    )
    stage.until(1150)
    assert found == [3.0]

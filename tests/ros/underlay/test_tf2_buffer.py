"""tf2_ros.Buffer: lookups that wait, frames on request, subclasses."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.node import Node
from rclpy.time import Time
from tf2_msgs.msg import TFMessage
from tf2_msgs.srv import FrameGraph

from edulaunch.engine.facts import facts_of

from .listening import listening, stamped


def test_a_lookup_with_a_timeout_blocks_its_executor_to_the_end(stage, program):
    log: list[tuple[float, str]] = []

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        def look() -> None:
            try:
                buffer.lookup_transform('world', 'late', Time(), timeout=Duration(seconds=1.0))
            except tf2_ros.TransformException as error:
                log.append((stage.tape.now_ms(), f'{type(error).__name__}: {error}'))

        node.create_timer(2.0, look)

    listening(stage, program, use)
    stage.until(2100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', 1.0, 1.0)]))
    stage.until(3500)
    assert log == [(3000.0, 'LookupException: "world" passed to lookupTransform argument target_frame does not exist. ')]


@pytest.mark.parametrize('timeout', [1.0, 1, Duration(seconds=1.0).to_msg()])
def test_a_timeout_is_an_rclpy_duration(timeout):
    with pytest.raises(TypeError, match=r"unsupported operand type\(s\) for \+: 'Time' and '(float|int|Duration)'") as caught:
        tf2_ros.Buffer().lookup_transform('world', 'a', Time(), timeout=timeout)
    assert facts_of(caught.value)['about'] == 'programs.timeout-no-duration'


def test_with_threads_to_spare_a_lookup_in_a_callback_gets_its_data(stage, program):
    log: list[tuple[float, float]] = []

    def body() -> None:
        rclpy.init()
        node, buffer = Node('patient'), tf2_ros.Buffer()
        node.keep = tf2_ros.TransformListener(buffer, node)

        def look() -> None:
            timer.cancel()
            found = buffer.lookup_transform('world', 'late', Time(), timeout=Duration(seconds=1.0))
            log.append((stage.tape.now_ms(), found.transform.translation.x))

        timer = node.create_timer(0.1, look)
        executor = rclpy.executors.MultiThreadedExecutor(num_threads=2)
        executor.add_node(node)
        executor.spin()

    program(body)
    stage.until(301)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', 1.0, 7.0)]))
    stage.until(2000)
    assert log == [(320.0, 7.0)]


def test_a_future_is_done_when_the_transform_arrives(stage, program):
    log: list[tuple[float, float]] = []

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        future = buffer.wait_for_transform_async('world', 'late', Time())
        future.add_done_callback(lambda done: log.append((stage.tape.now_ms(), done.result().transform.translation.x)))

    listening(stage, program, use)
    stage.until(300)
    for x in (4.0, 5.0):
        stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', x, x)]))
    stage.until(400)
    assert log == [(300.0, 4.0)]


def test_a_coroutine_callback_can_await_a_transform(stage, program):
    log: list[tuple[float, float]] = []

    def use(node: Node, buffer: tf2_ros.Buffer) -> None:
        async def look() -> None:
            timer.cancel()
            found = await buffer.lookup_transform_async('world', 'late', Time())
            log.append((stage.tape.now_ms(), found.transform.translation.x))

        timer = node.create_timer(0.1, look)

    listening(stage, program, use)
    stage.until(350)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'late', 1.0, 6.0)]))
    stage.until(1000)
    assert log == [(350.0, 6.0)]


def test_a_buffer_with_a_node_offers_its_frames(stage, program):
    def body() -> None:
        rclpy.init()
        node = Node('owner', namespace='robot')
        buffer = tf2_ros.Buffer(node=node)
        buffer.set_transform(stamped('world', 'a', 1.0, 1.0), 'me')
        rclpy.spin(node)

    program(body)
    stage.until(10)
    replies = stage.ask('/robot/tf2_frames', FrameGraph)
    stage.until(20)
    assert replies[0].frame_yaml.startswith("a: \n  parent: 'world'\n  broadcaster: 'me'\n")


def test_a_refused_transform_is_logged_by_the_unnamed_logger(stage, program):
    listening(stage, program, lambda node, buffer: None)
    stage.until(10)
    stage.publish('/tf', TFMessage(transforms=[stamped('a', 'a', 1.0, 1.0)]))
    stage.until(20)
    text = (
        'TF_SELF_TRANSFORM: Ignoring transform from authority "default_authority" with frame_id and  '
        'child_frame_id "a" because they are the same'
    )
    assert stage.tape.logs == [(10.0, text)]
    assert stage.tape.outputs == [(10.0, f'[ERROR] [1700000000.010000000] []: {text}\n')]


class CountingBuffer(tf2_ros.Buffer):
    """A student's buffer that looks at every transform."""

    def __init__(self, seen: list[Any]) -> None:
        super().__init__()
        self._seen = seen

    def set_transform(self, transform: TransformStamped, authority: str) -> None:
        """See Buffer.set_transform."""
        self._seen.append((type(transform), transform.child_frame_id, authority))
        super().set_transform(transform, authority)


def test_a_buffer_with_a_set_transform_of_its_own_gets_messages(stage, program):
    seen: list[Any] = []

    def body() -> None:
        rclpy.init()
        node = Node('listener')
        node.keep = tf2_ros.TransformListener(CountingBuffer(seen), node)
        rclpy.spin(node)

    program(body)
    stage.until(100)
    stage.publish('/tf', TFMessage(transforms=[stamped('world', 'a', 1.0, 1.0), stamped('world', 'b', 1.0, 1.0)]))
    stage.until(200)
    assert seen == [(TransformStamped, 'a', 'default_authority'), (TransformStamped, 'b', 'default_authority')]

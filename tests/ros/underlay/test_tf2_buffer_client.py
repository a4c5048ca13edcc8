"""Lookups over the action of a buffer server."""

from __future__ import annotations

from contextlib import suppress
from typing import Any

import pytest
import rclpy
import tf2_ros
from geometry_msgs.msg import TransformStamped
from rclpy.duration import Duration
from rclpy.executors import ExternalShutdownException
from rclpy.node import Node
from rclpy.time import Time
from tf2_msgs.msg import TFMessage

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec


def ask(stage: Any, use: Any) -> list[Any]:
    """What `use(client)` answers, or raises, in a program whose node another thread spins."""
    answers: list[Any] = []

    def body(_: Process) -> None:
        rclpy.init()
        node = Node('asker')
        client = tf2_ros.BufferClient(node, 'tf2_buffer_server')

        def spin() -> None:
            with suppress(ExternalShutdownException):
                rclpy.spin(node)

        thread = current_process().loader.import_('threading').Thread(target=spin)
        thread.start()
        try:
            answer = use(client)
        except Exception as error:
            answer = f'{type(error).__name__}: {error}'
        answers.append((stage.tape.now_ms(), answer))
        rclpy.shutdown()

    Process(stage.host, ProcessSpec(argv=('asker',), name='asker'), 4243, ['asker'], body).lifecycle.task.start()
    return answers


@pytest.fixture
def served(stage: Any) -> Any:
    """A buffer server that knows world -> a at x = 5."""
    stage.start('tf2_ros', 'buffer_server')
    stage.until(100)
    publish(stage, 'a', 5.0)
    stage.until(200)
    return stage


def publish(stage: Any, child: str, x: float) -> None:
    wire = (*divmod(stage.sim.now_ns, 10**9), 'world', child, x, 0.0, 0.0, 0.0, 0.0, 0.0, 1.0)
    stage.publish('/tf', TFMessage(transforms=[TransformStamped.from_wire(wire)]))


def test_a_known_transform_comes_back(served):
    answers = ask(served, lambda client: client.lookup_transform('world', 'a', Time()).transform.translation.x)
    served.until(1000)
    assert [answer for _, answer in answers] == [5.0]


def test_errors_of_the_server_become_the_same_exceptions(served):
    answers = ask(served, lambda client: client.lookup_transform('world', 'b', Time()))
    served.until(1000)
    assert [answer for _, answer in answers] == [
        'LookupException: "b" passed to lookupTransform argument source_frame does not exist. '
    ]


def test_the_server_waits_for_what_comes_within_the_timeout(served):
    answers = ask(
        served, lambda client: client.lookup_transform('world', 'late', Time(), Duration(seconds=1.0)).transform.translation.x
    )
    served.until(705)
    publish(served, 'late', 8.0)
    served.until(3000)
    assert answers == [(800.0, 8.0)]


def test_after_the_timeout_the_reason_is_raised(served):
    answers = ask(served, lambda client: client.can_transform('world', 'z', Time(), Duration(seconds=1.0)))
    served.until(4000)
    assert answers == [(1300.0, False)]


def test_without_a_server_the_lookup_fails_at_once(stage):
    answers = ask(stage, lambda client: client.lookup_transform('world', 'a', Time()))
    stage.until(1000)
    assert answers == [(0.0, 'TimeoutException: The BufferServer is not ready.')]


def test_only_rclpy_times_are_taken(served):
    answers = ask(served, lambda client: client.lookup_transform('world', 'a', 5.0))
    served.until(1000)
    assert answers == [(200.0, 'TypeError: Must pass a rclpy.time.Time object')]


def test_a_client_that_was_destroyed_has_left_the_action(served):
    """What is asked afterwards finds no server, as the action client's own error says."""

    def ask_late(client: Any) -> None:
        client.destroy()
        client.lookup_transform('world', 'a', Time())

    answers = ask(served, ask_late)
    served.until(1000)
    assert [answer.partition(':')[0] for _, answer in answers] == ['InvalidHandle']

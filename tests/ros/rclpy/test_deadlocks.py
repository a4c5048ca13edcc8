"""Waiting inside a callback for what only a later callback brings: it hangs, as in ROS 2, and the recording has the facts."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from std_srvs.srv import Empty

from edulaunch.engine.sim.sync import sleep

from .conftest import World


def asking(wait: Callable[[Node, Any], Any], executor: Any = SingleThreadedExecutor, group: Any = None) -> Callable[[], None]:
    """A node that offers a service to itself, asks it in a timer, and waits for the answer there."""

    def program() -> None:
        rclpy.init()
        node = Node('node')
        node.create_service(Empty, 'nothing', lambda request, response: response, callback_group=ReentrantCallbackGroup())
        client = node.create_client(Empty, 'nothing', callback_group=group and group())

        def on_timer() -> Any:
            return wait(node, client.call_async(Empty.Request()))

        node.create_timer(0.5, on_timer)
        spinner = executor()
        rclpy.spin(node, spinner)

    return program


def look(node: Node, future: Any) -> None:
    while not future.done():
        sleep(0.1)


def spin(node: Node, future: Any) -> None:
    rclpy.spin_until_future_complete(node, future, node.executor)


@pytest.mark.parametrize(
    ('wait', 'executor', 'waiting'),
    [
        (look, SingleThreadedExecutor, 'look'),
        (look, MultiThreadedExecutor, 'look'),
        (spin, SingleThreadedExecutor, 'spin_until_future_complete'),
    ],
)
def test_a_wait_for_a_client_of_the_same_group_is_explained(world: World, wait: Any, executor: Any, waiting: str) -> None:
    world.start(asking(wait, executor))
    world.run(5)
    ((kind, data),) = world.tracer.waits()
    assert (kind, data['waiting'], data['callback'], data['node'], data['name']) == (
        'callback waits',
        waiting,
        'on_timer',
        '/node',
        '/nothing',
    )
    assert data['file'] == __file__ and data['line'] > 40


@pytest.mark.parametrize('group', [ReentrantCallbackGroup, MutuallyExclusiveCallbackGroup])
def test_a_wait_with_threads_and_another_group_is_none(world: World, group: Any) -> None:
    world.start(asking(look, MultiThreadedExecutor, group))
    world.run(5)
    assert world.tracer.waits() == []


def awaiting(world: World, group: Any) -> Callable[[], None]:
    def program() -> None:
        rclpy.init()
        node = Node('node')
        node.create_service(Empty, 'nothing', lambda request, response: response, callback_group=ReentrantCallbackGroup())
        client = node.create_client(Empty, 'nothing', callback_group=group and group())

        async def on_timer(word: str) -> None:
            await client.call_async(Empty.Request())
            world.say(word)

        node.create_timer(0.5, partial(on_timer, 'answered'))
        rclpy.spin(node)

    return program


def test_awaiting_a_client_of_the_same_group_is_explained(world: World) -> None:
    world.start(awaiting(world, None))
    assert world.run(1.2) == []
    ((_, data),) = world.tracer.facts
    assert (data['waiting'], data['function'], data['file']) == ('await', 'on_timer', __file__)


def test_awaiting_a_client_of_another_group_is_no_deadlock(world: World) -> None:
    world.start(awaiting(world, ReentrantCallbackGroup))
    assert world.run(1.2) == [(500.0, 'main', 'answered'), (1000.0, 'main', 'answered')]
    assert world.tracer.waits() == []


def test_looking_once_in_each_callback_is_no_deadlock(world: World) -> None:
    """The answer never comes because there is no server, but every callback ends."""

    def program() -> None:
        rclpy.init()
        node = Node('node')
        future = node.create_client(Empty, 'nobody').call_async(Empty.Request())
        node.create_timer(0.1, lambda: world.say(future.done()))
        rclpy.spin(node)

    world.start(program)
    assert world.run(1)[-1] == (1000.0, 'main', False)
    assert [kind for kind, _ in world.tracer.facts] == ['request lost']


def test_a_loop_that_only_looks_lets_the_world_go_on(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('node')
        future = node.create_client(Empty, 'nobody').call_async(Empty.Request())
        while not future.done():
            pass

    world.start(program)
    world.start(lambda: (sleep(1.0), world.say('alive')), name='other')
    assert world.run(2) == [(1000.0, 'other', 'alive')]


def test_waiting_for_the_client_of_a_node_that_nobody_spins_is_explained(world: World) -> None:
    def program() -> None:
        rclpy.init()
        spun, other = Node('spun'), Node('other')
        spun.create_service(Empty, 'nothing', lambda request, response: response)
        rclpy.spin_until_future_complete(spun, other.create_client(Empty, 'nothing').call_async(Empty.Request()))

    world.start(program)
    world.run(1)
    ((kind, data),) = world.tracer.facts
    assert (kind, data['node'], data['name'], data['kind']) == ('other node spun', '/spun', '/nothing', 'service')

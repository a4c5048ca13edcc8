"""rclpy.callback_groups: which callbacks may run beside each other."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from rclpy.callback_groups import CallbackGroup, MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future

from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World


def test_callbacks_of_the_default_group_do_not_run_in_a_nested_spin(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_timer(0.2, lambda: world.say('same group'))
        node.create_timer(0.3, lambda: world.say('other group'), ReentrantCallbackGroup())

        def nested() -> None:
            rclpy.spin_until_future_complete(node, Future(), timeout_sec=0.35)

        node.create_timer(0.1, nested).timer_period_ns = 10**10
        rclpy.spin(node)

    world.start(program)
    assert world.run(0.44) == [(300.0, 'main', 'other group')]


def test_a_waiting_async_callback_holds_its_group(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        future = Future()

        async def wait() -> None:
            await future
            world.say('went on')

        node.create_timer(0.1, wait).timer_period_ns = 10**10
        node.create_timer(0.2, lambda: world.say('same group'))
        node.create_timer(0.5, lambda: future.set_result(None), ReentrantCallbackGroup())
        rclpy.spin(node)

    world.start(program)
    assert world.run(0.7) == [(500.0, 'main', 'went on'), (500.0, 'main', 'same group'), (600.0, 'main', 'same group')]


@pytest.mark.parametrize(
    ('group', 'times'),
    [(ReentrantCallbackGroup, [100.0, 100.0, 200.0, 200.0]), (MutuallyExclusiveCallbackGroup, [100.0, 1100.0, 2100.0, 3100.0])],
)
def test_threads_respect_callback_groups(world: World, group: Any, times: list[float]) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        shared = group()

        def work() -> None:
            world.say('begin')
            sleep(1.0)

        for _ in range(2):
            node.create_timer(0.1, work, shared)
        executor = MultiThreadedExecutor()
        executor.add_node(node)
        executor.spin()

    world.start(program)
    assert [at for at, _, _ in world.run(4)][:4] == times


def test_an_executor_tells_by_the_group_whether_a_callback_could_begin(ros: Ros, world: World) -> None:
    def body() -> None:
        node, executor = Node('n'), SingleThreadedExecutor()
        timers: list[Any] = [
            node.create_timer(1.0, lambda: world.say([executor.can_execute(timer) for timer in timers])),
            node.create_timer(9.0, print),
            node.create_timer(9.0, print, callback_group=ReentrantCallbackGroup()),
        ]
        executor.add_node(node)
        executor.spin_once()
        world.say([executor.can_execute(timer) for timer in timers])

    assert ros(body) == [[False, False, True], [True, True, True]]


def test_a_group_asserts_that_an_entity_is_its_own(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node, group = Node('n'), MutuallyExclusiveCallbackGroup()
        own, other = node.create_timer(1, print, group), node.create_timer(1, print)
        for call in (group.can_execute, group.beginning_execution):
            with pytest.raises(AssertionError):
                call(other)
        world.say(str([group.beginning_execution(own), group.beginning_execution(own)]))
        for entity in (other, own, own):
            try:
                group.ending_execution(entity)
                world.say('ended')
            except AssertionError:
                world.say('not running')

    world.start(program)
    assert [text for _, _, text in world.run(0.1)] == ['[True, False]', 'not running', 'ended', 'not running']


def test_a_group_does_not_keep_its_entities(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node, group = Node('n'), ReentrantCallbackGroup()
        timer = node.create_timer(1, print, group)
        world.say(f'{group.has_entity(timer)} {len(group.entities)}')
        node.destroy_timer(timer)
        del timer
        world.say(str(len(group.entities)))
        for call in (CallbackGroup().can_execute, CallbackGroup().ending_execution):
            with pytest.raises(NotImplementedError):
                call(node)
        with pytest.raises(TypeError, match="cannot create weak reference to 'int' object"):
            group.add_entity(3)

    world.start(program)
    assert [text for _, _, text in world.run(0.1)] == ['True 1', '0']

"""rclpy.waitable: waitables of a program's own."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from rclpy.node import Node
from rclpy.task import Future
from rclpy.waitable import NumberOfEntities, Waitable

from edulaunch.engine.facts import facts_of

from .conftest import Ros, World


class Own(Waitable):
    """Writes down what it is asked."""

    def __init__(self, node: Node) -> None:
        super().__init__(node.default_callback_group)
        self.log: list[Any] = []
        self.something = False

    def get_num_entities(self) -> NumberOfEntities:
        self.log.append('number')
        return NumberOfEntities(num_gcs=1)

    def add_to_wait_set(self, wait_set: Any) -> None:
        self.log.append('add')

    def is_ready(self, wait_set: Any) -> bool:
        self.log.append('ready?')
        return self.something

    def take_data(self) -> Any:
        self.something = False
        return 7

    async def execute(self, taken_data: Any) -> None:
        self.log.append(taken_data)


def test_it_is_asked_in_each_wait(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        own = Own(node)
        node.add_waitable(own)
        for own.something in (False, True, False):
            rclpy.spin_once(node, timeout_sec=0)
            rclpy.spin_once(node, timeout_sec=0)
            world.say(own.log[:])
            own.log.clear()

    asked = ['number', 'add', 'ready?']
    assert ros(body) == [asked * 2, [*asked, 7], asked * 2]


def test_what_ends_the_wait_lets_it_be_asked(ros: Ros, world: World) -> None:
    def body() -> None:
        node, done = Node('n'), Future()
        own = Own(node)

        async def execute(taken: Any) -> None:
            done.set_result(taken)

        own.execute = execute  # type: ignore[method-assign]
        node.add_waitable(own)
        node.create_timer(0.5, lambda: setattr(own, 'something', True))
        rclpy.spin_until_future_complete(node, done)
        world.say(done.result())
        node.remove_waitable(own)
        own.log.clear()
        rclpy.spin_once(node)
        world.say(own.log)

    assert ros(body) == [7, []]


def test_a_wait_set_says_that_there_is_nothing_to_add_to(ros: Ros, world: World) -> None:
    class Adds(Own):
        def add_to_wait_set(self, wait_set: Any) -> None:
            wait_set.add_guard_condition(None)

    def body() -> None:
        node = Node('n')
        node.add_waitable(Adds(node))
        with pytest.raises(AttributeError, match="'WaitSet' object has no attribute 'add_guard_condition'") as caught:
            rclpy.spin_once(node, timeout_sec=0)
        world.say(facts_of(caught.value)['about'])

    assert ros(body) == ['programs.wait-set']

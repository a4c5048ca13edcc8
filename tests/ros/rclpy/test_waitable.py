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


def test_the_base_class_implements_nothing(ros: Ros, world: World) -> None:
    def body() -> None:
        base = Waitable(Node('n').default_callback_group)
        for call in (
            lambda: base.is_ready(None),
            lambda: base.add_to_wait_set(None),
            base.take_data,
            base.get_num_entities,
            lambda: base.execute(None).send(None),
        ):
            with pytest.raises(NotImplementedError, match='^Must be implemented by subclass$'):
                call()

    ros(body)


def test_actions_and_events_say_what_they_consist_of(ros: Ros, world: World) -> None:
    from rclpy.action import ActionClient, ActionServer
    from turtlesim.action import RotateAbsolute

    def body() -> None:
        node = Node('n')
        world.say(ActionClient(node, RotateAbsolute, 'x').get_num_entities())
        world.say(ActionServer(node, RotateAbsolute, 'x', lambda goal: None).get_num_entities())

    assert list(map(repr, ros(body))) == ['<NumberOfEntities(2, 0, 0, 3, 0, 0)>', '<NumberOfEntities(0, 0, 1, 0, 3, 0)>']

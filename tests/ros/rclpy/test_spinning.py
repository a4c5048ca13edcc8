"""rclpy.spin, spin_once and spin_until_future_complete: when they return, and what they leave."""

from __future__ import annotations

import signal
from typing import Any

import pytest
import rclpy
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String

from edulaunch.engine.facts import facts_of
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World, raised


def test_spin_once_waits_no_longer_than_its_timeout(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_timer(0.25, lambda: world.say('tick'))
        rclpy.spin_once(node, timeout_sec=0.1)
        world.say('nothing yet')
        rclpy.spin_once(node)

    world.start(program)
    assert world.run(1) == [(100.0, 'main', 'nothing yet'), (250.0, 'main', 'tick')]


def test_polling_with_spin_once_executes_every_other_time(ros: Ros, world: World) -> None:
    """After what one poll has collected is given out, the next poll only finds its end, as in rclpy."""

    def body() -> None:
        node = Node('n')
        node.create_subscription(String, 'c', lambda message: world.say(message.data), 10)
        publisher = node.create_publisher(String, 'c', 10)
        for number in range(4):
            publisher.publish(String(data=str(number)))
            rclpy.spin_once(node, timeout_sec=0)

    assert ros(body) == ['0', '1']


def test_spin_once_executes_a_callback_that_polls_until_done(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        done: list[int] = []
        node.create_timer(0.02, lambda: done.append(1))
        while not done:
            rclpy.spin_once(node, timeout_sec=0)
        world.say('done')

    assert ros(body) == ['done']


def test_shutdown_in_a_callback_lets_spin_return(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_timer(0.1, rclpy.shutdown)
        node.create_timer(0.1, lambda: world.say('not any more'))
        rclpy.spin(node)
        world.say('returned')

    assert world.run_program(program) == ['returned']


def test_an_exception_in_a_callback_leaves_spin(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_timer(0.1, lambda: 1 // 0)
        with pytest.raises(ZeroDivisionError):
            rclpy.spin(node)
        world.say('raised')

    world.start(program)
    assert world.run(1) == [(100.0, 'main', 'raised')]


def test_spin_until_future_complete_ends_with_the_future_or_its_timeout(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        future = Future()
        node.create_timer(0.3, lambda: future.set_result('done'))
        rclpy.spin_until_future_complete(node, future, timeout_sec=0.2)
        world.say(future.done())
        rclpy.spin_until_future_complete(node, future)
        world.say(future.result())

    world.start(program)
    assert world.run(1) == [(200.0, 'main', False), (300.0, 'main', 'done')]


def test_a_node_that_is_spun_inside_its_callback_stays_in_its_executor(world: World) -> None:
    """rclpy.spin_until_future_complete removes the node at its end only if it has brought it."""

    def program() -> None:
        rclpy.init()
        node = Node('n')

        def nested() -> None:
            timer.cancel()
            rclpy.spin_until_future_complete(node, Future(), timeout_sec=0.15)
            world.say('nested spin is over')

        timer = node.create_timer(0.1, nested)
        node.create_timer(0.4, lambda: world.say('tick') or rclpy.shutdown())
        rclpy.spin(node)

    world.start(program)
    assert world.run(5) == [(250.0, 'main', 'nested spin is over'), (400.0, 'main', 'tick')]


def test_a_node_that_another_executor_takes_in_a_callback_is_lost(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        node.create_timer(0.1, lambda: world.say('tick') or rclpy.spin_once(node, timeout_sec=0))
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        executor.spin()

    world.start(program)
    assert world.run(5) == [(100.0, 'main', 'tick')]
    assert [(kind, data['callback'], data['spins']) for kind, data in world.tracer.facts] == [
        ('node taken away', '<lambda>', 'spin_once')
    ]


def test_rclpy_spin_once_leaves_a_node_where_it_was(ros: Ros, world: World) -> None:
    def body() -> None:
        node, executor = Node('n'), SingleThreadedExecutor()
        executor.add_node(node)
        rclpy.spin_once(node, executor=executor, timeout_sec=0)
        rclpy.spin_until_future_complete(node, Future(), executor, 0)
        world.say(executor.get_nodes() == [node])
        rclpy.spin_once(node, timeout_sec=0)
        world.say(executor.get_nodes() + rclpy.get_global_executor().get_nodes())

    assert ros(body) == [True, []]


def test_shutdown_in_another_thread_ends_an_executor_of_ones_own(world: World) -> None:
    def program() -> None:
        rclpy.init()
        executor = SingleThreadedExecutor()
        current_process().start_thread(lambda: (sleep(0.2), rclpy.shutdown()), 'other', True)
        with pytest.raises(ExternalShutdownException):
            executor.spin()
        world.say('ended')

    world.start(program)
    assert world.run(1) == [(200.0, 'main', 'ended')]


INVALID = 'the given context is not valid, either rcl_init() was not called or rcl_shutdown() was called.'


def test_spinning_after_a_signal_is_told_in_the_words_of_rcl(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node, executor = Node('n'), SingleThreadedExecutor()
        current_process().send_signal(signal.SIGTERM)
        sleep(0.1)
        world.say(raised(lambda: rclpy.spin(node)))
        world.say(raised(lambda: executor.spin_once(timeout_sec=0.1)))
        world.say(raised(executor.spin_once))
        world.say(raised(executor.spin))

    assert world.run_program(program) == [
        f'RCLError: failed to {what}: {INVALID}' for what in ('create guard_condition', 'create timer', 'initialize wait set')
    ] + [None]


def test_what_cannot_be_spun_is_told_in_the_words_of_rclpy(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        for spin in (
            lambda: rclpy.spin(None),
            lambda: rclpy.spin(Node),
            lambda: rclpy.spin(node, 5),
            lambda: rclpy.spin_until_future_complete(node, Future(), 1.0),
            lambda: rclpy.spin_until_future_complete(node, None),
        ):
            world.say(raised(spin))

    assert ros(body) == [
        "AttributeError: 'NoneType' object has no attribute 'executor'",
        "TypeError: 'property' object is not iterable",
        "AttributeError: 'int' object has no attribute 'remove_node'",
        "AttributeError: 'float' object has no attribute 'add_node'",
        "AttributeError: 'NoneType' object has no attribute 'add_done_callback'",
    ]


@pytest.mark.parametrize('executor_class', [SingleThreadedExecutor, MultiThreadedExecutor])
def test_a_stop_iteration_in_a_callback_becomes_a_runtime_error(ros: Ros, world: World, executor_class: Any) -> None:
    def body() -> None:
        node, nothing = Node('n'), iter(())
        node.create_timer(0.1, lambda: next(nothing))
        world.say(raised(lambda: rclpy.spin(node, executor_class())))
        world.say(raised(lambda: rclpy.spin_once(node)))

    assert ros(body) == ['RuntimeError: coroutine raised StopIteration'] * 2


def test_an_executor_without_its_brackets_is_refused_as_rclpy_refuses_it(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(TypeError, match=r"Executor\.add_node\(\) missing 1 required positional argument: 'node'") as refused:
            rclpy.spin(Node('a'), MultiThreadedExecutor)
        world.say(facts_of(refused.value)['about'])

    assert ros(body) == ['messages.class-given']

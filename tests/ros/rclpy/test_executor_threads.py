"""Executors and threads: those of MultiThreadedExecutor, and programs that spin one executor from several."""

from __future__ import annotations

import threading
from collections.abc import Callable
from typing import Any

import pytest
import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from rclpy.node import Node
from rclpy.task import Future

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World


def test_a_future_set_in_another_thread_wakes_the_coroutine_that_awaits_it(world: World) -> None:
    def program() -> None:
        rclpy.init()
        executor = SingleThreadedExecutor()
        future = Future()

        async def wait() -> None:
            world.say(await future)

        executor.create_task(wait)
        current_process().start_thread(lambda: (sleep(0.2), future.set_result('woken')), 'other', True)
        executor.spin()

    world.start(program)
    assert world.run(1) == [(200.0, 'main', 'woken')]


def test_no_more_callbacks_run_than_there_are_threads(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        for number in range(3):
            node.create_timer(
                0.1, lambda number=number: (world.say(number), sleep(1.0)), ReentrantCallbackGroup()
            ).timer_period_ns = 10**11
        executor = MultiThreadedExecutor(num_threads=2)
        executor.add_node(node)
        executor.spin()

    world.start(program)
    assert world.run(5) == [(100.0, 'main', 0), (100.0, 'main', 1), (1100.0, 'main', 2)]


def test_one_thread_is_warned_of(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.warns(UserWarning, match='MultiThreadedExecutor is used with a single thread'):
            MultiThreadedExecutor(num_threads=1)
        world.say('warned')

    assert ros(body) == ['warned']


@pytest.mark.parametrize(('blocks', 'milliseconds'), [(False, 100.0), (True, 200.0)])
def test_an_exception_in_a_thread_comes_out_at_once_or_after_blocking_at_the_next_callback(
    world: World, blocks: bool, milliseconds: float
) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')

        def fail() -> None:
            if blocks:
                sleep(0.01)
            raise ZeroDivisionError

        node.create_timer(0.1, fail)
        executor = MultiThreadedExecutor()
        executor.add_node(node)
        with pytest.raises(ZeroDivisionError):
            executor.spin()
        world.say('raised')

    world.start(program)
    assert world.run(1) == [(milliseconds, 'main', 'raised')]


def test_a_program_ends_when_its_callbacks_have_ended_and_then_says_no_more(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        executor = MultiThreadedExecutor(2)
        executor.add_node(node)

        def work() -> None:
            timer.cancel()
            world.say('begins')
            sleep(2.0)
            world.say('ends')

        timer = node.create_timer(0.5, work)
        executor.spin_once()
        sleep(0.1)

    assert ros(body) == ['begins', 'ends']


def test_two_threads_cannot_spin_one_executor(world: World) -> None:
    def program() -> None:
        rclpy.init()
        executor = SingleThreadedExecutor()
        current_process().start_thread(executor.spin, 'spinner', True)
        sleep(0.1)
        with pytest.raises(ValueError, match='generator already executing'):
            executor.spin()
        world.say('refused')

    assert world.run_program(program, seconds=1) == ['refused']


def test_an_executor_needs_threads(ros: Ros) -> None:
    def body() -> None:
        with pytest.raises(ValueError, match='max_workers must be greater than 0'):
            MultiThreadedExecutor(num_threads=0)

    ros(body)


def two_threads(world: World, first: Callable[[Any], None], second: Callable[[Any], None]) -> list[Any]:
    """What goes wrong when a thread and then the main program use one executor; it is shut down after a second."""

    def program() -> None:

        rclpy.init()
        node, executor = Node('n'), SingleThreadedExecutor()
        executor.add_node(node)
        node.create_timer(0.2, lambda: None)

        def safely(use: Callable[[Any], None], who: str) -> None:
            try:
                use(executor)
                world.say(f'{who} ended')
            except ValueError as error:
                world.say(f'{who}: {error}'.partition('\n')[0])

        process = current_process()
        process.start_thread(lambda: safely(first, 'thread'), 'thread', True)
        process.start_thread(lambda: (sleep(1.0), executor.shutdown()), 'end', True)
        sleep(0.05)
        safely(second, 'main')
        sleep(2.0)

    return world.run_program(program)


CLASH = ['main: generator already executing']


@pytest.mark.parametrize(
    ('first', 'second', 'clash'),
    [
        (lambda e: e.spin(), lambda e: e.spin(), True),
        (lambda e: e.spin(), lambda e: e.spin_once(), True),
        (lambda e: e.spin_once(), lambda e: e.spin(), True),
        (lambda e: e.spin_once(timeout_sec=0.5), lambda e: e.spin_once(timeout_sec=0.5), True),
        (lambda e: e.spin_once(timeout_sec=0.5), lambda e: e.spin_once(timeout_sec=0.4), False),
        (lambda e: e.spin_once(timeout_sec=0.5), lambda e: e.spin(), False),
        (lambda e: e.spin(), lambda e: e.spin_once(timeout_sec=0.5), False),
        (lambda e: e.spin_until_future_complete(Future()), lambda e: e.spin(), False),
        (lambda e: e.spin_until_future_complete(Future()), lambda e: e.spin_until_future_complete(Future(), 0.5), False),
    ],
)
def test_two_threads_of_an_executor_clash_only_with_equal_calls(world: World, first: Any, second: Any, clash: bool) -> None:
    """As in Jazzy: the wait belongs to the arguments, and two threads cannot take from one."""
    said = two_threads(world, first, second)
    assert [what for what in said if 'generator' in what] == (CLASH if clash else [])


def test_a_shutdown_by_another_thread_just_before_a_wait_ends_it(ros: Ros, world: World) -> None:
    def body() -> None:
        executor = SingleThreadedExecutor()

        class Waiters(list[Any]):
            """Another thread comes in just before somebody joins."""

            def append(self, task: Any) -> None:
                thread = threading.Thread(target=executor.shutdown)
                thread.start()
                thread.join()
                super().append(task)

        executor._waiting = Waiters()
        executor.spin_once(timeout_sec=5.0)
        world.say(current_process().sim.elapsed_s)

    assert ros(body) == [0.0]

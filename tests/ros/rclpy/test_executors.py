"""rclpy.executors: whose turn it is, which nodes an executor has, tasks, and what it refuses."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
import rclpy
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import Executor, MultiThreadedExecutor, SingleThreadedExecutor, await_or_execute
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String
from std_srvs.srv import Empty

from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World, everything_ready, raised

ORDER = ['timer', 'subscription', 'guard', 'service']


def test_one_wait_executes_by_category(ros: Ros, world: World) -> None:
    def body() -> None:
        node = everything_ready(world, 'n', 't')
        for _ in range(4):
            rclpy.spin_once(node)

    assert ros(body) == [('n', category) for category in ORDER]


def test_one_wait_executes_node_by_node(ros: Ros, world: World) -> None:
    def body() -> None:
        executor = SingleThreadedExecutor()
        for name in ('second', 'first'):
            executor.add_node(everything_ready(world, name, name))
        for _ in range(8):
            executor.spin_once()

    assert ros(body) == [(name, category) for name in ('second', 'first') for category in ORDER]


def test_tasks_come_first_and_newest_first(ros: Ros, world: World) -> None:
    def body() -> None:
        node = everything_ready(world, 'n', 't')
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        for number in range(2):
            executor.create_task(world.say, f'task {number}')
        for _ in range(3):
            executor.spin_once()

    assert ros(body) == ['task 1', 'task 0', ('n', 'timer')]


def test_a_subscription_gives_one_message_in_a_wait(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        for topic in ('a', 'b'):
            node.create_subscription(String, topic, lambda message: world.say(message.data), 10)
            publisher = node.create_publisher(String, topic, 10)
            for number in range(2):
                publisher.publish(String(data=f'{topic}{number}'))
        node.create_timer(0.1, rclpy.shutdown)
        rclpy.spin(node)

    assert ros(body) == ['a0', 'b0', 'a1', 'b1']


def test_async_callbacks_await_futures(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        future = Future()

        async def wait() -> None:
            world.say('waiting')
            world.say(await future)
            rclpy.shutdown()

        node.create_timer(0.1, wait, ReentrantCallbackGroup()).timer_period_ns = 10**10
        node.create_timer(0.3, lambda: future.set_result('result'))
        rclpy.spin(node)

    world.start(program)
    assert world.run(1) == [(100.0, 'main', 'waiting'), (300.0, 'main', 'result')]


def test_a_node_moves_to_the_executor_that_it_was_added_to_last(ros: Ros, world: World) -> None:
    def body() -> None:
        node, first, second = Node('n'), SingleThreadedExecutor(), SingleThreadedExecutor()
        world.say((first.add_node(node), first.add_node(node)))
        second.add_node(node)
        world.say((first.get_nodes(), second.get_nodes() == [node], node.executor is second))

    assert ros(body) == [(True, False), ([], True, True)]


def test_callbacks_that_never_wait_let_time_pass(world: World) -> None:
    """Two programs that answer each other without end do not stop the clock."""

    def echo(hears: str, says: str) -> Callable[[], None]:
        def program() -> None:
            rclpy.init()
            node = Node('n')
            publisher = node.create_publisher(String, says, 10)
            node.create_subscription(String, hears, publisher.publish, 10)
            publisher.publish(String())
            rclpy.spin(node)

        return program

    world.start(echo('a', 'b'), name='first')
    world.start(echo('b', 'a'), name='second')
    world.run(0.005)
    assert world.sim.elapsed_s == 0.005


def test_a_node_that_comes_in_a_callback_is_executed_too(ros: Ros, world: World) -> None:
    def body() -> None:
        first, second = Node('first'), Node('second')
        second.create_timer(0.1, lambda: world.say('second'))
        executor = SingleThreadedExecutor()
        executor.add_node(first)
        first.create_timer(0.25, lambda: executor.add_node(second)).timer_period_ns = 10**12
        first.create_timer(0.45, rclpy.shutdown)
        executor.spin()

    assert ros(body) == ['second', 'second', 'second']


def test_a_node_that_leaves_in_a_callback_is_executed_no_more(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('node')
        executor = SingleThreadedExecutor()
        executor.add_node(node)

        def leave() -> None:
            world.say('leaving')
            executor.remove_node(node)

        node.create_timer(0.1, leave)
        executor.spin()

    assert ros(body) == ['leaving']


def test_spin_some_executes_each_ready_entity_once(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.create_subscription(String, 'c', lambda message: world.say(message.data), 10)
        publisher = node.create_publisher(String, 'c', 10)
        for number in range(3):
            publisher.publish(String(data=str(number)))
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        executor.rcl_spin_ready()
        world.say('next')
        executor.rcl_spin_ready()

    assert ros(body) == ['0', 'next', '1']


def test_spin_some_has_rclcpps_order(ros: Ros, world: World) -> None:
    """Timers, subscriptions, services, clients; Python's own order has clients before services."""

    def body() -> None:
        node = Node('n')
        node.create_service(Empty, 's', lambda request, response: world.say('service') or response)
        client = node.create_client(Empty, 's')
        executor = SingleThreadedExecutor()
        executor.add_node(node)
        client.call_async(Empty.Request()).add_done_callback(lambda _: world.say('client'))
        executor.rcl_spin_ready()
        client.call_async(Empty.Request())
        node.create_subscription(String, 'c', lambda message: world.say('subscription'), 10)
        node.create_publisher(String, 'c', 10).publish(String())
        node.create_timer(0.1, lambda: world.say('timer'))
        sleep(0.1)
        executor.rcl_spin_ready()

    assert ros(body) == ['service', 'timer', 'subscription', 'service', 'client']


def test_an_executor_of_ones_own_gets_tasks_to_call(ros: Ros, world: World) -> None:
    class Own(SingleThreadedExecutor):
        def spin_once(self, timeout_sec: float | None = None) -> None:
            task, entity, node = self.wait_for_ready_callbacks(timeout_sec=timeout_sec)
            world.say((type(entity).__name__, node.get_name()))
            task()

    def body() -> None:
        node = Node('n')
        node.create_timer(0.1, rclpy.shutdown)
        executor = Own()
        executor.add_node(node)
        executor.spin()

    assert ros(body) == [('Timer', 'n')]


def test_a_callback_may_be_awaited_or_executed(world: World) -> None:
    async def doubled(value: int) -> int:
        return 2 * value

    async def both() -> list[int]:
        return [await await_or_execute(doubled, 3), await await_or_execute(abs, -4)]

    coroutine = both()
    with pytest.raises(StopIteration) as ended:
        coroutine.send(None)
    assert ended.value.value == [6, 4]


NO_CONTEXT = "'NoneType' object does not support the context manager protocol"


def test_an_executor_needs_init(world: World) -> None:
    def program() -> None:
        for act in (SingleThreadedExecutor, rclpy.get_global_executor, rclpy.init, rclpy.shutdown, MultiThreadedExecutor):
            world.say(raised(act))

    assert world.run_program(program) == [
        f'TypeError: {NO_CONTEXT}',
        f'TypeError: {NO_CONTEXT}',
        None,
        None,
        f'TypeError: {NO_CONTEXT}',
    ]


def test_an_executor_that_was_shut_down_takes_nothing_more(ros: Ros, world: World) -> None:
    def body() -> None:
        executor = SingleThreadedExecutor()
        executor.shutdown()
        world.say(raised(lambda: executor.add_node(Node('n'))))
        world.say(raised(lambda: executor.create_task(print)))

    assert ros(body) == ["AttributeError: 'NoneType' object has no attribute 'trigger'"] * 2


def test_a_cancelled_task_is_not_run_and_nobody_waits_for_it(ros: Ros, world: World) -> None:
    def body() -> None:
        executor, future = SingleThreadedExecutor(), Future()
        task = executor.create_task(lambda: world.say('never'))
        task.cancel()
        executor.spin_until_future_complete(task)

        async def wait() -> None:
            world.say(('resumed', await future))

        waiting = executor.create_task(wait)
        executor.create_task(future.cancel)
        executor.spin_until_future_complete(waiting)
        world.say((task.done(), task.cancelled()))

    assert ros(body) == [('resumed', None), (False, True)]


def test_a_mock_is_a_callback(ros: Ros, world: World) -> None:
    """A mock has every attribute, also `func`; only partials are looked through."""
    from functools import partial
    from unittest.mock import AsyncMock, Mock

    def body() -> None:
        heard, partly, awaited = Mock(), Mock(), AsyncMock()
        node = Node('n')
        node.create_subscription(String, 't', heard, 10)
        node.create_subscription(String, 't', partial(partly, 1), 10)
        node.create_guard_condition(awaited).trigger()
        node.create_publisher(String, 't', 10).publish(String(data='x'))
        for _ in range(4):
            rclpy.spin_once(node, timeout_sec=0)
        world.say((heard.call_args.args, partly.call_args.args, awaited.await_count))

    assert ros(body) == [((String(data='x'),), (1, String(data='x')), 1)]


def test_a_node_that_moves_takes_what_is_ready_along(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        for name in 'abc':
            node.create_guard_condition(lambda name=name: world.say(name)).trigger()
        first, second = SingleThreadedExecutor(), SingleThreadedExecutor()
        first.add_node(node)
        first.spin_once(timeout_sec=0)
        second.add_node(node)
        for _ in range(2):
            second.spin_once(timeout_sec=0)

    assert ros(body) == ['a', 'b', 'c']


def test_an_executor_of_ones_own_may_change_what_spins_once(ros: Ros, world: World) -> None:
    class Counting(SingleThreadedExecutor):
        def _spin_once_impl(self, timeout_sec: Any = None, wait_condition: Any = lambda: False) -> None:
            world.say(timeout_sec)
            super()._spin_once_impl(timeout_sec, wait_condition)

    def body() -> None:
        node, executor, future = Node('n'), Counting(), Future()
        executor.add_node(node)
        node.create_timer(0.5, lambda: future.set_result(1))
        executor.spin_once(timeout_sec=0.1)
        executor.spin_once_until_future_complete(future, timeout_sec=1.0)
        world.say(future.result())
        executor.create_task(rclpy.shutdown)
        executor.spin()

    assert ros(body) == [0.1, 1.0, 1, None]


def test_a_subclass_may_use_names_that_ros_2_does_not_have(ros: Ros, world: World) -> None:
    class Answer(Future):
        source = 'camera'

    class Marked(SingleThreadedExecutor):
        turn_mark = 'mine'

    def body() -> None:
        node, executor, answer = Node('n'), Marked(), Answer()
        node.create_timer(0.5, lambda: answer.set_result(answer.done()))
        rclpy.spin_until_future_complete(node, answer, executor)
        world.say((answer.result(), answer.source, executor.turn_mark))

    assert ros(body) == [(False, 'camera', 'mine')]


@pytest.mark.parametrize(
    'spin',
    [
        lambda executor, future: executor.spin(),
        lambda executor, future: executor.spin_once(timeout_sec=0.1),
        lambda executor, future: executor.spin_until_future_complete(future, timeout_sec=0.1),
        lambda executor, future: executor.spin_once_until_future_complete(future, timeout_sec=0.1),
    ],
)
def test_the_base_class_executes_nothing(spin: Callable[[Executor, Future], object]) -> None:
    """Real rclpy 7.1.6 raises NotImplementedError without a text."""
    rclpy.init(args=[])
    try:
        with pytest.raises(NotImplementedError, match='^$'):
            spin(Executor(), Future())
    finally:
        rclpy.shutdown()

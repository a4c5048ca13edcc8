"""rclpy.executors: order, spinning, groups, threads."""

from __future__ import annotations

import signal
from collections.abc import Callable
from typing import Any

import pytest
import rclpy
from rclpy.callback_groups import MutuallyExclusiveCallbackGroup, ReentrantCallbackGroup
from rclpy.executors import ExternalShutdownException, MultiThreadedExecutor, SingleThreadedExecutor, await_or_execute
from rclpy.experimental import EventsExecutor
from rclpy.node import Node
from rclpy.task import Future
from std_msgs.msg import String
from std_srvs.srv import Empty

from edulaunch.facts import facts_of
from edulaunch.processes.current import current_process
from edulaunch.sim.sync import sleep

from .conftest import World

Ros = Callable[..., list[Any]]


def everything_ready(world: World, name: str, topic: str) -> Node:
    """A node of which everything is ready after 0.1 s: service, client, guard condition, subscription, timer."""
    node = Node(name)

    def serve(request: Any, response: Any) -> Any:
        world.say((name, 'service'))
        return response

    node.create_service(Empty, f'{topic}/service', serve)
    node.create_client(Empty, f'{topic}/service').call_async(Empty.Request())
    node.create_guard_condition(lambda: world.say((name, 'guard'))).trigger()
    node.create_subscription(String, topic, lambda _: world.say((name, 'subscription')), 10)
    node.create_publisher(String, topic, 10).publish(String())
    timer = node.create_timer(0.1, lambda: world.say((name, 'timer')))
    node.create_guard_condition(timer.cancel)
    sleep(0.1)
    return node


ORDER = ['timer', 'subscription', 'guard', 'service']


def test_one_wait_executes_by_category(ros: Ros, world: World) -> None:
    def body() -> None:
        node = everything_ready(world, 'n', 't')
        for _ in range(4):
            rclpy.spin_once(node)

    assert ros(body) == [('n', category) for category in ORDER]


def test_an_events_executor_goes_by_the_order_of_arrival(ros: Ros, world: World) -> None:
    def body() -> None:
        with EventsExecutor() as executor:
            executor.add_node(everything_ready(world, 'n', 't'))
            for number in (1, 2):
                executor.create_task(world.say, ('n', f'task {number}'))
            for _ in range(6):
                executor.spin_once()

    assert ros(body) == [('n', what) for what in ('task 1', 'task 2', 'service', 'guard', 'subscription', 'timer')]


def test_an_events_executor_spins_until_ros_is_shut_down(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.create_timer(0.5, lambda: world.say('tick') or rclpy.shutdown())
        rclpy.spin(node, EventsExecutor())
        world.say('over')

    assert ros(body) == ['tick', 'over']


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
        executor.spin_ready()
        world.say('next')
        executor.spin_ready()

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
        executor.spin_ready()
        client.call_async(Empty.Request())
        node.create_subscription(String, 'c', lambda message: world.say('subscription'), 10)
        node.create_publisher(String, 'c', 10).publish(String())
        node.create_timer(0.1, lambda: world.say('timer'))
        sleep(0.1)
        executor.spin_ready()

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


def test_an_executor_needs_threads(ros: Ros) -> None:
    def body() -> None:
        with pytest.raises(ValueError, match='max_workers must be greater than 0'):
            MultiThreadedExecutor(num_threads=0)

    ros(body)


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
INVALID = 'the given context is not valid, either rcl_init() was not called or rcl_shutdown() was called.'


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


def test_an_executor_that_was_shut_down_takes_nothing_more(ros: Ros, world: World) -> None:
    def body() -> None:
        executor = SingleThreadedExecutor()
        executor.shutdown()
        world.say(raised(lambda: executor.add_node(Node('n'))))
        world.say(raised(lambda: executor.create_task(print)))

    assert ros(body) == ["AttributeError: 'NoneType' object has no attribute 'trigger'"] * 2


@pytest.mark.parametrize('executor_class', [SingleThreadedExecutor, MultiThreadedExecutor])
def test_a_stop_iteration_in_a_callback_becomes_a_runtime_error(ros: Ros, world: World, executor_class: Any) -> None:
    def body() -> None:
        node, nothing = Node('n'), iter(())
        node.create_timer(0.1, lambda: next(nothing))
        world.say(raised(lambda: rclpy.spin(node, executor_class())))
        world.say(raised(lambda: rclpy.spin_once(node)))

    assert ros(body) == ['RuntimeError: coroutine raised StopIteration'] * 2


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


def raised(act: Callable[[], Any]) -> str | None:
    try:
        act()
    except Exception as error:
        return f'{type(error).__name__}: {error}'
    return None


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


def test_an_executor_without_its_brackets_is_refused_as_rclpy_refuses_it(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(TypeError, match=r"Executor\.add_node\(\) missing 1 required positional argument: 'node'") as refused:
            rclpy.spin(Node('a'), MultiThreadedExecutor)
        world.say(facts_of(refused.value)['about'])

    assert ros(body) == ['messages.class-given']

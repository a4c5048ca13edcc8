"""Services and clients of rclpy nodes."""

from __future__ import annotations

from collections.abc import Callable
from functools import partial
from typing import Any

import pytest
import rclpy
from example_interfaces.srv import AddTwoInts
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node
from rclpy.qos import qos_profile_system_default
from rclpy.service_introspection import ServiceIntrospectionState
from rclpy.task import Future

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.sync import sleep

from .conftest import Ros, World

Request = AddTwoInts.Request


def add(request: Any, response: Any) -> Any:
    response.sum = request.a + request.b
    return response


def server(callback: Any = add, start_s: float = 0.0) -> Callable[[], None]:
    def program() -> None:
        sleep(start_s)
        rclpy.init()
        node = Node('server')
        node.create_service(AddTwoInts, 'add', callback)
        rclpy.spin(node)

    return program


def test_a_call_from_main_is_answered_while_the_node_is_spun(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('client')
        client = node.create_client(AddTwoInts, 'add')
        while not client.wait_for_service(timeout_sec=1.0):
            world.say('waiting')
        future = client.call_async(Request(a=1, b=2))
        rclpy.spin_until_future_complete(node, future)
        world.say(future.result().sum)

    world.start(program)
    world.start(server(start_s=1.6), name='server')
    assert world.run(5) == [(1000.0, 'main', 'waiting'), (1750.0, 'main', 3)]


def test_done_callbacks_run_on_the_executor(world: World) -> None:
    """The student's idiom: a client made in a callback, a loop that waits, a partial that takes the answer."""

    def program() -> None:
        rclpy.init()
        node = Node('client')

        def answered(number: int, future: Future) -> None:
            world.say((number, future.result().sum))
            rclpy.shutdown()

        def tick() -> None:
            client = node.create_client(AddTwoInts, 'add')
            while not client.wait_for_service(1.0):
                pass
            client.call_async(Request(a=2, b=2)).add_done_callback(partial(answered, 7))

        node.create_timer(0.1, tick).timer_period_ns = 10**10
        rclpy.spin(node)

    world.start(program)
    world.start(server(), name='server')
    assert world.run(1) == [(100.0, 'main', (7, 4))]


def test_waiting_with_a_timeout_looks_each_quarter_second(world: World) -> None:
    def program() -> None:
        rclpy.init()
        client = Node('n').create_client(AddTwoInts, 'add')
        world.say(client.wait_for_service(timeout_sec=0.1))

    world.start(program)
    assert world.run(1) == [(250.0, 'main', False)]


def test_a_request_without_server_is_lost(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        future = node.create_client(AddTwoInts, 'add').call_async(Request())
        rclpy.spin_until_future_complete(node, future, timeout_sec=2.0)
        world.say(future.done())

    world.start(program)
    world.start(server(start_s=1.0), name='server')
    assert world.run(5) == [(2000.0, 'main', False)]


def test_another_request_class_is_refused(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(TypeError):
            Node('n').create_client(AddTwoInts, 'add').call_async(AddTwoInts.Response())
        world.say('refused')

    assert ros(body) == ['refused']


@pytest.mark.parametrize('forgetful', [lambda request, response: None, lambda request, response: 5])
def test_a_callback_that_returns_no_response_ends_the_server(world: World, forgetful: Any) -> None:
    def serving() -> None:
        rclpy.init()
        node = Node('server')
        node.create_service(AddTwoInts, 'add', forgetful)
        with pytest.raises(TypeError):
            rclpy.spin(node)
        world.say('ended')

    world.start(serving, name='server')
    world.start(lambda: (rclpy.init(), Node('n').create_client(AddTwoInts, 'add').call_async(Request())))
    assert world.run(1) == [(0.0, 'server', 'ended')]


def test_an_async_service_answers_when_it_has_ended(world: World) -> None:
    def serving() -> None:
        rclpy.init()
        node = Node('server')
        gate = Future()

        async def slow(request: Any, response: Any) -> Any:
            await gate
            return add(request, response)

        node.create_service(AddTwoInts, 'add', slow, callback_group=ReentrantCallbackGroup())
        node.create_timer(0.5, lambda: gate.set_result(None))
        rclpy.spin(node)

    def program() -> None:
        rclpy.init()
        node = Node('n')
        future = node.create_client(AddTwoInts, 'add').call_async(Request(a=1, b=1))
        rclpy.spin_until_future_complete(node, future)
        world.say(future.result().sum)

    world.start(serving, name='server')
    world.start(program)
    assert world.run(1) == [(500.0, 'main', 2)]


def test_a_blocking_call_works_beside_a_spinning_thread(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('n')
        current_process().start_thread(lambda: rclpy.spin(node), 'spinner', True)
        sleep(0.1)
        world.say(node.create_client(AddTwoInts, 'add').call(Request(a=3, b=4)).sum)

    world.start(server(), name='server')
    world.start(program)
    assert world.run(1) == [(100.0, 'main', 7)]


def test_a_blocking_call_gives_none_after_its_timeout(world: World) -> None:
    def program() -> None:
        rclpy.init()
        world.say(Node('n').create_client(AddTwoInts, 'add').call(Request(), timeout_sec=0.5))

    world.start(program)
    assert world.run(1) == [(500.0, 'main', None)]


def calling_in_a_callback(world: World, executor: Any, group: Any) -> Callable[[], None]:
    def program() -> None:
        rclpy.init()
        node = Node('client')
        client = node.create_client(AddTwoInts, 'add', callback_group=group() if group else None)
        node.create_timer(0.1, lambda: world.say(client.call(Request(a=1, b=1)).sum)).timer_period_ns = 10**11
        spinner = executor()
        spinner.add_node(node)
        spinner.spin()

    return program


@pytest.mark.parametrize(
    ('executor', 'group'),
    [
        (rclpy.executors.SingleThreadedExecutor, None),
        (rclpy.executors.SingleThreadedExecutor, ReentrantCallbackGroup),
        (MultiThreadedExecutor, None),
    ],
)
def test_a_blocking_call_in_a_callback_hangs_and_is_explained(world: World, executor: Any, group: Any) -> None:
    world.start(server(), name='server')
    world.start(calling_in_a_callback(world, executor, group))
    assert world.run(5) == []
    assert [(data['waiting'], data['callback'], data['node']) for _, data in world.tracer.waits()] == [
        ('call', '<lambda>', '/client')
    ]


def test_a_blocking_call_in_a_callback_works_with_threads_and_another_group(world: World) -> None:
    world.start(server(), name='server')
    world.start(calling_in_a_callback(world, MultiThreadedExecutor, ReentrantCallbackGroup))
    assert world.run(1) == [(100.0, 'main', 2)]
    assert world.tracer.waits() == []


def test_a_removed_request_is_never_done(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        node.create_service(AddTwoInts, 'add', add)
        client = node.create_client(AddTwoInts, 'add')
        future = client.call_async(Request())
        client.remove_pending_request(future)
        rclpy.spin_until_future_complete(node, future, timeout_sec=1.0)
        world.say(future.done())

    assert ros(body) == [False]


def test_introspection_publishes_both_sides(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        service = node.create_service(AddTwoInts, 'add', add)
        client = node.create_client(AddTwoInts, 'add')
        for end in (service, client):
            end.configure_introspection(node.get_clock(), qos_profile_system_default, ServiceIntrospectionState.CONTENTS)
        node.create_subscription(
            AddTwoInts.Event,
            'add/_service_event',
            lambda event: world.say(
                (event.info.event_type, [request.a for request in event.request], [one.sum for one in event.response])
            ),
            10,
        )
        rclpy.spin_until_future_complete(node, client.call_async(Request(a=1, b=2)))
        for _ in range(5):
            rclpy.spin_once(node, timeout_sec=0.1)

    assert ros(body) == [(0, [1], []), (1, [1], []), (2, [], [3]), (3, [], [3])]


def test_introspection_has_one_of_its_states(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        for end in (node.create_service(AddTwoInts, 'add', add), node.create_client(AddTwoInts, 'add')):
            with pytest.raises(TypeError, match='introspection_state must be a ServiceIntrospectionState, not int'):
                end.configure_introspection(node.get_clock(), qos_profile_system_default, 1)  # type: ignore[arg-type]
        world.say('done')

    assert ros(body) == ['done']


def test_a_wait_without_time_is_only_a_look(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        before = node.get_clock().now()
        world.say((node.create_client(AddTwoInts, 'add').wait_for_service(-1.0), (node.get_clock().now() - before).nanoseconds))

    assert ros(body) == [(False, 0)]


def test_names(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n', namespace='ns')
        world.say((node.create_client(AddTwoInts, 'add').srv_name, node.create_service(AddTwoInts, '~/add', add).service_name))

    assert ros(body) == [('add', '/ns/n/add')]


def test_a_request_that_waits_is_found_by_its_number(ros: Ros, world: World) -> None:
    def body() -> None:
        client = Node('n').create_client(AddTwoInts, 's')
        future = client.call_async(AddTwoInts.Request())
        world.say(client.get_pending_request(1) is future)
        client.remove_pending_request(future)
        with pytest.raises(KeyError, match='1'):
            client.get_pending_request(1)

    assert ros(body) == [True]


def test_a_call_whose_request_is_cancelled_gives_none(ros: Ros, world: World) -> None:
    def body() -> None:
        client = Node('n').create_client(AddTwoInts, 'nobody')

        def cancel() -> None:
            sleep(1.0)
            client.get_pending_request(1).cancel()

        current_process().start_thread(cancel, 'canceller', True)
        world.say(client.call(Request()))

    assert ros(body) == [None]

"""rclpy.action.server: goals from their acceptance to their result."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy._rclpy_pybind11 import RCLError
from rclpy.action import ActionClient, ActionServer, CancelResponse, GoalResponse
from rclpy.node import Node

from .conftest import Ros, World
from .fibonacci import client, compute, run, server


def test_a_goal_with_feedback_and_result(world: World) -> None:
    assert run(world, server(), client(world)) == [
        (0.0, 'accepted'),
        (0.0, [0, 1, 1]),
        (1000.0, [0, 1, 1, 2]),
        (2000.0, (GoalStatus.STATUS_SUCCEEDED, [0, 1, 1, 2])),
    ]


def test_a_rejected_goal(world: World) -> None:
    assert run(world, server(goal_callback=lambda goal: GoalResponse.REJECT), client(world))[0] == (0.0, 'rejected')


def test_a_goal_callback_that_returns_something_else_rejects(world: World) -> None:
    assert run(world, server(goal_callback=lambda goal: True), client(world))[0] == (0.0, 'rejected')
    assert world.tracer.logs == [
        (30, 'server.action_server', 'Goal request callback did not return a GoalResponse type. Rejecting goal.')
    ]


def test_cancelling_needs_threads_and_an_accepting_callback(world: World) -> None:
    programs = server(threads=True, cancel_callback=lambda goal: CancelResponse.ACCEPT), client(world, 5, cancel_after_s=0.5)
    assert run(world, *programs) == [
        (0.0, 'accepted'),
        (0.0, [0, 1, 1]),
        (500.0, 1),
        (1000.0, (GoalStatus.STATUS_CANCELED, [0, 1, 1])),
    ]


def test_by_default_requests_to_cancel_are_rejected(world: World) -> None:
    log = run(world, server(threads=True), client(world, 3, cancel_after_s=0.5))
    assert [what for at, what in log if at >= 500] == [0, [0, 1, 1, 2], (GoalStatus.STATUS_SUCCEEDED, [0, 1, 1, 2])]


def test_a_blocking_execute_callback_keeps_a_single_thread_from_cancelling(world: World) -> None:
    log = run(world, server(cancel_callback=lambda goal: CancelResponse.ACCEPT), client(world, 3, cancel_after_s=0.5))
    assert (2000.0, (GoalStatus.STATUS_SUCCEEDED, [0, 1, 1, 2])) in log


def test_an_exception_in_the_execute_callback_aborts_the_goal(world: World) -> None:
    def broken(goal_handle: Any) -> Any:
        raise ValueError('broken on purpose')

    log = run(world, server(broken), client(world))
    assert log[-1] == (0.0, (GoalStatus.STATUS_ABORTED, []))
    assert world.tracer.logs[0] == (40, 'server.action_server', 'Error raised in execute callback: broken on purpose')
    assert "raise ValueError('broken on purpose')" in world.output['program 0']


def test_async_execute_callbacks(world: World) -> None:
    async def execute(goal_handle: Any) -> Any:
        goal_handle.succeed()
        return Fibonacci.Result(sequence=[goal_handle.request.order])

    assert run(world, server(execute), client(world))[-1] == (0.0, (GoalStatus.STATUS_SUCCEEDED, [3]))


def test_goals_may_be_executed_later(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('server')
        goals: list[Any] = []
        ActionServer(node, Fibonacci, 'fibonacci', compute, handle_accepted_callback=goals.append)
        node.create_timer(2.0, lambda: goals.pop().execute() if goals else None)
        rclpy.spin(node)

    assert run(world, program, client(world))[:2] == [(0.0, 'accepted'), (2000.0, [0, 1, 1])]


def test_a_forgotten_result_ends_the_server_with_a_hint(world: World) -> None:
    run(world, server(lambda goal_handle: goal_handle.succeed()), client(world))
    assert world.output['program 0'].endswith(
        "AttributeError: 'NoneType' object has no attribute 'sequence'\n  help: the execute callback of the action '/fibonacci' returned None instead of a Fibonacci.Result; end the callback with `return result`, where result = Fibonacci.Result()\n"
    )


def test_a_result_needs_the_fields_and_not_the_class(world: World) -> None:
    def execute(goal_handle: Any) -> Any:
        goal_handle.succeed()
        return SimpleNamespace(sequence=[4, 5])

    assert run(world, server(execute), client(world)) == [(0.0, 'accepted'), (0.0, (GoalStatus.STATUS_SUCCEEDED, [4, 5]))]


def test_only_the_execute_callback_is_checked_when_it_is_registered(ros: Ros, world: World) -> None:
    def program() -> None:
        server = ActionServer(Node('server'), Fibonacci, 'fib', compute)
        for kind in ('goal', 'cancel', 'handle_accepted'):
            getattr(server, f'register_{kind}_callback')(3)
        with pytest.raises(TypeError, match='^Failed to register goal execution callback: not callable$'):
            server.register_execute_callback(3)  # type: ignore[arg-type]
        world.say(server.action_type is Fibonacci)

    assert ros(program) == [True]


def test_notifying_that_a_goal_is_done_needs_a_server_that_is_there(ros: Ros, world: World) -> None:
    def body() -> None:
        actions = ActionServer(Node('n'), Fibonacci, 'f', compute)
        world.say(actions.notify_goal_done())  # type: ignore[func-returns-value]
        actions.destroy()
        with pytest.raises(RCLError, match='^Failed to notfiy action server of goal done: action server pointer is invalid$'):
            actions.notify_goal_done()

    assert ros(body) == [None]


def test_no_feedback_after_the_result_and_a_goal_without_time_is_forgotten(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node, handles = Node('n'), []

        def execute(handle: Any) -> Any:
            handles.append(handle)
            handle.succeed()
            return Fibonacci.Result()

        ActionServer(node, Fibonacci, 'f', execute)
        client = ActionClient(node, Fibonacci, 'f')
        sent = client.send_goal_async(Fibonacci.Goal(), feedback_callback=lambda _: world.say('feedback'))
        rclpy.spin_until_future_complete(node, sent)
        handles[0].publish_feedback(Fibonacci.Feedback())
        for _ in range(6):
            rclpy.spin_once(node, timeout_sec=0.1)
        rclpy.spin_until_future_complete(node, sent.result().get_result_async())
        world.say('result')
        handles[0].publish_feedback(Fibonacci.Feedback())
        for _ in range(6):
            rclpy.spin_once(node, timeout_sec=0.1)
        ActionServer(node, Fibonacci, 'g', execute, result_timeout=0)
        client = ActionClient(node, Fibonacci, 'g')
        sent = client.send_goal_async(Fibonacci.Goal())
        rclpy.spin_until_future_complete(node, sent)
        rclpy.spin_once(node, timeout_sec=0.1)
        result = sent.result().get_result_async()
        rclpy.spin_until_future_complete(node, result)
        world.say(result.result().status)

    assert world.run_program(program) == ['feedback', 'result', 0]

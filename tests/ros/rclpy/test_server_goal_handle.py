"""rclpy.action.server_goal_handle: states of a goal, and its feedback."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy._rclpy_pybind11 import RCLError
from rclpy.action import ActionClient, ActionServer
from rclpy.action.server_goal_handle import GoalEvent, ServerGoalHandle, has_ended_until
from rclpy.node import Node
from unique_identifier_msgs.msg import UUID

from .conftest import Ros, World
from .fibonacci import client, compute, run, server


def test_a_goal_without_verdict_is_aborted_with_a_warning(world: World) -> None:
    log = run(world, server(lambda goal_handle: Fibonacci.Result()), client(world))
    assert log[-1] == (0.0, (GoalStatus.STATUS_ABORTED, []))
    assert world.tracer.logs[0][2].startswith('Goal state not set, assuming aborted. Goal ID: [')


def test_illegal_transitions_are_refused(world: World) -> None:
    def twice(goal_handle: Any) -> Any:
        goal_handle.succeed()
        with pytest.raises(RCLError, match='invalid transition from state SUCCEEDED with event ABORT'):
            goal_handle.abort()
        world.say('refused')
        return Fibonacci.Result()

    assert 'refused' in [what for _, what in run(world, server(twice), client(world))]


def test_feedback_of_another_class_is_refused(world: World) -> None:
    def wrong(goal_handle: Any) -> Any:
        with pytest.raises(TypeError):
            goal_handle.publish_feedback(Fibonacci.Result())
        world.say('refused')
        return Fibonacci.Result()

    assert 'refused' in [what for _, what in run(world, server(wrong), client(world))]


def test_the_end_of_a_goal_takes_no_result(world: World) -> None:
    def execute(goal_handle: Any) -> Any:
        goal_handle.succeed(Fibonacci.Result())

    assert run(world, server(execute), client(world))[-1] == (0.0, (GoalStatus.STATUS_ABORTED, []))
    assert world.tracer.logs[0][2] == (
        'Error raised in execute callback: ServerGoalHandle.succeed() takes 1 positional argument but 2 were given'
    )


def test_a_status_is_published_when_a_goal_is_accepted(world: World) -> None:
    def client() -> None:
        rclpy.init()
        node = Node('client')
        client = ActionClient(node, Fibonacci, 'fibonacci')
        client.wait_for_server()
        future = client.send_goal_async(Fibonacci.Goal(order=3))
        future.add_done_callback(lambda done: world.say(done.result().status))
        rclpy.spin_until_future_complete(node, future)
        rclpy.spin_once(node, timeout_sec=0.1)

    world.start(server(handle_accepted_callback=lambda goal_handle: None), name='server')
    world.start(client)
    assert [what for _, _, what in world.run(2)] == [GoalStatus.STATUS_ACCEPTED]


def test_the_goals_of_a_destroyed_server_have_an_unknown_state(ros: Ros, world: World) -> None:
    def program() -> None:
        held: list[Any] = []
        node = Node('server')
        server = ActionServer(node, Fibonacci, 'fib', compute, handle_accepted_callback=held.append)
        future = ActionClient(node, Fibonacci, 'fib').send_goal_async(Fibonacci.Goal())
        rclpy.spin_until_future_complete(node, future)
        world.say((held[0].status, held[0].is_active))
        server.destroy()
        world.say((held[0].status, held[0].is_active))

    assert ros(program) == [(1, True), (0, False)]


def test_feedback_after_a_shutdown_ends_the_execute_callback(world: World) -> None:
    def stubborn(goal_handle: Any) -> Any:
        rclpy.shutdown()
        goal_handle.publish_feedback(Fibonacci.Feedback())
        world.say('not reached')

    assert 'not reached' not in [what for _, what in run(world, server(stubborn), client(world))]
    assert world.tracer.logs[0][2].startswith(
        "Error raised in execute callback: Failed to publish feedback with an action server: publisher's context is invalid"
    )


class Server:
    """What a goal needs of its server: the time, and somebody to report to."""

    def __init__(self) -> None:
        self.now = 5
        self.log: list[str] = []

    def rcl_now_ns(self) -> int:
        return self.now

    def rcl_goal_changed(self) -> None:
        self.log.append('changed')


def test_a_goal_has_ended_from_the_moment_of_its_end_on(world: World) -> None:
    server: Any = Server()
    goal = ServerGoalHandle(server, None, None, None)
    assert not has_ended_until(goal, 100) and goal.is_active
    goal._update_state(GoalEvent.EXECUTE)
    assert not has_ended_until(goal, 100) and goal.is_active
    goal.succeed()
    assert [has_ended_until(goal, limit) for limit in (4, 5, 6)] == [False, True, True] and not goal.is_active
    assert server.log == ['changed'] * 2


def test_handles_are_equal_where_their_goals_are_the_same() -> None:
    ids = [UUID(uuid=[number] * 16) for number in (1, 1, 2)]
    first, same, other = (ServerGoalHandle(None, goal_id, None, None) for goal_id in ids)  # type: ignore[arg-type]
    assert (first == same, first == other, first == ids[0]) == (True, False, False)
    assert {first, same} == {first} and len({first, other}) == 2

"""rclpy.action."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
import rclpy
from action_msgs.msg import GoalStatus
from example_interfaces.action import Fibonacci
from rclpy._rclpy_pybind11 import RCLError
from rclpy.action import (
    ActionClient,
    ActionServer,
    CancelResponse,
    GoalResponse,
    get_action_client_names_and_types_by_node,
    get_action_names_and_types,
    get_action_server_names_and_types_by_node,
)
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.event_handler import EventHandler
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node

from edulaunch.sim.sync import sleep

from .conftest import World

Ros = Callable[..., list[Any]]


def compute(goal_handle: Any) -> Any:
    """The tutorial's server: one number a second."""
    feedback = Fibonacci.Feedback(sequence=[0, 1])
    for i in range(1, goal_handle.request.order):
        if goal_handle.is_cancel_requested:
            goal_handle.canceled()
            return Fibonacci.Result(sequence=feedback.sequence)
        feedback.sequence.append(feedback.sequence[i] + feedback.sequence[i - 1])
        goal_handle.publish_feedback(feedback)
        sleep(1)
    goal_handle.succeed()
    return Fibonacci.Result(sequence=feedback.sequence)


def server(execute: Any = compute, threads: bool = False, **options: Any) -> Callable[[], None]:
    def program() -> None:
        rclpy.init()
        node = Node('server')
        group = ReentrantCallbackGroup() if threads else None
        ActionServer(node, Fibonacci, 'fibonacci', execute, callback_group=group, **options)
        if threads:
            executor = MultiThreadedExecutor()
            executor.add_node(node)
            executor.spin()
        else:
            rclpy.spin(node)

    return program


def client(world: World, order: int = 3, cancel_after_s: float | None = None) -> Callable[[], None]:
    """The tutorial's client: says whether the goal is accepted, feedback, and status with result."""

    def program() -> None:
        rclpy.init()
        node = Node('client')
        actions = ActionClient(node, Fibonacci, 'fibonacci')
        actions.wait_for_server()

        def answered(future: Any) -> None:
            goal = future.result()
            world.say('accepted' if goal.accepted else 'rejected')
            goal.get_result_async().add_done_callback(
                lambda done: world.say((done.result().status, list(done.result().result.sequence)))
            )
            if cancel_after_s is not None:
                node.create_timer(
                    cancel_after_s,
                    lambda: goal.cancel_goal_async().add_done_callback(
                        lambda done: world.say(len(done.result().goals_canceling))
                    ),
                ).timer_period_ns = 10**12

        actions.send_goal_async(
            Fibonacci.Goal(order=order), feedback_callback=lambda message: world.say(list(message.feedback.sequence))
        ).add_done_callback(answered)
        rclpy.spin(node)

    return program


def run(world: World, *programs: Callable[[], None]) -> list[tuple[float, Any]]:
    for number, program in enumerate(programs):
        world.start(program, name=f'program {number}')
    return [(at, what) for at, _, what in world.run(20)]


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


def test_a_goal_without_verdict_is_aborted_with_a_warning(world: World) -> None:
    log = run(world, server(lambda goal_handle: Fibonacci.Result()), client(world))
    assert log[-1] == (0.0, (GoalStatus.STATUS_ABORTED, []))
    assert world.tracer.logs[0][2].startswith('Goal state not set, assuming aborted. Goal ID: [')


def test_an_exception_in_the_execute_callback_aborts_the_goal(world: World) -> None:
    def broken(goal_handle: Any) -> Any:
        raise ValueError('broken on purpose')

    log = run(world, server(broken), client(world))
    assert log[-1] == (0.0, (GoalStatus.STATUS_ABORTED, []))
    assert world.tracer.logs[0] == (40, 'server.action_server', 'Error raised in execute callback: broken on purpose')
    assert "raise ValueError('broken on purpose')" in world.output['program 0']


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


def test_waiting_for_a_server_gives_up(world: World) -> None:
    def program() -> None:
        rclpy.init()
        world.say(ActionClient(Node('n'), Fibonacci, 'fibonacci').wait_for_server(timeout_sec=0.4))

    world.start(program)
    assert world.run(1) == [(500.0, 'main', False)]


def test_a_goal_of_another_class_is_refused(ros: Ros, world: World) -> None:
    def body() -> None:
        with pytest.raises(TypeError):
            ActionClient(Node('n'), Fibonacci, 'fibonacci').send_goal_async(Fibonacci.Result())
        world.say('refused')

    assert ros(body) == ['refused']


def test_a_blocking_send_goal_in_a_callback_is_explained(world: World) -> None:
    def program() -> None:
        rclpy.init()
        node = Node('client')
        actions = ActionClient(node, Fibonacci, 'fibonacci')
        node.create_timer(0.1, lambda: actions.send_goal(Fibonacci.Goal()))
        rclpy.spin(node)

    run(world, server(), program)
    found = [(data['waiting'], data['callback'], data['name'], data['kind']) for _, data in world.tracer.waits()]
    assert found == [('call', '<lambda>', '/fibonacci', 'action')]


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


def test_the_graph_of_actions_has_errors_of_its_own(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        with pytest.raises(RCLError, match='^Failed to get action server names and type: error not set$'):
            get_action_server_names_and_types_by_node(node, 'nobody', '/')
        rclpy.shutdown()
        with pytest.raises(RCLError, match="^Failed to get action names and type: rcl node's context is invalid$"):
            get_action_names_and_types(node)
        world.say('asked')

    assert ros(body) == ['asked']


def test_a_forgotten_result_ends_the_server_with_a_hint(world: World) -> None:
    run(world, server(lambda goal_handle: goal_handle.succeed()), client(world))
    assert world.output['program 0'].endswith(
        "TypeError\n  help: the execute callback of action '/fibonacci' returned None, not a Fibonacci.Result; end it with `return result`, where result = Fibonacci.Result()\n"
    )


def test_a_quiet_action_client_is_nothing_to_execute(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        ActionClient(node, Fibonacci, 'fibonacci')
        node.create_timer(0.1, lambda: world.say('tick'))
        rclpy.spin_once(node)

    assert ros(body) == ['tick']


def test_actions_are_seen_in_the_graph(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        ActionServer(node, Fibonacci, 'fibonacci', compute)
        other = Node('other')
        ActionClient(other, Fibonacci, 'fibonacci')
        world.say(
            (
                get_action_names_and_types(node),
                get_action_server_names_and_types_by_node(other, 'n', '/'),
                get_action_client_names_and_types_by_node(node, 'other', '/'),
                get_action_client_names_and_types_by_node(node, 'n', '/'),
            )
        )

    found = [('/fibonacci', ['example_interfaces/action/Fibonacci'])]
    assert ros(body) == [(found, found, found, [])]


def test_goal_ids_repeat_from_run_to_run() -> None:
    def ids() -> list[Any]:
        world = World()

        def program() -> None:
            rclpy.init()
            actions = ActionClient(Node('n'), Fibonacci, 'fibonacci')
            for _ in range(2):
                actions.send_goal_async(Fibonacci.Goal())
            world.say([bytes(goal_id.uuid).hex() for goal_id in actions._goal_ids.values()])

        return world.run_program(program)

    first = ids()
    assert first == ids()
    assert len(set(first[0])) == 2


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


def test_registering_what_cannot_be_called_names_the_callback(ros: Ros, world: World) -> None:
    def program() -> None:
        server = ActionServer(Node('server'), Fibonacci, 'fib', compute)
        for kind in ('goal', 'cancel', 'handle_accepted'):
            with pytest.raises(TypeError, match=f'^Failed to register {kind.replace("_", " ")} callback: not callable$'):
                getattr(server, f'register_{kind}_callback')(3)
        world.say(server.action_type is Fibonacci)

    assert ros(program) == [True]


def test_feedback_after_a_shutdown_ends_the_execute_callback(world: World) -> None:
    def stubborn(goal_handle: Any) -> Any:
        rclpy.shutdown()
        goal_handle.publish_feedback(Fibonacci.Feedback())
        world.say('not reached')

    assert 'not reached' not in [what for _, what in run(world, server(stubborn), client(world))]
    assert world.tracer.logs[0][2].startswith(
        "Error raised in execute callback: Failed to publish feedback with an action server: publisher's context is invalid"
    )


CREATE = 'Failed to create action '
NAMED = 'due to invalid topic name '


@pytest.mark.parametrize(
    ('name', 'client_text', 'server_text'),
    [
        (
            '1f',
            NAMED + "'1f' : topic name token must not start with a number",
            NAMED + "'1f' : : topic name token must not start with a number",
        ),
        (
            'a/',
            NAMED + "'a/' : topic name must not contain repeated '/'",
            NAMED + "'a/' : : topic name must not contain repeated '/'",
        ),
        ('{x}', NAMED + "'{x}' : unknown substitution: {x}", NAMED + "'{x}' : : unknown substitution: {x}"),
        (
            '~a',
            NAMED + "'~a' : topic name must not have a tilde '~' that is not followed by a forward slash '/'",
            NAMED + "'~a' : : topic name must not have a tilde '~' that is not followed by a forward slash '/'",
        ),
        ('', None, NAMED + "'' : : invalid empty action name"),
        (None, None, None),
    ],
)
def test_wrong_names_of_actions_have_texts_of_their_own(
    ros: Ros, world: World, name: Any, client_text: str | None, server_text: str | None
) -> None:
    def body() -> None:
        node = Node('n')
        for make in (lambda: ActionClient(node, Fibonacci, name), lambda: ActionServer(node, Fibonacci, name, compute)):
            with pytest.raises(ValueError, match=f'^{CREATE}') as caught:
                make()
            world.say((type(caught.value), str(caught.value).removeprefix(CREATE)))

    null = 'action_name argument is null' if name is None else 'failed to get goal service name'
    assert ros(body) == [
        (ValueError, f'client {client_text}' if client_text else f'client: {null}'),
        (ValueError, f'server {server_text}' if server_text else f'server: {null}'),
    ]


def test_after_shutdown_no_actions_are_made(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        rclpy.shutdown()
        for make in (lambda: ActionClient(node, Fibonacci, 'f'), lambda: ActionServer(node, Fibonacci, 'f', compute)):
            with pytest.raises(ValueError, match=CREATE) as caught:
                make()
            world.say(str(caught.value))
        world.say([waitable for waitable in node.waitables if not isinstance(waitable, EventHandler)])

    assert ros(body) == [f"{CREATE}client: rcl node's context is invalid", f"{CREATE}server: rcl node's context is invalid", []]


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

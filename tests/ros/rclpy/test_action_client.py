"""rclpy.action.client."""

from __future__ import annotations

from typing import Any

import pytest
import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.event_handler import EventHandler
from rclpy.node import Node

from .conftest import Ros, World
from .fibonacci import compute, run, server


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


def test_a_quiet_action_client_is_nothing_to_execute(ros: Ros, world: World) -> None:
    def body() -> None:
        node = Node('n')
        ActionClient(node, Fibonacci, 'fibonacci')
        node.create_timer(0.1, lambda: world.say('tick'))
        rclpy.spin_once(node)

    assert ros(body) == ['tick']


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

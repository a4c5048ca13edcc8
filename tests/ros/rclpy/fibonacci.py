"""The action tutorial's programs, as functions."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import rclpy
from example_interfaces.action import Fibonacci
from rclpy.action import ActionClient, ActionServer
from rclpy.callback_groups import ReentrantCallbackGroup
from rclpy.executors import MultiThreadedExecutor
from rclpy.node import Node

from edulaunch.engine.sim.sync import sleep

from .conftest import World


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

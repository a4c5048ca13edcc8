"""The action server <turtle>/rotate_absolute."""

from __future__ import annotations

from typing import Any

from rclpy.action import ActionServer, CancelResponse
from rclpy.node import Node
from rclpy.task import Future

from edulaunch.worlds.turtle import Turtle
from turtlesim.action import RotateAbsolute


class RotateAbsoluteServer:
    """Takes every goal and every cancel request at once; the newest goal wins.

    The turning itself is the turtle's update; `goal` is the handle of the goal being followed, or None.
    """

    def __init__(self, node: Node, turtle: Turtle) -> None:
        self.goal: Any = None
        self._turtle = turtle
        self._log = node.get_logger()
        self._numbers: Any = None
        self._result: Any = None
        self._results: dict[bytes, Future] = {}  # by goal id: done when the goal has ended
        self._server = ActionServer(
            node,
            RotateAbsolute,
            f'{turtle.name}/rotate_absolute',
            self._execute,
            handle_accepted_callback=self._on_accepted,
            cancel_callback=_accept_cancel,
        )

    def destroy(self) -> None:
        """Take the action off the graph."""
        self._server.destroy()

    def cancel_if_asked(self) -> None:
        """Before an update: end the goal as canceled, and the motion, when its client asked for that."""
        if self.goal.is_cancel_requested:
            self._log.info('Rotation goal canceled')
            self.goal.canceled()
            self._end()
            self._turtle.stop()

    def report(self) -> None:
        """After an update: publish the feedback, and the success when the turtle is there."""
        if self.goal is None:
            return
        numbers = self._numbers
        self._result.delta = numbers.delta
        self.goal.publish_feedback(RotateAbsolute.Feedback(remaining=numbers.remaining))
        if self._turtle.turned:
            self._log.info('Rotation goal completed successfully')
            self.goal.succeed()
            self._end()

    def abort(self) -> None:
        """End the goal as aborted, with the result so far."""
        self.goal.abort()
        self._end()

    def _on_accepted(self, goal: Any) -> None:
        if self.goal is not None:
            self._log.warning('Rotation goal received before a previous goal finished. Aborting previous goal')
            self.abort()
        self.goal = goal
        self._result = RotateAbsolute.Result()
        self._results[_key(goal)] = Future()
        self._numbers = self._turtle.rotate_to(goal.request.theta)
        goal.execute()

    async def _execute(self, goal: Any) -> Any:
        result = await self._results[_key(goal)]
        del self._results[_key(goal)]
        return result

    def _end(self) -> None:
        ended, self.goal = self.goal, None
        self._turtle.rotation = None
        self._results[_key(ended)].set_result(self._result)


def _key(goal: Any) -> bytes:
    return bytes(goal.goal_id.uuid)


def _accept_cancel(goal: Any) -> CancelResponse:
    return CancelResponse.ACCEPT

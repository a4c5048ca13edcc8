"""The topics, the services and the action rotate_absolute of one turtle."""

from __future__ import annotations

from struct import Struct
from typing import Any

from geometry_msgs.msg import Twist
from rclpy.action import ActionServer, CancelResponse
from rclpy.logging import LoggingSeverity
from rclpy.node import Node
from rclpy.task import Future

from edulaunch.engine.worlds.drawing import SIDE, as_float32
from edulaunch.engine.worlds.turtle import Turtle
from turtlesim.action import RotateAbsolute
from turtlesim.msg import Color, Pose
from turtlesim.srv import SetPen, TeleportAbsolute, TeleportRelative


class RotateAbsoluteServer:
    """Accepts every goal and every cancel request immediately. A new goal replaces the previous goal.

    The regular update of the turtle performs the rotation. `goal` is the handle of the current goal, or None.
    """

    def __init__(self, node: Node, turtle: Turtle) -> None:
        self.goal: Any = None
        self._turtle = turtle
        self._log = node.get_logger()
        self._numbers: Any = None
        self._result: Any = None
        self._results: dict[bytes, Future] = {}  # futures by goal id, done when the goal has ended
        self._server = ActionServer(
            node,
            RotateAbsolute,
            f'{turtle.name}/rotate_absolute',
            self._execute,
            handle_accepted_callback=self._on_accepted,
            cancel_callback=_accept_cancel,
        )

    def destroy(self) -> None:
        """Remove the action from the graph."""
        self._server.destroy()

    def cancel_if_asked(self) -> None:
        """Cancel the goal and stop the motion if the client requested it. The node calls this method before each update."""
        if self.goal.is_cancel_requested:
            self._log.info('Rotation goal canceled')
            self.goal.canceled()
            self._end()
            self._turtle.stop()

    def report(self) -> None:
        """Publish the feedback, and the success once the turtle has arrived. The node calls this method after each update."""
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


DEPTH = 7
_POSE = Struct('5f')


class TurtlePorts:
    """Connects a turtle of the world with ROS. All names are relative and begin with the turtle's name."""

    def __init__(self, node: Node, turtle: Turtle) -> None:
        self.turtle = turtle
        self._node = node
        self._log = node.get_logger()
        self._clock = node.get_clock()
        self._debug = self._log.is_enabled_for(LoggingSeverity.DEBUG)
        name = turtle.name
        self._commands = node.create_subscription(Twist, f'{name}/cmd_vel', self._on_command, DEPTH)
        self._commands.rcl_take_wires(self._on_command)
        self._poses = node.create_publisher(Pose, f'{name}/pose', DEPTH)
        self._colors = node.create_publisher(Color, f'{name}/color_sensor', DEPTH)
        self._services = [
            node.create_service(SetPen, f'{name}/set_pen', self._on_set_pen),
            node.create_service(TeleportRelative, f'{name}/teleport_relative', self._on_teleport_relative),
            node.create_service(TeleportAbsolute, f'{name}/teleport_absolute', self._on_teleport_absolute),
        ]
        self._rotation = RotateAbsoluteServer(node, turtle)
        self._publish_pose, self._publish_color = self._poses.send_wire, self._colors.send_wire
        self._resting: tuple[float, ...] | None = None  # the pose that a resting turtle publishes again and again

    def destroy(self) -> None:
        """Remove the turtle from the graph."""
        self._rotation.destroy()
        for service in self._services:
            self._node.destroy_service(service)
        self._node.destroy_publisher(self._colors)
        self._node.destroy_publisher(self._poses)
        self._node.destroy_subscription(self._commands)

    def update(self, now_ns: int) -> None:
        """Update the turtle and publish the results in this order: goal progress, wall, pose, colour.

        The messages for pose and colour are flat, so their wire tuples are created directly. Each turtle needs 62.5 calls a
        second.
        """
        turtle = self.turtle
        rotation = self._rotation
        if rotation.goal is None:
            turtle.update(now_ns)
        else:
            rotation.cancel_if_asked()
            turtle.update(now_ns)
            rotation.report()
        if turtle.wall_hit is not None:
            x, down = turtle.wall_hit
            self._log.warning(f'Oh no! I hit the wall! (Clamping from [x={x:f}, y={down:f}])')
        if not turtle.still:
            pose = _pose_of(turtle)
            self._resting = None
        else:
            pose = self._resting or _pose_of(turtle)
            self._resting = pose
        self._publish_pose(pose)
        self._publish_color(turtle.color)
        if self._debug:
            self._log.debug(f'[{self._node.get_namespace()}]: pos_x: {turtle.x:f} pos_y: {turtle.down:f} theta: {turtle.theta:f}')

    def _on_command(self, twist: tuple[float, ...]) -> None:
        """Follow a velocity command. `twist` is the wire tuple of a Twist, because only the numbers are needed."""
        forward, left, _, _, _, turning = twist
        turtle = self.turtle
        holonomic = (left or turtle.sideways) and self._node.get_parameter('holonomic').value
        turtle.command(forward, turning, self._clock.rcl_now_ns(), left if holonomic else None)
        if self._rotation.goal is not None:
            self._log.warning('Velocity command received during rotation goal. Aborting goal')
            self._rotation.abort()

    def _on_set_pen(self, request: Any, response: Any) -> Any:
        self.turtle.set_pen((request.r, request.g, request.b), request.width, bool(request.off))
        return response

    def _on_teleport_relative(self, request: Any, response: Any) -> Any:
        self.turtle.teleport_relative(request.linear, request.angular)
        return response

    def _on_teleport_absolute(self, request: Any, response: Any) -> Any:
        self.turtle.teleport_absolute(request.x, request.y, request.theta)
        return response


def _pose_of(turtle: Turtle) -> tuple[float, ...]:
    """Return the wire tuple of a Pose: five fields, rounded to 32 bits."""
    speed = turtle.linear_velocity if turtle.sideways else abs(turtle.speed)
    try:
        return _POSE.unpack(_POSE.pack(turtle.x, SIDE - turtle.down, turtle.theta, speed, turtle.turning))
    except OverflowError:
        return tuple(as_float32(value) for value in (turtle.x, turtle.y, turtle.theta, speed, turtle.turning))

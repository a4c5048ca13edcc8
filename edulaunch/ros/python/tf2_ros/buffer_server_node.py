"""The program buffer_server: a buffer that other nodes query with the action tf2_buffer_server."""

from __future__ import annotations

from typing import Any

from rclcpp_like import CppNode, spinning
from rclpy.action import ActionServer, CancelResponse
from rclpy.duration import Duration
from tf2_msgs.action import LookupTransform
from tf2_msgs.msg import TF2Error
from tf2_py import ConnectivityException, ExtrapolationException, InvalidArgumentException, LookupException, TransformException

from tf2_ros.buffer import Buffer
from tf2_ros.transform_listener import TransformListener

CODES: tuple[tuple[type[TransformException], int], ...] = (
    (LookupException, TF2Error.LOOKUP_ERROR),
    (ConnectivityException, TF2Error.CONNECTIVITY_ERROR),
    (ExtrapolationException, TF2Error.EXTRAPOLATION_ERROR),
    (InvalidArgumentException, TF2Error.INVALID_ARGUMENT_ERROR),
    (TransformException, TF2Error.TRANSFORM_ERROR),
)
CHECK_S = 0.01


class BufferServer(CppNode):
    """Serves lookups. It repeats waiting lookups every 10 ms, until they succeed or time out."""

    def __init__(self) -> None:
        super().__init__('tf_buffer')
        seconds = self.declare_parameter('buffer_size', 120.0).value
        self.buffer = Buffer(cache_time=Duration(seconds=seconds), node=self)
        self.listener = TransformListener(self.buffer, self)
        self.waiting: list[tuple[Any, int]] = []  # goal handles with their deadlines in ns
        self.results: dict[bytes, Any] = {}
        self.server = ActionServer(
            self,
            LookupTransform,
            'tf2_buffer_server',
            self.give_result,
            handle_accepted_callback=self.take,
            cancel_callback=lambda _: CancelResponse.ACCEPT,
        )
        self.create_timer(CHECK_S, self.check)

    def take(self, handle: Any) -> None:
        """Accept a new goal. Reply immediately if the transform is known or the goal has no timeout."""
        now_ns = self.get_clock().now().nanoseconds
        timeout_ns = Duration.from_msg(handle.request.timeout).nanoseconds
        result = self.look_up(handle.request)
        if timeout_ns <= 0 or result.error.error == TF2Error.NO_ERROR:
            self.finish(handle, result)
        else:
            self.waiting.append((handle, now_ns + timeout_ns))

    def check(self) -> None:
        """Repeat the lookups of the waiting goals."""
        now_ns = self.get_clock().now().nanoseconds
        waiting, self.waiting = self.waiting, []
        for handle, deadline_ns in waiting:
            result = self.look_up(handle.request)
            if result.error.error == TF2Error.NO_ERROR or now_ns >= deadline_ns or handle.is_cancel_requested:
                self.finish(handle, result, late=True)
            else:
                self.waiting.append((handle, deadline_ns))

    def finish(self, handle: Any, result: Any, late: bool = False) -> None:
        """Store the result of a goal and execute the goal. With a late error, the goal is aborted; otherwise, it succeeds."""
        failed = late and result.error.error != TF2Error.NO_ERROR
        self.results[bytes(handle.goal_id.uuid)] = (result, failed)
        handle.execute()

    def give_result(self, handle: Any) -> Any:
        """Return the result of a goal. The action server calls this method after :meth:`finish`."""
        result, failed = self.results.pop(bytes(handle.goal_id.uuid))
        if handle.is_cancel_requested:
            handle.canceled()
        elif failed:
            handle.abort()
        else:
            handle.succeed()
        return result

    def look_up(self, goal: Any) -> Any:
        """Return the result of a goal's lookup. Errors are part of the result."""
        result = LookupTransform.Result()
        try:
            if goal.advanced:
                result.transform = self.buffer.lookup_transform_full_core(
                    goal.target_frame, goal.target_time, goal.source_frame, goal.source_time, goal.fixed_frame
                )
            else:
                result.transform = self.buffer.lookup_transform_core(goal.target_frame, goal.source_frame, goal.source_time)
        except TransformException as error:
            result.error.error = next(code for kind, code in CODES if isinstance(error, kind))
            result.error.error_string = str(error)
        return result


main = spinning(BufferServer)

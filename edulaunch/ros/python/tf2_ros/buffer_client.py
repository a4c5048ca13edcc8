"""A client that looks transforms up in the buffer of another node, with an action."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING, Any

from rclpy.action import ActionClient
from rclpy.duration import Duration
from rclpy.time import Time
from tf2_msgs.action import LookupTransform
from tf2_msgs.msg import TF2Error
from tf2_py import (
    ConnectivityException,
    ExtrapolationException,
    InvalidArgumentException,
    LookupException,
    TimeoutException,
    TransformException,
)

from edulaunch.engine.sim.sync import sleep
from edulaunch.engine.sim.task import current_task
from tf2_ros.buffer_interface import NO_WAIT, BufferInterface

if TYPE_CHECKING:
    from rclpy.node import Node

PADDING = Duration(seconds=2.0)
_EXCEPTIONS: dict[int, type[TransformException]] = {
    TF2Error.LOOKUP_ERROR: LookupException,
    TF2Error.CONNECTIVITY_ERROR: ConnectivityException,
    TF2Error.EXTRAPOLATION_ERROR: ExtrapolationException,
    TF2Error.INVALID_ARGUMENT_ERROR: InvalidArgumentException,
    TF2Error.TIMEOUT_ERROR: TimeoutException,
}


class BufferClient(BufferInterface):
    """Sends lookups to a buffer server instead of storing transforms. Another thread must spin the node.

    :param ns: the name of the server's action.
    :param check_frequency: how often to check for the reply, in Hz.
    :param timeout_padding: how long to wait for the reply after the timeout of the lookup, as a Duration.
    """

    def __init__(self, node: Node, ns: str, *, check_frequency: float = 10.0, timeout_padding: Duration = PADDING) -> None:
        super().__init__()
        self.node = node
        self.action_client = ActionClient(node, LookupTransform, action_name=ns)
        self.check_frequency = check_frequency
        self.timeout_padding = timeout_padding

    def destroy(self) -> None:
        """Destroy the action client. No lookup is possible afterwards."""
        self.action_client.destroy()

    def lookup_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT) -> Any:
        """Return a transform; see :meth:`tf2_ros.Buffer.lookup_transform`.

        :raises TimeoutException: when there is no server, or it did not reply in time.
        """
        goal = LookupTransform.Goal(
            target_frame=target_frame,
            source_frame=source_frame,
            advanced=False,
            source_time=_time_message(time),
            timeout=timeout.to_msg(),
        )
        return self._ask(goal)

    def lookup_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> Any:
        """Return a transform; see :meth:`tf2_ros.Buffer.lookup_transform_full`."""
        goal = LookupTransform.Goal(
            target_frame=target_frame,
            target_time=_time_message(target_time),
            source_frame=source_frame,
            source_time=_time_message(source_time),
            fixed_frame=fixed_frame,
            advanced=True,
            timeout=timeout.to_msg(),
        )
        return self._ask(goal)

    def can_transform(self, target_frame: str, source_frame: str, time: Any, timeout: Duration = NO_WAIT) -> bool:
        """Return whether :meth:`lookup_transform` succeeds."""
        try:
            self.lookup_transform(target_frame, source_frame, time, timeout)
        except TransformException:
            return False
        return True

    def can_transform_full(
        self,
        target_frame: str,
        target_time: Any,
        source_frame: str,
        source_time: Any,
        fixed_frame: str,
        timeout: Duration = NO_WAIT,
    ) -> bool:
        """Return whether :meth:`lookup_transform_full` succeeds."""
        try:
            self.lookup_transform_full(target_frame, target_time, source_frame, source_time, fixed_frame, timeout)
        except TransformException:
            return False
        return True

    def _ask(self, goal: Any) -> Any:
        if not self.action_client.server_is_ready():
            raise TimeoutException('The BufferServer is not ready.')
        wait_ns = Duration.from_msg(goal.timeout).nanoseconds + self.timeout_padding.nanoseconds
        deadline_ns = current_task().sim.now_ns + wait_ns
        handle = self._result_of(self.action_client.send_goal_async(goal), deadline_ns)
        if not handle.accepted:
            raise TimeoutException(
                'The LookupTransform goal sent to the BufferServer did not come back with accepted '
                'status. Something is wrong with the server.'
            )
        result = self._result_of(handle.get_result_async(), deadline_ns).result
        if result.error.error != TF2Error.NO_ERROR:
            raise _EXCEPTIONS.get(result.error.error, TransformException)(result.error.error_string)
        return result.transform

    def _result_of(self, future: Any, deadline_ns: int) -> Any:
        sim = current_task().sim
        while not future.done():
            if sim.now_ns >= deadline_ns:
                raise TimeoutException(
                    'The LookupTransform goal sent to the BufferServer did not come back in the '
                    'specified time. Something is wrong with the server.'
                )
            sleep(1.0 / self.check_frequency)
        return future.result()


def _time_message(time: Any) -> Any:
    if isinstance(time, Time):
        return time.to_msg()
    if hasattr(time, 'sec') and hasattr(time, 'nanosec'):
        warnings.warn(
            'Passing a builtin_interfaces Time message is deprecated; pass an rclpy.time.Time', UserWarning, stacklevel=3
        )
        return time
    raise TypeError('Must pass a rclpy.time.Time object')

"""One goal of an action server: its states and transitions."""

from __future__ import annotations

from collections.abc import Callable
from enum import IntEnum
from typing import TYPE_CHECKING, Any

from action_msgs.msg import GoalInfo

from edulaunch.engine.sim.task import current_task
from edulaunch.ros.read_only import ReadOnly
from rclpy._rclpy_pybind11 import RCLError
from rclpy.impl.c_enum import Pybind11IntEnum

if TYPE_CHECKING:
    from rclpy.action.server import ActionServer


class GoalState(IntEnum):
    """The states of a goal, numbered as in action_msgs/GoalStatus."""

    UNKNOWN = 0
    ACCEPTED = 1
    EXECUTING = 2
    CANCELING = 3
    SUCCEEDED = 4
    CANCELED = 5
    ABORTED = 6


class GoalEvent(Pybind11IntEnum):
    """The events that change the state of a goal."""

    EXECUTE = 0
    CANCEL_GOAL = 1
    SUCCEED = 2
    ABORT = 3
    CANCELED = 4


ACTIVE = (GoalState.ACCEPTED, GoalState.EXECUTING, GoalState.CANCELING)

_TRANSITIONS = {
    (GoalState.ACCEPTED, GoalEvent.EXECUTE): GoalState.EXECUTING,
    (GoalState.ACCEPTED, GoalEvent.CANCEL_GOAL): GoalState.CANCELING,
    (GoalState.EXECUTING, GoalEvent.CANCEL_GOAL): GoalState.CANCELING,
    (GoalState.EXECUTING, GoalEvent.SUCCEED): GoalState.SUCCEEDED,
    (GoalState.EXECUTING, GoalEvent.ABORT): GoalState.ABORTED,
    (GoalState.CANCELING, GoalEvent.SUCCEED): GoalState.SUCCEEDED,
    (GoalState.CANCELING, GoalEvent.ABORT): GoalState.ABORTED,
    (GoalState.CANCELING, GoalEvent.CANCELED): GoalState.CANCELED,
}


def state_after(state: GoalState, event: GoalEvent) -> GoalState:
    """Return the state after an event. Raise RCLError if the event is not possible in this state."""
    following = _TRANSITIONS.get((state, event))
    if following is None:
        raise RCLError(
            'Failed to update goal state: goal_handle attempted invalid transition '
            f'from state {state.name} with event {event.name}'
        )
    return following


class ServerGoalHandle:
    """The argument of an execute callback. It has the goal's `request`, and methods that send feedback and end the goal."""

    def __init__(self, action_server: ActionServer, goal_id: Any, stamp: Any, goal_request: Any) -> None:
        self._action_server = action_server
        self._goal_id = goal_id
        self._stamp = stamp
        self._goal_request = goal_request
        self._state = GoalState.ACCEPTED
        self._ended_ns = 0
        self._destroyed = False

    def __eq__(self, other: object) -> bool:
        return isinstance(other, ServerGoalHandle) and bytes(self._goal_id.uuid) == bytes(other._goal_id.uuid)

    def __hash__(self) -> int:
        return hash(bytes(self._goal_id.uuid))

    request: ReadOnly[Any] = ReadOnly('The goal message.', '_goal_request')

    goal_id: ReadOnly[Any] = ReadOnly("The goal's id, a unique_identifier_msgs/UUID.", '_goal_id')

    @property
    def is_active(self) -> bool:
        """Whether the goal has not ended."""
        return self._state in ACTIVE and not self._destroyed

    @property
    def is_cancel_requested(self) -> bool:
        """Whether the server has accepted a request to cancel the goal."""
        current_task().poll()
        return self._state is GoalState.CANCELING

    @property
    def status(self) -> int:
        """The state of the goal as a number of action_msgs/GoalStatus, or UNKNOWN for a dropped goal."""
        return int(GoalState.UNKNOWN if self._destroyed else self._state)

    def _update_state(self, event: GoalEvent) -> None:
        if self._destroyed:
            return
        self._state = state_after(self._state, event)
        if self._state not in ACTIVE:
            self._ended_ns = self._action_server.rcl_now_ns()
        self._action_server.rcl_goal_changed()

    def execute(self, execute_callback: Callable[[ServerGoalHandle], Any] | None = None) -> None:
        """Make the executor execute the goal."""
        if not self.is_cancel_requested:
            self._update_state(GoalEvent.EXECUTE)
        self._action_server.notify_execute(self, execute_callback)

    def publish_feedback(self, feedback: Any) -> None:
        """Send feedback.

        :raises TypeError: when `feedback` is not an `ActionType.Feedback`.
        :raises RCLError: when ROS 2 is shut down, for example by Ctrl-C while the goal is executed.
        """
        self._action_server.rcl_send_feedback(self, feedback)

    def succeed(self) -> None:
        """End the goal with the state SUCCEEDED. The execute callback returns the result.

        :raises RCLError: when the current state does not allow the transition.
        """
        self._update_state(GoalEvent.SUCCEED)

    def abort(self) -> None:
        """End the goal with the state ABORTED; see :meth:`succeed`."""
        self._update_state(GoalEvent.ABORT)

    def canceled(self) -> None:
        """End the goal with the state CANCELED; see :meth:`succeed`. Raise RCLError unless a cancel request was accepted."""
        self._update_state(GoalEvent.CANCELED)

    def destroy(self) -> None:
        """Delete the goal."""
        self._destroyed = True


def goal_info(goal: ServerGoalHandle) -> Any:
    """Return the goal's ID and time of acceptance as action_msgs/GoalInfo."""
    return GoalInfo(goal_id=goal.goal_id, stamp=goal._stamp)


def stamp_of(goal: ServerGoalHandle) -> tuple[int, int]:
    """Return the time at which a goal was accepted, as seconds and nanoseconds."""
    return goal._stamp.sec, goal._stamp.nanosec


def has_ended_until(goal: ServerGoalHandle, limit_ns: int) -> bool:
    """Return whether the goal had ended by the given time (in nanoseconds)."""
    return goal._state not in ACTIVE and goal._ended_ns <= limit_ns

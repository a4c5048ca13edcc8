"""The states of a goal and the events that lead from one to another."""

from __future__ import annotations

from enum import IntEnum

from rclpy._rclpy_pybind11 import RCLError


class GoalState(IntEnum):
    """The states, numbered as in action_msgs/GoalStatus."""

    UNKNOWN = 0
    ACCEPTED = 1
    EXECUTING = 2
    CANCELING = 3
    SUCCEEDED = 4
    CANCELED = 5
    ABORTED = 6


class GoalEvent(IntEnum):
    """What happens to a goal."""

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
    """The state that an event leads to. Raises RCLError when it cannot happen in this state."""
    following = _TRANSITIONS.get((state, event))
    if following is None:
        raise RCLError(
            'Failed to update goal state: goal_handle attempted invalid transition '
            f'from state {state.name} with event {event.name}'
        )
    return following

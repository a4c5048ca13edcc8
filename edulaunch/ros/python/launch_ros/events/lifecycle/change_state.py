"""The event `ChangeState`."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING, ClassVar

from launch._bases import ReadOnly
from launch.event import Event

if TYPE_CHECKING:
    from ...actions.lifecycle_node import LifecycleNode


class ChangeState(Event):
    """Requests a transition of the lifecycle nodes that the matcher selects.

    :param lifecycle_node_matcher: a function that is called with each LifecycleNode action. It returns whether the request is for
        the node of that action.
    :param transition_id: a constant of lifecycle_msgs.msg.Transition.
    :raises ValueError: for any other number; the message lists the valid numbers.
    """

    name = 'launch_ros.events.lifecycle.ChangeState'
    valid_states: ClassVar[dict[int, str]] = {
        0: 'PRIMARY_STATE_UNKNOWN',
        1: 'PRIMARY_STATE_UNCONFIGURED',
        2: 'PRIMARY_STATE_INACTIVE',
        3: 'PRIMARY_STATE_ACTIVE',
        4: 'PRIMARY_STATE_FINALIZED',
        10: 'TRANSITION_STATE_CONFIGURING',
        11: 'TRANSITION_STATE_CLEANINGUP',
        12: 'TRANSITION_STATE_SHUTTINGDOWN',
        13: 'TRANSITION_STATE_ACTIVATING',
        14: 'TRANSITION_STATE_DEACTIVATING',
        15: 'TRANSITION_STATE_ERRORPROCESSING',
    }
    valid_transitions: ClassVar[dict[int, str]] = {
        1: 'TRANSITION_CONFIGURE',
        2: 'TRANSITION_CLEANUP',
        3: 'TRANSITION_ACTIVATE',
        4: 'TRANSITION_DEACTIVATE',
        5: 'TRANSITION_UNCONFIGURED_SHUTDOWN',
        6: 'TRANSITION_INACTIVE_SHUTDOWN',
        7: 'TRANSITION_ACTIVE_SHUTDOWN',
    }

    def __init__(self, *, lifecycle_node_matcher: Callable[[LifecycleNode], bool], transition_id: int) -> None:
        super().__init__()
        if transition_id not in self.valid_transitions:
            valid = ', '.join(f'{name} ({number})' for number, name in self.valid_transitions.items())
            raise ValueError(f"transition_id '{transition_id}' is not one of the valid transitions: {valid}")
        self.__lifecycle_node_matcher = lifecycle_node_matcher
        self.__transition_id = transition_id

    lifecycle_node_matcher: ReadOnly[Callable[[LifecycleNode], bool]] = ReadOnly('The function that selects the nodes.')
    transition_id: ReadOnly[int] = ReadOnly('The requested transition.')

"""The event `StateTransition`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly
from launch.event import Event

if TYPE_CHECKING:
    from lifecycle_msgs.msg import TransitionEvent

    from ...actions.lifecycle_node import LifecycleNode


class StateTransition(Event):
    """Emitted when a lifecycle node has made a transition.

    :param action: the LifecycleNode action of the node.
    :param msg: the message that the node published on `transition_event`.
    """

    name = 'launch_ros.events.lifecycle.StateTransition'

    def __init__(self, *, action: LifecycleNode, msg: TransitionEvent) -> None:
        super().__init__()
        self.__action = action
        self.__msg: Any = msg

    action: ReadOnly[LifecycleNode] = ReadOnly('The LifecycleNode action of the node.')

    @property
    def msg(self) -> TransitionEvent:
        """The message that the node published."""
        msg: TransitionEvent = self.__msg
        return msg

    @property
    def timestamp(self) -> int:
        """The time of the message, in nanoseconds."""
        return int(self.__msg.timestamp)

    @property
    def transition(self) -> str:
        """The label of the transition."""
        return str(self.__msg.transition.label)

    @property
    def start_state(self) -> str:
        """The label of the previous state."""
        return str(self.__msg.start_state.label)

    @property
    def goal_state(self) -> str:
        """The label of the new state."""
        return str(self.__msg.goal_state.label)

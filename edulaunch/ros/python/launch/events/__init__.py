"""What can happen in a running launch."""

from __future__ import annotations

from collections.abc import Callable
from typing import TYPE_CHECKING

from .._bases import ReadOnly, StableRepr
from .._lazy import has_ros_paths, lazy_exports

if TYPE_CHECKING:
    from ..action import Action
    from ..actions.timer_action import TimerAction
    from ..launch_description import LaunchDescription


class Event(StableRepr):
    """Something that happened, or that somebody wants to happen, in a running launch."""

    name = 'launch.Event'


class ExecutionComplete(Event):
    """Emitted after an action's `execute`, or when its future is done. For a process: when it has ended."""

    name = 'launch.events.ExecutionComplete'

    def __init__(self, *, action: Action) -> None:
        self.__action = action

    action: ReadOnly[Action] = ReadOnly('The action.')


class IncludeLaunchDescription(Event):
    """Emitted by `LaunchService.include_launch_description`."""

    name = 'launch.events.IncludeLaunchDescription'

    def __init__(self, launch_description: LaunchDescription) -> None:
        self.__launch_description = launch_description

    launch_description: ReadOnly[LaunchDescription] = ReadOnly('The description.')


class Shutdown(Event):
    """Ends the whole launch: processes get signals, timers are cancelled, nothing new is started.

    :param reason: for people, and for `LocalSubstitution('event.reason')`.
    :param due_to_sigint: the user pressed ctrl-c, so a terminal has told the processes already.
    """

    name = 'launch.events.Shutdown'

    def __init__(self, *, reason: str = 'reason not given', due_to_sigint: bool = False) -> None:
        self.__reason = reason
        self.__due_to_sigint = due_to_sigint

    reason: ReadOnly[str] = ReadOnly('Why.')
    due_to_sigint: ReadOnly[bool] = ReadOnly('Whether ctrl-c was pressed.')


class TimerEvent(Event):
    """Emitted by a `TimerAction` after its period."""

    name = 'launch.events.TimerEvent'

    def __init__(self, *, timer_action: TimerAction) -> None:
        self.__timer_action = timer_action

    timer_action: ReadOnly[TimerAction] = ReadOnly('The timer.')


def matches_action(target_action: Action) -> Callable[[Action], bool]:
    """A matcher for exactly this action."""
    return lambda action: action is target_action


__getattr__, __dir__ = lazy_exports(__name__, {'': 'process'})
has_ros_paths(__name__)
has_ros_paths(__name__, 'ExecutionComplete IncludeLaunchDescription Shutdown TimerEvent matches_action=matchers')

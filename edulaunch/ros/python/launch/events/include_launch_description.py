"""The event `IncludeLaunchDescription`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._bases import ReadOnly
from ..event import Event

if TYPE_CHECKING:
    from ..launch_description import LaunchDescription


class IncludeLaunchDescription(Event):
    """Emitted by `LaunchService.include_launch_description`."""

    name = 'launch.events.IncludeLaunchDescription'

    def __init__(self, launch_description: LaunchDescription) -> None:
        self.__launch_description = launch_description

    launch_description: ReadOnly[LaunchDescription] = ReadOnly('The description.')

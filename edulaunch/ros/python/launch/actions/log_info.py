"""The action `LogInfo`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from ..action import Action
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class LogInfo(Action):
    """Log a message as `[INFO] [launch.user]: ...`."""

    def __init__(self, *, msg: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__msg = normalize_to_list_of_substitutions(msg)

    msg: ReadOnly[list[Substitution]] = ReadOnly('The message, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Log the message."""
        from ..logging import get_logger

        get_logger('launch.user').info(perform_substitutions(context, self.__msg))

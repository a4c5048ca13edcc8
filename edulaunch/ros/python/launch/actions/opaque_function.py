"""The action `OpaqueFunction`."""

from __future__ import annotations

import collections.abc
from collections.abc import Callable, Iterable
from typing import TYPE_CHECKING, Any

from ..action import Action
from ..launch_description_entity import LaunchDescriptionEntity
from ..utilities.type_utils import ensure_argument_type

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class OpaqueFunction(Action):
    """Call `function(context, *args, **kwargs)` when launch visits this action. Launch then visits the returned entities.

    The function can read launch configurations, so it can build actions from plain Python values. Its result is unknown before
    the call (opaque), so `ros2 launch -s` does not list launch arguments that the function declares.

    :raises TypeError: when `function` is not callable, or `args` or `kwargs` have the wrong type.
    """

    def __init__(
        self,
        *,
        function: Callable[..., Iterable[LaunchDescriptionEntity] | None],
        args: Iterable[Any] | None = None,
        kwargs: dict[str, Any] | None = None,
        **left_over_kwargs: Any,
    ) -> None:
        super().__init__(**left_over_kwargs)
        if not callable(function):
            raise TypeError(f"OpaqueFunction expected a callable for 'function', got '{type(function)}'")
        ensure_argument_type(args, (collections.abc.Iterable, type(None)), 'args', 'OpaqueFunction')
        ensure_argument_type(kwargs, (dict, type(None)), 'kwargs', 'OpaqueFunction')
        self.__function = function
        self.__args = list(args) if args is not None else []
        self.__kwargs = kwargs if kwargs is not None else {}

    def execute(self, context: LaunchContext) -> Iterable[LaunchDescriptionEntity] | None:
        """Call the function, and return its entities."""
        entities = self.__function(context, *self.__args, **self.__kwargs)
        if entities is not None:
            iter(
                entities
            )  # A single entity is a common mistake. Because the check is here, the error has the line of this action.
        return entities

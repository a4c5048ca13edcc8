"""Actions that run code of the launch file, and the one that only says something."""

from __future__ import annotations

import collections.abc
from collections.abc import Callable, Coroutine, Iterable
from typing import TYPE_CHECKING, Any

from .._bases import ReadOnly
from .._lazy import has_ros_paths
from ..action import Action
from ..event_handlers.general import OnShutdown
from ..events import Event
from ..launch_description_entity import LaunchDescriptionEntity
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from ..utilities.type_utils import ensure_argument_type

if TYPE_CHECKING:
    import asyncio

    from ..launch_context import LaunchContext


class OpaqueFunction(Action):
    """Call `function(context, *args, **kwargs)` when visited; the list of entities it returns is visited
    next.

    The function may look at launch configurations, so it can build actions from plain Python values. What it
    returns cannot be known before (hence the name), so launch arguments declared inside are not listed by
    `ros2 launch -s`.

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
        """Call it."""
        entities = self.__function(context, *self.__args, **self.__kwargs)
        if entities is not None:
            iter(entities)  # A single entity is the usual mistake; found here, the error knows this action's line.
        return entities


class OpaqueCoroutine(Action):
    """Run `coroutine(context, *args, **kwargs)` as a task of launch's loop; launch is not idle before it
    ends.

    It is cancelled when the launch is shut down. `asyncio.sleep` in it takes simulated time.

    :param coroutine: a coroutine function (`async def`).
    :param ignore_context: do not pass the context.
    :raises TypeError: when `coroutine` is something else, or another argument has the wrong type.
    """

    def __init__(
        self,
        *,
        coroutine: Callable[..., Coroutine[Any, Any, Any]],
        args: Iterable[Any] | None = None,
        kwargs: dict[str, Any] | None = None,
        ignore_context: bool = False,
        **left_over_kwargs: Any,
    ) -> None:
        import inspect

        super().__init__(**left_over_kwargs)
        if not inspect.iscoroutinefunction(coroutine):
            raise TypeError(f"OpaqueCoroutine expected a coroutine function for 'coroutine', got '{type(coroutine)}'")
        ensure_argument_type(args, (collections.abc.Iterable, type(None)), 'args', 'OpaqueCoroutine')
        ensure_argument_type(kwargs, (dict, type(None)), 'kwargs', 'OpaqueCoroutine')
        ensure_argument_type(ignore_context, bool, 'ignore_context', 'OpaqueCoroutine')
        self.__coroutine = coroutine
        self.__args = list(args) if args is not None else []
        self.__kwargs = kwargs if kwargs is not None else {}
        self.__ignore_context = ignore_context
        self.__future: asyncio.Task[Any] | None = None

    def __on_shutdown(self, event: Event, context: LaunchContext) -> None:
        if self.__future is not None:
            self.__future.cancel()

    def execute(self, context: LaunchContext) -> None:
        """Start the task."""
        first = [] if self.__ignore_context else [context]
        self.__future = context.asyncio_loop.create_task(self.__coroutine(*first, *self.__args, **self.__kwargs))
        context.register_event_handler(OnShutdown(on_shutdown=self.__on_shutdown))

    def get_asyncio_future(self) -> asyncio.Future[Any] | None:
        """The task."""
        return self.__future


class LogInfo(Action):
    """Write a message: `[INFO] [launch.user]: ...`."""

    def __init__(self, *, msg: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__msg = normalize_to_list_of_substitutions(msg)

    msg: ReadOnly[list[Substitution]] = ReadOnly('The message, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Write it."""
        from ..logging import get_logger

        get_logger('launch.user').info(perform_substitutions(context, self.__msg))


has_ros_paths(__name__)

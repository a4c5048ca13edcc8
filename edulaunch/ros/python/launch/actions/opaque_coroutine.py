"""The action `OpaqueCoroutine`."""

from __future__ import annotations

import collections.abc
from collections.abc import Callable, Coroutine, Iterable
from typing import TYPE_CHECKING, Any

from ..action import Action
from ..event import Event
from ..event_handlers.on_shutdown import OnShutdown
from ..utilities.type_utils import ensure_argument_type

if TYPE_CHECKING:
    import asyncio

    from ..launch_context import LaunchContext


class OpaqueCoroutine(Action):
    """Run `coroutine(context, *args, **kwargs)` as a task of launch's loop. Launch is not idle until the task has ended.

    A shutdown of the launch cancels the task. `asyncio.sleep` in the coroutine takes simulated time.

    :param coroutine: a coroutine function (`async def`).
    :param ignore_context: whether to call the coroutine without the context.
    :raises TypeError: when `coroutine` is not a coroutine function, or another argument has the wrong type.
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
        """Return the task, or None before execution."""
        return self.__future

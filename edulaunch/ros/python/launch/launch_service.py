"""Execute launch descriptions."""

from __future__ import annotations

import collections.abc
import signal
import threading
import traceback
from collections.abc import Awaitable, Coroutine, Generator, Iterable, Iterator
from contextlib import contextmanager
from typing import TYPE_CHECKING, Any

from edulaunch.engine.sim.task import AmbientTask, current_task
from edulaunch.ros.collector_pause import collector_paused
from edulaunch.ros.read_only import ReadOnly

from ._argument_search import looking
from ._beside import StartedThreads, run_beside_tasks, run_beside_threads
from ._engine import new_event_loop, running_process
from ._failure import note_failure
from ._handler_table import Handler
from ._observer import observer_of_launch
from ._origin import note_origin
from .event import Event
from .event_handlers.on_include_launch_description import OnIncludeLaunchDescription
from .event_handlers.on_shutdown import OnShutdown
from .events.include_launch_description import IncludeLaunchDescription
from .events.shutdown import Shutdown
from .launch_context import LaunchContext
from .launch_description_entity import LaunchDescriptionEntity
from .logging import get_logger, launch_config, log_launch_config
from .utilities.entities import visit_all_entities_and_collect_futures
from .utilities.signal_management import AsyncSafeSignalManager

if TYPE_CHECKING:
    import asyncio

    from .launch_description import LaunchDescription

DEBUG = 10


class Done(Coroutine[Any, Any, None]):
    """A coroutine that has already finished. Unlike a coroutine of an `async def`, it can be discarded without a warning."""

    def send(self, value: Any) -> Any:
        """End immediately."""
        raise StopIteration

    def throw(self, typ: Any, val: Any = None, tb: Any = None) -> Any:
        """End with the given exception."""
        raise typ if val is None else val

    def close(self) -> None:
        """Do nothing, because there is nothing to close."""

    def __await__(self) -> Generator[Any, None, None]:
        return
        yield


class LaunchService:
    """Visits launch descriptions, and handles events until nothing is left to do.

    The service uses the time of the running simulation. In a simulated process, :meth:`run` blocks only that process. In a plain
    script, the service runs its own simulation. In a notebook, both `run()` and `await run_async()` work.

    :param argv: the command line arguments, for `context.argv`.
    :param noninteractive: whether no terminal is attached. If so, launch must pass Ctrl-C on to the processes.
    :param debug: whether to log at level DEBUG.
    """

    def __init__(self, *, argv: Iterable[str] | None = None, noninteractive: bool = False, debug: bool = False) -> None:
        if debug:
            launch_config.level = DEBUG
        self.__logger = get_logger('launch')
        self.__context = LaunchContext(argv=argv, noninteractive=noninteractive)
        self.__context.register_event_handler(OnIncludeLaunchDescription())
        self.__context.register_event_handler(OnShutdown(on_shutdown=self.__on_shutdown))
        self.__context.observer = observer_of_launch()
        self.__pending: dict[asyncio.Future[Any], LaunchDescriptionEntity] = {}
        self.__failed: list[tuple[LaunchDescriptionEntity, Exception]] = []
        self.__loop: asyncio.AbstractEventLoop | None = None
        self.__thread = 0
        self.__task: asyncio.Task[Any] | None = None
        self.__news: asyncio.Future[None] | None = None
        self.__started_threads = StartedThreads()
        self.__shutting_down = False
        self.__interrupted = False
        self.__return_code = 0

    context: ReadOnly[LaunchContext] = ReadOnly('The launch context.')

    event_loop: ReadOnly[asyncio.AbstractEventLoop | None] = ReadOnly('The loop of the running service, or None.', '__loop')

    task: ReadOnly[asyncio.Task[Any] | None] = ReadOnly('The task that runs the service, or None.')

    # -- called by other threads and by users

    def include_launch_description(self, launch_description: LaunchDescription) -> None:
        """Execute a description now, or when the service starts to run. Any thread may call this method."""
        self.emit_event(IncludeLaunchDescription(launch_description))

    def emit_event(self, event: Event) -> None:
        """Emit an event, even before the service runs. Any thread may call this method."""
        if self.__loop is None:
            self.__context.emit_event_sync(event)
        else:
            self.__loop.call_soon_threadsafe(self.__context.emit_event_sync, event)

    def shutdown(self, force_sync: bool = False) -> Awaitable[None] | None:
        """Request the end of the service. If the service is not running, do nothing. Any thread may call this method.

        :returns: a coroutine, when called in the thread that runs the service without `force_sync`; otherwise None.
        """
        if self.__loop is None:
            return None
        reason = 'LaunchService.shutdown() called'
        if force_sync:
            self.__shut_down(reason)
            return None
        self.__loop.call_soon_threadsafe(self.__shut_down, reason)
        return Done() if self.__thread == threading.get_ident() else None

    def run(self, *, shutdown_when_idle: bool = True) -> int:
        """Run until the launch has ended. Return 0, or 1 if an exception was caught or the run was cancelled.

        :param shutdown_when_idle: whether to end when no process, timer or event is left.
        :raises RuntimeError: when the service is already running, or in a thread that is not the main thread.
        """
        _check_thread()
        loop = new_event_loop()
        try:
            task = loop.create_task(self.run_async(shutdown_when_idle=shutdown_when_idle))
            while True:
                try:
                    return run_beside_threads(loop, task, self.__started_threads)
                except KeyboardInterrupt:
                    if task.done():
                        task.exception()  # this is the running loop, so no other thread needs a signal
                        raise
                    self.__on_sigint(signal.SIGINT)
        finally:
            _cancel_all_tasks(loop)
            loop.close()

    async def run_async(self, *, shutdown_when_idle: bool = True) -> int:
        """Run like :meth:`run`, as a coroutine. On a loop without simulated time, such as the loop of a notebook, this call
        runs the simulation.
        """
        import asyncio

        from edulaunch.engine.sim.aio import SimulatedEventLoop

        _check_thread()
        loop = asyncio.get_running_loop()
        if not isinstance(loop, SimulatedEventLoop):
            return await self.__run_beside_tasks(shutdown_when_idle)
        if self.__loop is not None:
            raise RuntimeError('LaunchService cannot be run multiple times concurrently.')
        with self.__running_on(loop), AsyncSafeSignalManager(loop) as signals:
            signals.handle(signal.SIGINT, self.__on_sigint)
            log_launch_config(logger=self.__logger)
            try:
                await self.__main_loop(shutdown_when_idle)
            except asyncio.CancelledError:
                self.__logger.error('run task was canceled')
                self.__return_code = 1
        return self.__return_code

    async def __run_beside_tasks(self, shutdown_when_idle: bool) -> int:
        loop = new_event_loop()
        try:
            task = loop.create_task(self.run_async(shutdown_when_idle=shutdown_when_idle))
            return await run_beside_tasks(loop, task, self.__started_threads)
        finally:
            _cancel_all_tasks(loop)
            loop.close()

    @contextmanager
    def __running_on(self, loop: asyncio.AbstractEventLoop) -> Iterator[None]:
        import asyncio

        context = self.__context
        self.__loop, self.__task, self.__thread = loop, asyncio.current_task(), threading.get_ident()
        self.__return_code, self.__shutting_down, self.__interrupted = 0, False, False
        context._set_asyncio_loop(loop)
        context._set_is_shutdown(False)
        context.starts_are_abandoned = False
        context._event_queue.on_put = self.__wake
        try:
            yield
        finally:
            context._event_queue.on_put = None
            context._set_asyncio_loop(None)
            self.__loop = self.__task = None
            self.__pending.clear()

    # The main loop and its tasks

    async def __main_loop(self, shutdown_when_idle: bool) -> None:
        from asyncio import sleep

        queue = self.__context._event_queue
        while True:
            try:
                while not queue.empty():
                    self.__process_event(queue.get_nowait())
                    await sleep(0)
                self.__raise_failure()
                if not self._is_idle():
                    await self.__wait_for_news()
                elif self.__shutting_down:
                    return
                elif shutdown_when_idle:
                    self.__shut_down('idle')
                else:
                    await self.__wait_for_news()
            except Exception as error:
                self.__report(error)

    def _is_idle(self) -> bool:
        """Return whether nothing is left to do. Upstream's tests of launch call this method."""
        waiting = self.__context._completion_futures
        waiting[:] = [future for future in waiting if not future.done()]
        for future in waiting:
            future.remove_done_callback(self.__wake)
            future.add_done_callback(self.__wake)
        return not self.__pending and not waiting and self.__context._event_queue.empty()

    async def __wait_for_news(self) -> None:
        """Wait until an event arrives or a future is done."""
        assert self.__loop is not None
        if not self.__context._event_queue.empty() or self.__failed:
            return
        self.__news = self.__loop.create_future()
        try:
            await self.__news
        finally:
            self.__news = None

    def __wake(self, _: object = None) -> None:
        if self.__news is not None and not self.__news.done():
            self.__news.set_result(None)

    def __process_event(self, event: Event) -> None:
        debug = self.__logger.isEnabledFor(DEBUG)
        if debug:
            self.__logger.debug(f"processing event: '{event}'")
        observer = self.__context.observer
        if observer is not None:
            observer.event(event, self.__context)
        for handler in self.__context.handlers_that_match(event):
            if handler.matches(event) and (observer is None or not observer.ignores(handler, event)):
                if debug:
                    self.__logger.debug(f"processing event: '{event}' ✓ '{handler}'")
                self.__handle(handler, event)

    def __handle(self, handler: Handler, event: Event) -> None:
        context, observer = self.__context, self.__context.observer
        context._push_locals()
        try:
            answer: Any = handler.handle(event, context)
            if observer is None:
                self.__visit_answer(answer)
            else:
                observer.answered(handler, event, answer)
                try:
                    self.__visit_answer(answer)
                finally:
                    observer.handled(handler, event)
        finally:
            context._pop_locals()

    def __visit_answer(self, answer: Any) -> None:
        for entity in answer if isinstance(answer, collections.abc.Iterable) else (answer,):
            if entity is None:
                continue
            if not isinstance(entity, LaunchDescriptionEntity):
                raise RuntimeError(f"expected a LaunchDescriptionEntity from event_handler, got '{entity}'")
            self.__visit(entity)

    def __visit(self, entity: LaunchDescriptionEntity) -> None:
        with collector_paused(), looking():
            pairs = visit_all_entities_and_collect_futures(entity, self.__context)
        on_done = self.__on_done
        for visited, future in pairs:
            self.__pending[future] = visited
            future.add_done_callback(on_done)

    def __on_done(self, future: asyncio.Future[Any]) -> None:
        entity = self.__pending.pop(future, None)
        if entity is not None and not future.cancelled():
            error = future.exception()
            if isinstance(error, Exception):
                self.__failed.append((entity, error))
        self.__wake()

    def __raise_failure(self) -> None:
        if self.__failed:
            entity, error = self.__failed.pop(0)
            note_origin(error, entity)
            raise error

    def __report(self, error: Exception) -> None:
        """Report an error, and end the launch. Processes that have not been started yet are not started."""
        message = f'Caught exception in launch (see debug for traceback): {error}'
        self.__logger.debug(traceback.format_exc())
        note_failure(error, message)
        self.__logger.error(message)
        self.__return_code = 1
        self.__context.starts_are_abandoned = True
        self.__shut_down(message)

    def __shut_down(self, reason: str, due_to_sigint: bool = False) -> None:
        if not self.__shutting_down:
            self.__context.emit_event_sync(Shutdown(reason=reason, due_to_sigint=due_to_sigint))
        self.__shutting_down = True
        self.__context._set_is_shutdown(True)

    def __on_shutdown(self, event: Event, context: LaunchContext) -> None:
        self.__shutting_down = True
        context._set_is_shutdown(True)

    def __on_sigint(self, signum: int) -> None:
        message = 'user interrupted with ctrl-c (SIGINT)'
        if self.__interrupted:
            self.__logger.warning(f'{message} again, ignoring...')
            return
        self.__interrupted = True
        self.__logger.warning(message)
        self.__shut_down('ctrl-c (SIGINT)', due_to_sigint=True)


def _check_thread() -> None:
    """Raise an error outside the main thread. This is the real main thread of a plain script, or the first task of a
    simulated process.
    """
    task = running_process().lifecycle.task
    in_main = threading.current_thread() is threading.main_thread() or not isinstance(task, AmbientTask)
    if not in_main or current_task() is not task:
        raise RuntimeError('LaunchService can only be run in the main thread.')


def _cancel_all_tasks(loop: asyncio.AbstractEventLoop) -> None:
    """Cancel the remaining tasks of a failed or interrupted launch, as `asyncio.run` does."""
    from edulaunch.engine.sim.loops import cancel_all_tasks

    cancel_all_tasks(loop)

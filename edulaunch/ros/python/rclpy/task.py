"""Futures, and the tasks in which executors run coroutines."""

from __future__ import annotations

import sys
from collections.abc import Callable, Coroutine, Generator
from functools import partial
from typing import TYPE_CHECKING, Any
from warnings import warn
from weakref import ref

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.frame_owner import coroutine_line
from edulaunch.engine.sim.task import current_task

if TYPE_CHECKING:
    from rclpy.impl.entity import Entity
    from rclpy.impl.protocols import ExecutorProtocol


class _UnfetchedException:
    """Reports an exception that the program never read, when the future of the exception is deleted.

    This is a separate object, because few futures need it, and an object with `__del__` takes longer to create and delete.
    """

    __slots__ = ('exception', 'stream')

    def __init__(self, exception: BaseException) -> None:
        self.exception: BaseException | None = exception
        self.stream = current_process().streams.stderr  # not found any more when Python ends

    def __del__(self) -> None:
        if self.exception is not None and sys is not None:
            print('The following exception was never retrieved: ' + str(self.exception), file=self.stream)


class Future:
    """The result of a service call, a goal or a task, which may not exist yet.

    The executor of the future runs the callbacks. A future without an executor calls the callbacks itself, immediately.
    """

    # Programs create thousands of futures and tasks, so values that rarely change are class attributes.
    _done = False
    _cancelled = False
    rcl_ended = False  # either a future or a task
    _result: Any = None
    _exception: BaseException | None = None
    _unfetched: _UnfetchedException | None = None
    _executor: ExecutorProtocol | None = None
    _awaiting: tuple[ExecutorProtocol, ...] = ()
    _source: Any = None  # the client that will set the result
    _looks: tuple[Any, int, int] = (None, 0, 0)

    def __init__(self, *, executor: ExecutorProtocol | None = None) -> None:
        self._callbacks: list[Callable[[Any], object]] = []
        if executor is not None:
            ref(executor)  # raise TypeError for an object that is not an executor, as ROS 2 does
            self._executor = executor

    def __await__(self) -> Generator[Any, None, Any]:
        while not self.rcl_ended:
            self._asyncio_future_blocking = True
            yield self
        return self.result()

    _asyncio_future_blocking = False
    """An attribute that asyncio's tasks require. With it, a coroutine of an asyncio loop can await this future."""

    def get_loop(self) -> Any:
        """Return the running asyncio loop whose task awaits this future."""
        from asyncio import get_running_loop

        return get_running_loop()

    def cancel(self, msg: object = None) -> None:
        """Cancel the future if it is not done. `done()` stays False, but all waits for the future end, and `await` returns
        None.
        """
        if not self._done:
            self._cancelled = self.rcl_ended = True
            self._over()

    def cancelled(self) -> bool:
        """Return whether the future was cancelled."""
        return self._cancelled

    def done(self) -> bool:
        """Return whether the future has a result or an exception. Repeated calls make simulated time pass."""
        if not self._done:
            current_task().poll()
            if self._source is not None:
                self._count_look(self._source)
        return self._done

    def _count_look(self, source: Any) -> None:
        """Record a deadlock if a callback repeatedly checks a future that cannot be done before the callback ends."""
        executor = source.ready_list.executor
        turn = None if executor is None else executor.rcl_cannot_serve(source)
        if turn is None:
            return
        from rclpy.impl.facts import POLLS, note_wait

        now = current_task().sim.now_ns
        last_turn, looks, last_ns = self._looks
        looks = looks + (now > last_ns) if turn == last_turn else 0
        self._looks = turn, looks, now
        if looks == POLLS:
            note_wait('look', source)

    def result(self) -> Any:
        """Return the result, or None before the future is done. Raise the exception if the future has one."""
        if self._exception is not None:
            raise self._fetched(self._exception)
        if not self._done:
            current_task().poll()
        return self._result

    def exception(self) -> BaseException | None:
        """Return the exception of the future, or None if it has not failed."""
        return None if self._exception is None else self._fetched(self._exception)

    def _fetched(self, exception: BaseException) -> BaseException:
        if self._unfetched is not None:
            self._unfetched.exception = None
            self._unfetched = None
        return exception

    def set_result(self, result: Any) -> None:
        """Set the result. The future is then done."""
        self._result = result
        self._end()

    def set_exception(self, exception: BaseException) -> None:
        """Set the exception. The future is then done."""
        self._exception = exception
        self._unfetched = _UnfetchedException(exception)
        self._end()

    def _end(self) -> None:
        self._done = self.rcl_ended = True
        self._cancelled = False
        if self._callbacks or self._awaiting:
            self._over()

    def _over(self) -> None:
        if self._callbacks:
            self._call_back()
        if self._awaiting:
            awaiting, self._awaiting = self._awaiting, ()
            for executor in awaiting:
                executor.wake()

    def rcl_wake_when_done(self, executor: ExecutorProtocol) -> None:
        """Wake an executor when the future is done."""
        if executor not in self._awaiting:
            self._awaiting += (executor,)

    def _call_back(self) -> None:
        callbacks = self._callbacks
        if not callbacks:
            return
        self._callbacks = []
        if self._executor is not None:
            for callback in callbacks:
                self._executor.create_task(callback, self)
            return
        for callback in callbacks:
            try:
                callback(self)
            except Exception as error:
                warn(f'Unhandled exception in done callback: {error}', stacklevel=2)

    def _set_executor(self, executor: ExecutorProtocol | None) -> None:
        """Make this executor run the callbacks."""
        self._executor = executor

    def add_done_callback(self, callback: Callable[[Any], object], *, context: Any = None) -> None:
        """Call `callback(future)` when the future is done or cancelled. If the future is already done or cancelled, call
        `callback` soon.

        :param context: the context of the asyncio task that awaits this future. The loop of that task is notified.
        """
        if context is not None:
            loop, function = self.get_loop(), callback
            callback = lambda future: loop.call_soon_threadsafe(function, future, context=context)  # noqa: E731
        if not self.rcl_ended:
            self._callbacks.append(callback)
        elif self._executor is not None:
            self._executor.create_task(callback, self)
        else:
            callback(self)

    def remove_done_callback(self, callback: Callable[[Any], object]) -> bool:
        """Remove one registration of `callback`. Return whether there was one."""
        if callback not in self._callbacks:
            return False
        self._callbacks.remove(callback)
        return True


class Task(Future):
    """A function or coroutine that an executor runs. A coroutine that waits continues at each turn.

    Calling the task runs it until it waits or ends. The return value of the function is the result of the task.

    :param entity: the entity whose callback the task runs.
    """

    _executing = False
    _running: Coroutine[Any, Any, Any] | None = None

    def __init__(
        self,
        handler: Any,
        args: Any = None,
        kwargs: Any = None,
        executor: ExecutorProtocol | None = None,
        entity: Entity | None = None,
    ) -> None:
        self._callbacks = []
        self._executor = executor
        self._args = args or ()
        self._kwargs = kwargs or {}
        self._handler = handler
        self._entity = entity
        if is_coroutine_function(handler):
            self._running = handler(*self._args, **self._kwargs)
        elif not callable(handler) and hasattr(handler, 'send') and hasattr(handler, 'throw'):
            self._running = handler

    def __call__(self) -> None:
        """Start or continue the task."""
        if self.rcl_ended or self._executing:
            return
        self._executing = True
        try:
            if self._running is None:
                self._result = self._handler(*self._args, **self._kwargs)
                self._end()
            else:
                self._run_on(self._running)
        except Exception as error:
            self.set_exception(error)
        finally:
            self._executing = False

    def _run_on(self, coroutine: Coroutine[Any, Any, Any]) -> None:
        try:
            awaited = coroutine.send(None)
        except StopIteration as end:
            self.set_result(end.value)
            return
        if isinstance(awaited, Future) and self._executor is not None and self._executor not in awaited._awaiting:
            awaited.rcl_wake_when_done(self._executor)
            if self._entity is not None and awaited._source is not None:
                self._note_deadlock(self._entity, awaited._source)

    def _note_deadlock(self, entity: Entity, source: Any) -> None:
        """Record a deadlock: a waiting callback blocks its group, so a client of the same group receives no reply."""
        if source.callback_group is entity.callback_group and source.callback_group.busy_with is entity:
            from rclpy.impl.facts import note_wait

            note_wait('await', source, coroutine_line(self._running))

    def rcl_raise_if_failed(self) -> None:
        """Raise the exception of the task, if there is one."""
        if self._exception is not None:
            self.result()

    def executing(self) -> bool:
        """Return whether the task is running now."""
        return self._executing

    def cancel(self, msg: object = None) -> None:
        """Cancel the task. If its coroutine is waiting, the coroutine is closed."""
        super().cancel()
        if self._running is not None and not self._executing:
            self._running.close()


def future_answer(source: Any) -> Future:
    """Return a future for the reply that a client waits for.

    :param source: the client that waits.
    """
    future = Future()
    future._source = source
    return future


def source_of(future: Any) -> Any:
    """Return the client for whose reply a future waits, or None if the future waits for something else."""
    return getattr(future, '_source', None)


_COROUTINE_FLAG = 0x80


def is_coroutine_function(function: Any) -> bool:
    """Return whether calling an object creates a coroutine (`async def`), also for methods and `functools.partial`."""
    while isinstance(function, partial):
        function = function.func
    code = getattr(function, '__code__', None)
    return code is not None and code.co_flags & _COROUTINE_FLAG != 0


async def await_or_execute(callback: Callable[..., Any], *args: Any) -> Any:
    """Call a function or await an `async def` function, and return its result. Custom executors and waitables use it."""
    result = callback(*args)
    return await result if is_coroutine_function(callback) else result

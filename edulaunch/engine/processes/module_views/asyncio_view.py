"""`asyncio` in simulated time: every event loop of a program is simulated."""

from __future__ import annotations

import asyncio as real
import re
from collections.abc import Callable, Coroutine, Iterator
from itertools import count
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.processes.module_views import copy_names
from edulaunch.engine.sim.aio import SimulatedEventLoop
from edulaunch.engine.sim.loops import cancel_all_tasks
from edulaunch.engine.sim.task import Task, current_task

if TYPE_CHECKING:
    from edulaunch.engine.processes.process import Process

OUR_CALLBACK = re.compile(r' cb=\[_threadsafe\.[^]]*\]')
"""A part of a task's representation, which shows that another thread waits for it; asyncio itself would use another one."""


class ProcessEventLoop(SimulatedEventLoop):
    """A simulated event loop of one program. Its executor threads are threads of the program, and all loops share one task
    counter.
    """

    def __init__(self, process: Process, task: Task) -> None:
        super().__init__(task)
        self._process = process
        self._numbers: Iterator[int] = process.state.setdefault('asyncio tasks', count(1))
        process.lifecycle.at_exit.append(self._tell_what_is_pending)

    def create_task(self, coro: Any, *, name: object = None, **options: Any) -> Any:
        """Create an asyncio task. Without a name, the task is called `Task-N`, where N counts the tasks of this program."""
        return super().create_task(coro, name=f'Task-{next(self._numbers)}' if name is None else str(name), **options)

    def _tell_what_is_pending(self) -> None:
        """Print Python's messages about pending tasks at the end of the program. A killed program prints nothing."""
        for task in sorted(real.all_tasks(self), key=lambda task: task.get_name()):
            task._log_destroy_pending = False  # type: ignore[attr-defined]  # otherwise Python reports the task later
            if (self._process.returncode or 0) >= 0:
                shown = OUR_CALLBACK.sub('', repr(task))
                self._process.write('stderr', f'Task was destroyed but it is pending!\ntask: {shown}\n')

    def run_in_executor(self, executor: Any, func: Callable[..., Any], *args: Any) -> Any:  # type: ignore[override]
        """Run a blocking function in another thread of the program, and return an asyncio future of its result."""
        answer = self.create_future()

        def give(error: BaseException | None, value: Any) -> None:
            def settle() -> None:
                if not answer.done():
                    answer.set_result(value) if error is None else answer.set_exception(error)

            self.call_soon_threadsafe(settle)

        def work() -> None:
            try:
                value = func(*args)
            except Exception as error:
                give(error, None)
            else:
                give(None, value)

        if executor is None:
            self._process.start_thread(work, 'asyncio', daemon=True)
        else:
            executor.submit(func, *args).add_done_callback(
                lambda future: give(future.exception(), None if future.exception() else future.result())
            )
        return answer

    def add_signal_handler(self, sig: int, callback: Callable[..., object], *args: Any) -> None:  # type: ignore[override]
        """Call `callback` on the loop when the program gets the signal."""
        self._process.signals.handlers[sig] = lambda signum: self.call_soon_threadsafe(callback, *args)

    def remove_signal_handler(self, sig: int) -> bool:
        """Remove the handler of a signal, and return whether there was one."""
        return self._process.signals.handlers.pop(sig, None) is not None


def _refusal(name: str, need: str) -> Callable[..., Any]:
    """Return a method that raises an error, because the simulation does not support the real method."""

    def refuse(self: ProcessEventLoop, *_: Any, **__: Any) -> Any:
        raise with_facts(
            RuntimeError(f'asyncio: {name} cannot be used in the simulation'), f'programs.asyncio-{need}', method=name
        )

    return refuse


REFUSED = {
    'programs': ('subprocess_exec', 'subprocess_shell'),
    'network': (
        'create_connection',
        'create_server',
        'create_datagram_endpoint',
        'create_unix_connection',
        'create_unix_server',
        'sock_connect',
    ),
    'keyboard': ('add_reader', 'connect_read_pipe', 'connect_write_pipe'),
}
"""Methods of the loop that need a part of a real machine, and that part."""
for _need, _names in REFUSED.items():
    for _name in _names:
        setattr(ProcessEventLoop, _name, _refusal(_name, _need))


def make_asyncio(view: ModuleType, process: Process) -> ModuleType:
    """In the view of `asyncio`, replace `run`, `Runner`, `run_coroutine_threadsafe`, and every function that creates, sets or
    returns a loop. Return the view.
    """
    loops: dict[Task, Any] = {}

    def new_event_loop() -> ProcessEventLoop:
        return ProcessEventLoop(process, current_task())

    def set_event_loop(loop: Any) -> None:
        loops[current_task()] = loop

    def get_event_loop() -> Any:
        running = real._get_running_loop()
        if running is not None:
            return running
        task = current_task()
        if loops.get(task) is None:
            if task is not process.lifecycle.task:
                raise RuntimeError(f'There is no current event loop in thread {task.name!r}.')
            loop = loops[task] = new_event_loop()
            process.lifecycle.at_exit.append(lambda: None if loop.is_running() else loop.close())
        return loops[task]

    def run(main: Coroutine[Any, Any, Any], *, debug: bool | None = None, loop_factory: Callable[[], Any] | None = None) -> Any:
        if real._get_running_loop() is not None:
            raise RuntimeError('asyncio.run() cannot be called from a running event loop')
        if not real.iscoroutine(main):
            raise ValueError(f'a coroutine was expected, got {main!r}')
        loop = (loop_factory or new_event_loop)()
        set_event_loop(loop)
        loop.set_debug(bool(debug))
        try:
            return loop.run_until_complete(main)
        finally:
            _close(loop)
            set_event_loop(None)

    view.__dict__['run_coroutine_threadsafe'] = _threadsafe(process)
    view.__dict__.update(new_event_loop=new_event_loop, set_event_loop=set_event_loop, get_event_loop=get_event_loop, run=run)
    if hasattr(real, 'Runner'):
        view.__dict__['Runner'] = _runner_class(run)
    copy_names(view, real)
    return view


def _threadsafe(process: Process) -> Callable[..., Any]:
    """Return a `run_coroutine_threadsafe` that uses this process's version of `concurrent.futures`."""

    def run_coroutine_threadsafe(coro: Coroutine[Any, Any, Any], loop: Any) -> Any:
        futures: Any = process.loader.import_module('concurrent.futures')
        answer = futures.Future()

        def settle(task: Any) -> None:
            if task.cancelled():
                answer.cancel()
            elif task.exception() is not None:
                answer.set_exception(task.exception())
            else:
                answer.set_result(task.result())

        loop.call_soon_threadsafe(lambda: real.ensure_future(coro, loop=loop).add_done_callback(settle))
        return answer

    return run_coroutine_threadsafe


def _close(loop: Any) -> None:
    """Cancel the remaining tasks of a loop, wait for them, and close the loop, as `asyncio.run` does."""
    cancel_all_tasks(loop)
    loop.run_until_complete(loop.shutdown_asyncgens())
    loop.close()


def _runner_class(run: Callable[..., Any]) -> type:
    class Runner:
        """The simulated `asyncio.Runner`. Each call of `run` uses a new loop."""

        def __init__(self, *, debug: bool | None = None, loop_factory: Callable[[], Any] | None = None) -> None:
            self._options = {'debug': debug, 'loop_factory': loop_factory}

        def __enter__(self) -> Runner:
            return self

        def __exit__(self, *_: object) -> None:
            self.close()

        def run(self, coro: Coroutine[Any, Any, Any], *, context: Any = None) -> Any:
            """Run a coroutine until it ends, and return its result."""
            return run(coro, **self._options)

        def close(self) -> None:
            """Do nothing, because each call of `run` closes its own loop."""

    return Runner

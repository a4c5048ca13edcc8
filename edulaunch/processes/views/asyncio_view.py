"""`asyncio` in simulated time: every loop of a program is a simulated one."""
from __future__ import annotations

import asyncio as real
from collections.abc import Callable, Coroutine
from types import ModuleType
from typing import TYPE_CHECKING, Any

from edulaunch.processes.views import copy_names
from edulaunch.sim.aio import SimulatedEventLoop
from edulaunch.sim.task import Task, current_task

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


class ProcessEventLoop(SimulatedEventLoop):
    """A simulated loop whose executor threads are threads of the program."""

    def __init__(self, process: Process, task: Task) -> None:
        super().__init__(task)
        self._process = process

    def run_in_executor(self, executor: Any, func: Callable[..., Any], *args: Any) -> Any:  # type: ignore[override]
        """Run a blocking function beside the loop; an asyncio future of its result."""
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
                lambda future: give(future.exception(), None if future.exception() else future.result()))
        return answer


    def add_signal_handler(self, sig: int, callback: Callable[..., object], *args: Any) -> None:  # type: ignore[override]
        """Call `callback` on the loop when the program gets the signal."""
        self._process.signal_handlers[sig] = lambda signum: self.call_soon_threadsafe(callback, *args)

    def remove_signal_handler(self, sig: int) -> bool:
        """Whether there was one."""
        return self._process.signal_handlers.pop(sig, None) is not None


def _refusal(name: str, instead: str) -> Callable[..., Any]:
    """A method that only tells what to do instead."""

    def refuse(self: ProcessEventLoop, *_: Any, **__: Any) -> Any:
        error: Any = RuntimeError(f'asyncio: {name} cannot be used in the simulation')
        error.edulaunch_hint = instead
        raise error

    return refuse


REFUSED = {
    'start programs with subprocess.run() or subprocess.Popen(), which wait in simulated time': (
        'subprocess_exec', 'subprocess_shell'),
    'the simulated machine has no network; nodes talk over topics, services and actions': (
        'create_connection', 'create_server', 'create_datagram_endpoint', 'create_unix_connection', 'create_unix_server',
        'sock_connect'),
    'read the keyboard with input() in a thread: await asyncio.to_thread(input)': (
        'add_reader', 'connect_read_pipe', 'connect_write_pipe'),
}
"""What to do in place of what, for methods of the loop that need a real machine."""
for _instead, _names in REFUSED.items():
    for _name in _names:
        setattr(ProcessEventLoop, _name, _refusal(_name, _instead))


def make(view: ModuleType, process: Process) -> ModuleType:
    """`run`, `Runner` and everything that makes or gives a loop."""
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
            if task is not process.task:
                raise RuntimeError(f'There is no current event loop in thread {task.name!r}.')
            loop = loops[task] = new_event_loop()
            process.at_exit.append(lambda: None if loop.is_running() else loop.close())
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

    view.__dict__['run_coroutine_threadsafe'] = run_coroutine_threadsafe
    view.__dict__.update(new_event_loop=new_event_loop, set_event_loop=set_event_loop, get_event_loop=get_event_loop, run=run)
    if hasattr(real, 'Runner'):
        view.__dict__['Runner'] = _runner_class(run)
    copy_names(view, real)
    return view


def _close(loop: Any) -> None:
    """As `asyncio.run` leaves a loop: what still runs on it is cancelled and waited for."""
    waiting = real.all_tasks(loop)
    for task in waiting:
        task.cancel()
    if waiting:
        loop.run_until_complete(real.gather(*waiting, return_exceptions=True))
    loop.run_until_complete(loop.shutdown_asyncgens())
    loop.close()


def _runner_class(run: Callable[..., Any]) -> type:
    class Runner:
        """As `asyncio.Runner`: one loop for several calls."""

        def __init__(self, *, debug: bool | None = None, loop_factory: Callable[[], Any] | None = None) -> None:
            self._options = {'debug': debug, 'loop_factory': loop_factory}

        def __enter__(self) -> Runner:
            return self

        def __exit__(self, *_: object) -> None:
            self.close()

        def run(self, coro: Coroutine[Any, Any, Any], *, context: Any = None) -> Any:
            """Run a coroutine to its end."""
            return run(coro, **self._options)

        def close(self) -> None:
            """Nothing stays open between two calls."""

    return Runner

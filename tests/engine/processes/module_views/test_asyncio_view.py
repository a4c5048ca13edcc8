"""asyncio inside: loops in simulated time."""

from __future__ import annotations

from typing import Any


def test_asyncio_runs_in_simulated_time(world: Any) -> None:
    assert (
        world.run("""
        import asyncio, time
        async def tick(seconds):
            await asyncio.sleep(seconds)
            print(seconds, time.monotonic())
            return seconds
        async def main():
            slept = asyncio.get_running_loop().run_in_executor(None, time.sleep, 2.5)
            print(await asyncio.gather(tick(2), tick(1)))
            await slept
        asyncio.run(main())
        asyncio.get_event_loop().run_until_complete(tick(1))
        """)
        == '1 1.0\n2 2.0\n[2, 1]\n1 3.5\n'
    )


def test_asyncio_counts_the_tasks_of_each_program_and_tells_at_its_end_what_was_left(world: Any) -> None:
    for name in ('one', 'two'):
        out = world.run(
            """
            import asyncio
            async def wait():
                print(asyncio.current_task().get_name())
                await asyncio.sleep(1000)
            loop = asyncio.new_event_loop()
            asyncio.run_coroutine_threadsafe(wait(), loop)
            loop.call_later(1.0, loop.stop)
            loop.run_forever()
            """,
            name,
        ).splitlines()
        assert out[:2] == ['Task-1', 'Task was destroyed but it is pending!']
        assert out[2].startswith("task: <Task pending name='Task-1' coro=<wait() running at ")
        assert out[2].endswith('wait_for=<Future pending cb=[Task.task_wakeup()]>>')


def test_asyncio_run_wants_a_coroutine_and_cancels_what_is_left(world: Any) -> None:
    assert (
        world.run("""
        import asyncio
        async def for_ever():
            try:
                await asyncio.sleep(1000)
            finally:
                print('cancelled')
        async def main():
            asyncio.ensure_future(for_ever())
            await asyncio.sleep(1)
        asyncio.run(main())
        try:
            asyncio.run(3)
        except ValueError as error:
            print(error)
        """)
        == 'cancelled\na coroutine was expected, got 3\n'
    )


def test_asyncio_hears_signals_and_tells_what_it_cannot_do(world: Any) -> None:
    wrote = world.run("""
        import asyncio, os, signal
        async def main():
            pressed = asyncio.Event()
            loop = asyncio.get_running_loop()
            loop.add_signal_handler(signal.SIGINT, pressed.set)
            loop.call_later(2, os.kill, os.getpid(), signal.SIGINT)
            await pressed.wait()
            print('pressed', loop.time())
            await asyncio.create_subprocess_exec('ls')
        asyncio.run(main())
        """)
    assert wrote.startswith('pressed 2.0\n') and wrote.endswith(
        'RuntimeError: asyncio: subprocess_exec cannot be used in the simulation\n'
        '  help: asyncio cannot start programs in the simulation (subprocess_exec); start programs with subprocess.run() or subprocess.Popen(), which wait in simulated time\n'
    )


def test_coroutines_run_on_the_loop_of_another_thread(world: Any) -> None:
    assert (
        world.run("""
        import asyncio, threading, time
        loop = asyncio.new_event_loop()
        thread = threading.Thread(target=loop.run_forever)
        thread.start()
        async def work(seconds):
            await asyncio.sleep(seconds)
            return 1 / (seconds - 2)
        print(asyncio.run_coroutine_threadsafe(work(1), loop).result(), time.monotonic())
        print(type(asyncio.run_coroutine_threadsafe(work(2), loop).exception()).__name__, time.monotonic())
        loop.call_soon_threadsafe(loop.stop)
        thread.join()
        """)
        == '-1.0 1.0\nZeroDivisionError 3.0\n'
    )

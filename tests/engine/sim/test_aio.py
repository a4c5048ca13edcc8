"""asyncio in simulated time."""

from __future__ import annotations

import asyncio
from collections.abc import Coroutine
from typing import Any

from edulaunch.engine.sim import sync
from edulaunch.engine.sim.aio import new_event_loop
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.task import Task, current_task


def run_in_task(sim: Simulation, *bodies: Any) -> list[Task]:
    tasks = [Task(sim, body, name=str(number)) for number, body in enumerate(bodies)]
    for task in tasks:
        task.start()
    sim.run()
    for task in tasks:
        if task.exception is not None:
            raise task.exception
    return tasks


def drive(main: Coroutine[Any, Any, Any]) -> Any:
    loop = new_event_loop()
    try:
        return loop.run_until_complete(main)
    finally:
        loop.close()


def test_sleeping_coroutines_take_turns_in_simulated_time() -> None:
    sim, log = Simulation(), []

    async def nap(seconds: float) -> None:
        await asyncio.sleep(seconds)
        log.append((sim.elapsed_s, seconds))

    async def main() -> None:
        await asyncio.gather(nap(3), nap(1), nap(2))

    run_in_task(sim, lambda: drive(main()))
    assert log == [(1.0, 1), (2.0, 2), (3.0, 3)]


def test_two_loops_in_two_tasks_do_not_see_each_other() -> None:
    sim, log = Simulation(), []

    async def ticker(name: str, period: float) -> None:
        for _ in range(2):
            await asyncio.sleep(period)
            log.append((round(sim.elapsed_s, 6), name))

    run_in_task(sim, lambda: drive(ticker('a', 1.0)), lambda: drive(ticker('b', 0.7)))
    assert log == [(0.7, 'b'), (1.0, 'a'), (1.4, 'b'), (2.0, 'a')]


def test_another_task_hands_work_over_threadsafe() -> None:
    sim, log, loops = Simulation(), [], []

    async def wait_for_word() -> None:
        loop = asyncio.get_running_loop()
        word = loop.create_future()
        loops.append((loop, word))
        said = await word
        log.append((sim.elapsed_s, said))

    def other() -> None:
        sync.sleep(1)
        loop, word = loops[0]
        loop.call_soon_threadsafe(word.set_result, 'hello')

    run_in_task(sim, lambda: drive(wait_for_word()), other)
    assert log == [(1.0, 'hello')]


def test_a_simulation_runs_inside_a_running_loop_as_in_a_notebook() -> None:
    sim, log = Simulation(), []

    async def nap() -> None:
        await asyncio.sleep(5)
        log.append(sim.elapsed_s)

    async def notebook() -> None:
        run_in_task(sim, lambda: drive(nap()))
        log.append(asyncio.get_running_loop() is not None)

    asyncio.run(notebook())
    assert log == [5.0, True]


def test_blocking_inside_a_coroutine_blocks_only_its_own_task() -> None:
    sim, log = Simulation(), []

    async def rude() -> None:
        sync.sleep(2)
        log.append((sim.elapsed_s, 'rude'))

    run_in_task(sim, lambda: drive(rude()), lambda: (sync.sleep(1), log.append((sim.elapsed_s, 'other'))))
    assert log == [(1.0, 'other'), (2.0, 'rude')]


def test_a_program_that_is_ended_in_a_callback_says_nothing(caplog: Any) -> None:
    sim, lock, log = Simulation(), sync.Lock(), []

    async def main() -> None:
        future = asyncio.get_running_loop().create_future()
        future.add_done_callback(lambda _: lock.acquire())
        try:
            await asyncio.sleep(10.0)
        finally:
            log.append(sim.elapsed_s)
            future.set_result(None)
            await asyncio.sleep(0)

    def ended() -> None:
        lock.acquire()
        loop = new_event_loop()
        task = loop.create_task(main())
        try:
            loop.run_until_complete(task)
        finally:
            task.cancel()
            loop.run_until_complete(asyncio.gather(task, return_exceptions=True))
            loop.close()

    task = Task(sim, ended, name='ended')
    task.start()
    sim.run(until_ns=sim.now_ns + 10**9)
    task.kill()
    sim.run()
    assert log == [1.0]
    assert caplog.text == ''


def test_a_loop_inside_a_loop_gives_the_task_back_to_the_outer_one() -> None:
    sim, log = Simulation(), []

    async def inner() -> None:
        await asyncio.sleep(1)
        log.append((sim.elapsed_s, 'inner'))

    async def outer() -> None:
        mine = current_task().loop
        drive(inner())
        log.append((sim.elapsed_s, current_task().loop is mine))

    def body() -> None:
        drive(outer())
        log.append((sim.elapsed_s, current_task().loop))

    run_in_task(sim, body)
    assert log == [(1.0, 'inner'), (1.0, True), (1.0, None)]

"""A running loop is set aside and put back."""

from __future__ import annotations

import asyncio
from asyncio import events

from edulaunch.engine.sim.loops import cancel_all_tasks, put_back, set_aside


def test_another_loop_may_run_while_one_is_set_aside() -> None:
    log: list[object] = []

    async def inner() -> None:
        log.append(('inner', asyncio.current_task() is not None))

    async def outer() -> None:
        loop, task = asyncio.get_running_loop(), asyncio.current_task()
        aside = set_aside()
        log.append(events._get_running_loop())
        asyncio.run(inner())
        put_back(aside)
        log.append((asyncio.get_running_loop() is loop, asyncio.current_task() is task))
        await asyncio.sleep(0)
        log.append('goes on')

    asyncio.run(outer())
    assert log == [None, ('inner', True), (True, True), 'goes on']


def test_nothing_to_set_aside() -> None:
    aside = set_aside()
    assert aside == (None, None)
    put_back(aside)
    assert events._get_running_loop() is None


def test_what_is_left_on_a_loop_is_cancelled_and_waited_for() -> None:
    log: list[str] = []

    async def stubborn() -> None:
        try:
            await asyncio.Event().wait()
        finally:
            await asyncio.sleep(0)
            log.append('tidied up')

    loop = asyncio.new_event_loop()
    task = loop.create_task(stubborn())
    loop.run_until_complete(asyncio.sleep(0))
    cancel_all_tasks(loop)
    loop.close()
    assert log == ['tidied up'] and task.cancelled()

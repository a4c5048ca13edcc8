"""A running loop is set aside and put back."""

from __future__ import annotations

import asyncio
import sys
from asyncio import events

import pytest

from edulaunch.engine.sim.loops import cancel_all_tasks, outer_loop_set_aside, put_back, set_aside


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


def test_the_outer_loop_its_task_and_its_hooks_are_restored_also_after_an_error() -> None:
    def first(generator: object) -> None:
        """Ours."""

    async def outer() -> None:
        loop, task, hooks = asyncio.get_running_loop(), asyncio.current_task(), sys.get_asyncgen_hooks()
        with pytest.raises(KeyError), outer_loop_set_aside():
            assert events._get_running_loop() is None
            sys.set_asyncgen_hooks(first, None)
            raise KeyError
        assert (asyncio.get_running_loop(), asyncio.current_task(), sys.get_asyncgen_hooks()) == (loop, task, hooks)

    asyncio.run(outer())

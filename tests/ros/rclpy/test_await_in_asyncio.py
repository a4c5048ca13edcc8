"""rclpy's futures awaited by coroutines of an asyncio loop, as of the real rclpy."""

from __future__ import annotations

import asyncio

import pytest
from rclpy.task import Future


def test_a_coroutine_of_asyncio_waits_for_a_future_and_gets_its_result() -> None:
    order: list[str] = []

    async def main() -> int:
        future = Future()

        async def later() -> None:
            await asyncio.sleep(0)
            order.append('set')
            future.set_result(3)

        setting = asyncio.create_task(later())
        found = await future
        order.append('got')
        await setting
        return int(found)

    assert asyncio.run(main()) == 3
    assert order == ['set', 'got']


def test_an_exception_comes_out_and_a_future_that_is_done_does_not_wait() -> None:
    async def main() -> None:
        future = Future()
        asyncio.get_running_loop().call_soon(future.set_exception, ValueError('no'))
        await future

    async def at_once() -> object:
        future = Future()
        future.set_result('there')
        return await future

    with pytest.raises(ValueError, match='no'):
        asyncio.run(main())
    assert asyncio.run(at_once()) == 'there'


def test_a_task_of_asyncio_that_is_cancelled_does_not_wait_on() -> None:
    async def main() -> bool:
        async def waiting() -> None:
            await Future()

        task = asyncio.create_task(waiting())
        await asyncio.sleep(0)
        task.cancel()
        with pytest.raises(asyncio.CancelledError):
            await task
        return task.cancelled()

    assert asyncio.run(main())

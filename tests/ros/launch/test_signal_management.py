"""Signals as callbacks of a loop, in a plain script."""

from __future__ import annotations

import asyncio
import signal
from collections.abc import Iterator
from typing import Any

import pytest
from launch.utilities import AsyncSafeSignalManager

USER = signal.SIGUSR1


@pytest.fixture
def loop() -> Iterator[asyncio.AbstractEventLoop]:
    before = signal.signal(USER, lambda *_: None)
    made = asyncio.new_event_loop()
    yield made
    made.close()
    signal.signal(USER, before)


def turn(loop: asyncio.AbstractEventLoop) -> None:
    loop.run_until_complete(asyncio.sleep(0))
    loop.run_until_complete(asyncio.sleep(0))


def test_signal_calls_back_inside_the_block_only(loop: asyncio.AbstractEventLoop) -> None:
    got: list[int] = []
    manager = AsyncSafeSignalManager(loop)
    manager.handle(USER, got.append)
    signal.raise_signal(USER)
    with manager:
        signal.raise_signal(USER)
        turn(loop)
        assert got == [USER]
    signal.raise_signal(USER)
    turn(loop)
    assert got == [USER]


def test_handle_returns_the_handler_before(loop: asyncio.AbstractEventLoop) -> None:
    got: list[int] = []
    with AsyncSafeSignalManager(loop) as manager:
        assert manager.handle(USER, got.append) is None
        assert manager.handle(USER, None) == got.append
        signal.raise_signal(USER)
        turn(loop)
    assert got == []


def test_block_inside_a_block_tells_both(loop: asyncio.AbstractEventLoop) -> None:
    got: list[str] = []
    with AsyncSafeSignalManager(loop) as outer, AsyncSafeSignalManager(loop) as inner:
        outer.handle(USER, lambda _: got.append('outer'))
        inner.handle(USER, lambda _: got.append('inner'))
        signal.raise_signal(USER)
        turn(loop)
    assert got == ['outer', 'inner']


def test_second_ctrl_c_that_nobody_handles_interrupts(loop: asyncio.AbstractEventLoop) -> None:
    with AsyncSafeSignalManager(loop) as manager:
        manager.handle(signal.SIGINT, lambda _: None)
        try:
            signal.raise_signal(signal.SIGINT)
        except KeyboardInterrupt:
            pytest.fail('the first one is for the handler')
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


@pytest.mark.parametrize('wrong', [(999, print), (USER, 'print')])
def test_wrong_arguments_are_value_errors(loop: asyncio.AbstractEventLoop, wrong: tuple[int, object]) -> None:
    with pytest.raises(ValueError):
        AsyncSafeSignalManager(loop).handle(*wrong)  # type: ignore[arg-type]


def test_the_handler_of_the_process_comes_back_behind_the_block(loop: asyncio.AbstractEventLoop, fresh_simulation: Any) -> None:
    def own(number: int, frame: object) -> None: ...

    installed = fresh_simulation.signals.handlers
    installed[USER] = own
    manager = AsyncSafeSignalManager(loop)
    manager.handle(USER, print)
    with manager:
        assert installed[USER] is not own
    assert installed[USER] is own

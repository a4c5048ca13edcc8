"""rclpy.task."""

from __future__ import annotations

from collections.abc import Callable
from contextlib import suppress
from typing import Any

import pytest
from rclpy.task import Future, Task, is_coroutine_function


def test_a_future_has_no_result_before_it_is_done() -> None:
    future = Future()
    assert (future.done(), future.result()) == (False, None)
    future.set_result(5)
    assert (future.done(), future.result()) == (True, 5)


def test_an_exception_is_raised_by_result() -> None:
    future = Future()
    future.set_exception(ValueError('x'))
    assert isinstance(future.exception(), ValueError)
    with pytest.raises(ValueError, match='x'):
        future.result()


def test_cancelling_does_not_make_it_done() -> None:
    future = Future()
    future.cancel()
    assert (future.cancelled(), future.done()) == (True, False)


def test_an_executor_has_to_be_one() -> None:
    with pytest.raises(TypeError, match="cannot create weak reference to 'int' object"):
        Future(executor=5)  # type: ignore[arg-type]


def test_callbacks_without_executor_run_at_once_and_their_errors_are_warnings() -> None:
    future, called = Future(), []
    future.add_done_callback(lambda _: 1 // 0)
    future.add_done_callback(lambda done: called.append(done.result()))
    with pytest.warns(UserWarning, match='Unhandled exception in done callback: '):
        future.set_result(1)
    future.add_done_callback(lambda done: called.append('late'))
    assert called == [1, 'late']


def test_callbacks_can_be_removed() -> None:
    future, called = Future(), []
    future.add_done_callback(called.append)
    assert future.remove_done_callback(called.append)
    assert not future.remove_done_callback(called.append)
    future.set_result(1)
    assert called == []


def test_an_exception_that_nobody_asked_for_is_printed(capsys: pytest.CaptureFixture[str]) -> None:
    future = Future()
    future.set_exception(ValueError('lost'))
    del future
    assert capsys.readouterr().err == 'The following exception was never retrieved: lost\n'


def test_an_exception_is_printed_where_its_process_printed(
    capsys: pytest.CaptureFixture[str], monkeypatch: pytest.MonkeyPatch
) -> None:
    future = Future()
    future.set_exception(ValueError('lost'))
    monkeypatch.delattr('rclpy.task.current_process')  # as when Python ends
    del future
    assert capsys.readouterr().err == 'The following exception was never retrieved: lost\n'


@pytest.mark.parametrize('ask', [Future.exception, Future.result])
def test_an_exception_that_was_asked_for_is_not_printed(
    ask: Callable[[Future], object], capsys: pytest.CaptureFixture[str]
) -> None:
    future = Future()
    future.set_exception(ValueError('found'))
    with suppress(ValueError):
        ask(future)
    del future
    assert capsys.readouterr().err == ''


def test_a_task_runs_functions_and_coroutines() -> None:
    future = Future()

    async def wait() -> int:
        return int(await future) + 1

    plain, waiting = Task(lambda a, b: a + b, (1, 2)), Task(wait)
    plain()
    waiting()
    assert (plain.result(), waiting.done()) == (3, False)
    future.set_result(4)
    waiting()
    assert waiting.result() == 5


def test_coroutine_functions_are_seen_through_methods_and_partials() -> None:
    from functools import partial

    class Node:
        async def callback(self, number: int) -> None:
            """Nothing."""

    assert is_coroutine_function(partial(Node().callback, 1))
    assert not is_coroutine_function(print)


def test_a_callback_added_twice_is_removed_once_at_a_time() -> None:
    future = Future()
    future.add_done_callback(print)
    future.add_done_callback(print)
    assert [future.remove_done_callback(print) for _ in range(3)] == [True, True, False]


def test_a_callback_of_a_cancelled_future_is_called_at_once() -> None:
    future, called = Future(), []
    future.cancel()
    future.add_done_callback(called.append)
    future.set_result(1)
    assert called == [future]


def test_a_cancelled_task_runs_no_more() -> None:
    task = Task(lambda: 5)
    task.cancel()
    task()
    assert (task.done(), task.cancelled(), task.result()) == (False, True, None)


def test_the_callbacks_of_a_future_go_through_its_executors_create_task(ros: Any, world: Any) -> None:
    from unittest.mock import Mock

    def body() -> None:
        executor, callback = Mock(), Mock()
        future = Future(executor=executor)
        future.add_done_callback(callback)
        future.set_result(1)
        future.add_done_callback(callback)
        world.say([call.args == (callback, future) for call in executor.create_task.call_args_list])

    assert ros(body) == [[True, True]]


class Waker:
    """An executor that counts how often it is woken."""

    def __init__(self) -> None:
        self.count = 0

    def wake(self) -> None:
        self.count += 1


def test_each_executor_that_waits_is_woken_once_when_the_future_is_done() -> None:
    future, first, second = Future(), Waker(), Waker()
    for executor in (first, first, second):
        future.rcl_wake_when_done(executor)  # type: ignore[arg-type]
    assert (first.count, second.count) == (0, 0)
    future.set_result(1)
    assert (first.count, second.count) == (1, 1)

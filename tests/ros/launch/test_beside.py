"""A launch beside what else a plain script does: real threads, signals, other asyncio loops."""

from __future__ import annotations

import asyncio
import os
import signal
import threading
from collections.abc import Iterator
from typing import Any

import pytest
from launch import LaunchDescription, LaunchService, _beside
from launch.actions import ExecuteProcess, OpaqueFunction, RegisterEventHandler, TimerAction
from launch.actions import Shutdown as ShutdownAction
from launch.event_handlers import OnProcessIO
from osrf_pycommon.process_utils import get_loop


def service(*entities: object, noninteractive: bool = False) -> LaunchService:
    launch_service = LaunchService(noninteractive=noninteractive)
    launch_service.include_launch_description(LaunchDescription(entities))  # type: ignore[arg-type]
    return launch_service


def test_real_thread_may_shut_down_a_launch_that_waits_for_ever() -> None:
    launch_service = service()
    threading.Timer(0.05, launch_service.shutdown).start()
    assert launch_service.run(shutdown_when_idle=False) == 0


def test_beside_a_real_thread_time_keeps_pace() -> None:
    fired: list[str] = []
    launch_service = service(TimerAction(period=60.0, actions=[OpaqueFunction(function=lambda _: fired.append('too late'))]))
    threading.Timer(0.05, launch_service.shutdown).start()
    assert launch_service.run() == 0
    assert fired == []


def test_ctrl_c_reaches_a_real_program_in_a_plain_script() -> None:
    codes: list[int] = []
    program = ExecuteProcess(cmd=['sh', '-c', 'echo up; exec sleep 20'], on_exit=lambda event, _: codes.append(event.returncode))
    press = threading.Timer(0.05, os.kill, (os.getpid(), signal.SIGINT))
    launch_service = service(
        program,
        RegisterEventHandler(OnProcessIO(target_action=program, on_stdout=lambda event: press.start())),
        noninteractive=True,
    )
    assert launch_service.run() == 0
    assert codes == [-signal.SIGINT]


def test_other_tasks_of_the_awaiting_loop_go_on() -> None:
    launch_service = service()

    async def main() -> int:
        task = asyncio.get_running_loop().create_task(launch_service.run_async(shutdown_when_idle=False))
        while (
            launch_service.task is None and not task.done()
        ):  # it begins in a thread of its own, which a busy machine makes wait
            await asyncio.sleep(0.01)
        assert launch_service.task is not None and not task.done()
        ended = launch_service.shutdown()
        assert ended is not None
        await ended
        return await task

    assert asyncio.run(main()) == 0


def test_cancelled_run_on_another_loop_returns_1(capsys: pytest.CaptureFixture[str]) -> None:
    launch_service = service(TimerAction(period=60.0, actions=[]))

    async def main() -> int:
        task = asyncio.get_running_loop().create_task(launch_service.run_async())
        while (
            launch_service.task is None and not task.done()
        ):  # it begins in a thread of its own, which a busy machine makes wait
            await asyncio.sleep(0.01)
        task.cancel()
        return await task

    assert asyncio.run(main()) == 1
    assert '[ERROR] [launch]: run task was canceled' in capsys.readouterr().out


@pytest.fixture
def bare_shell() -> Iterator[None]:
    """An IPython in this program that is no notebook's, as other tests leave one."""
    from IPython.core.interactiveshell import InteractiveShell

    make: Any = InteractiveShell.instance
    make(colors='nocolor')
    yield
    InteractiveShell.clear_instance()


def test_two_hundred_runs_on_another_loop_end_when_and_as_they_are_told(
    bare_shell: None, monkeypatch: pytest.MonkeyPatch, capsys: pytest.CaptureFixture[str]
) -> None:
    monkeypatch.setattr(_beside, 'SLICE_S', 1e-4)  # more turns between the two loops, in less time

    async def run(launch_service: LaunchService, is_cancelled: bool) -> int:
        task = asyncio.get_running_loop().create_task(launch_service.run_async(shutdown_when_idle=False))
        while launch_service.task is None and not task.done():
            await asyncio.sleep(0)
        if is_cancelled:
            task.cancel()
        else:
            launch_service.shutdown()
        return await task

    timers = [TimerAction(period=60.0, actions=[]) for _ in range(200)]
    codes = [asyncio.run(run(service(timer), bool(number % 2))) for number, timer in enumerate(timers)]
    assert codes == [0, 1] * 100


def test_shutdown_gives_something_to_make_a_task_of() -> None:
    launch_service, loop = service(), get_loop()
    run = loop.create_task(launch_service.run_async(shutdown_when_idle=False))
    loop.run_until_complete(asyncio.sleep(1))
    loop.create_task(launch_service.shutdown())  # type: ignore[arg-type]
    assert loop.run_until_complete(run) == 0


def test_streams_closed_early_do_not_let_time_run_ahead() -> None:
    program = ExecuteProcess(cmd=['sh', '-c', 'exec >&- 2>&-; sleep 0.1'])
    launch_service = service(program, TimerAction(period=5.0, actions=[ShutdownAction()]))
    assert launch_service.run() == 0
    assert program.return_code == 0

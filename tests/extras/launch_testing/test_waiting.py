"""Waiting for a process to start, to write a text, and to end: in simulated time, and what is told when it does not happen."""

from __future__ import annotations

from collections.abc import Callable
from typing import Any

import pytest
from launch.actions import ExecuteProcess, LogInfo
from launch.events.process import ProcessExited, ProcessStarted, ProcessStderr, ProcessStdout
from launch.launch_context import LaunchContext
from launch_testing import ActiveProcInfoHandler
from launch_testing.event_handlers import StdoutReadyListener

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.sim.task import Task, current_task


def details_of(name: str) -> tuple[ExecuteProcess, dict[str, Any]]:
    action = ExecuteProcess(cmd=[name])
    action.prepare(LaunchContext())
    return action, {**(action.process_details or {}), 'pid': 1}


def now_s() -> float:
    return current_process().sim.elapsed_s


def late(seconds: float, act: Callable[[], object]) -> None:
    """Act after some simulated time."""
    sim = current_process().sim
    Task(sim, lambda: (current_task().sleep_until(sim.now_ns + int(seconds * 1e9)), act()), name='late').start()


def test_the_actions_come_once_when_the_text_is_complete() -> None:
    wanted, other = details_of('server')[1], details_of('client')[1]
    ready = LogInfo(msg='ready')
    handler = StdoutReadyListener(ready_txt='is ready', actions=[ready])
    came = [
        handler.handle(event, LaunchContext())
        for event in (
            ProcessStdout(text=b'it is re', **wanted),
            ProcessStdout(text=b'ady', **other),
            ProcessStderr(text=b'is ready', **wanted),
            ProcessStdout(text=b'ady\xff', **wanted),
            ProcessStdout(text=b'is ready', **wanted),
        )
    ]
    assert came == [None, None, None, [ready], None]


def test_only_the_process_of_the_action_is_listened_to() -> None:
    action, details = details_of('server')
    handler = StdoutReadyListener(target_action=action, ready_txt='x', actions=[])
    assert handler.matches(ProcessStdout(text=b'x', **details))
    assert not handler.matches(ProcessStdout(text=b'x', **details_of('client')[1]))
    assert handler.handle(ProcessStdout(text=b'x', **details), LaunchContext()) is None


@pytest.mark.parametrize('by_name', [True, False])
def test_a_start_and_an_end_are_waited_for_until_they_come(by_name: bool) -> None:
    info = ActiveProcInfoHandler()
    action, details = details_of('server')
    process: Any = 'server' if by_name else action
    began = now_s()
    late(1.5, lambda: info.append(ProcessStarted(**details)))
    info.assertWaitForStartup(process, timeout=5)
    assert now_s() - began == pytest.approx(1.5)
    late(2.5, lambda: info.append(ProcessExited(returncode=0, **details)))
    info.assertWaitForShutdown(process, timeout=5)
    assert now_s() - began == pytest.approx(4.0)
    info.assertWaitForStartup(process, timeout=5)
    assert now_s() - began == pytest.approx(4.0), 'it has started, even if it has ended since'
    assert [type(event) for event in info] == [ProcessExited]


def test_what_does_not_come_is_told_after_the_time() -> None:
    info = ActiveProcInfoHandler()
    action, details = details_of('server')
    began = now_s()
    with pytest.raises(AssertionError) as nothing:
        info.assertWaitForStartup('server', timeout=2)
    assert now_s() - began == pytest.approx(2.0)
    assert str(nothing.value) == (
        "Timed out waiting for process 'server' to finish\n  help: it has not started; started are: none"
    )
    info.append(ProcessStarted(**details))
    with pytest.raises(AssertionError) as other:
        info.assertWaitForStartup('client', timeout=1)
    assert str(other.value).endswith(f'started are: {details["name"]}')
    with pytest.raises(AssertionError) as running:
        info.assertWaitForShutdown(action)
    assert str(running.value) == f"Timed out waiting for process '{details['name']}' to finish"
    assert now_s() - began == pytest.approx(13.0), 'ten seconds, if nothing else is said'

"""Real threads in the simulation of a plain script's main thread."""

from __future__ import annotations

import itertools
import sys
import threading
import time
from collections.abc import Iterator
from types import SimpleNamespace
from typing import Any

import pytest
import rclpy
from rclpy.executors import MultiThreadedExecutor, SingleThreadedExecutor
from std_msgs.msg import String
from std_srvs.srv import Trigger

from edulaunch.engine.sim import real_threads
from edulaunch.engine.sim.real_threads import RealThreadTask
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.task import AmbientTask, Task, current_task


def answer(_: Any, response: Any) -> Any:
    response.success = True
    return response


@pytest.fixture
def node() -> Iterator[Any]:
    rclpy.init()
    made = rclpy.create_node('here')
    yield made
    made.destroy_node()
    rclpy.try_shutdown()


def spun(executor: Any, node: Any) -> threading.Thread:
    executor.add_node(node)
    thread = threading.Thread(target=executor.spin)
    thread.start()
    return thread


@pytest.mark.parametrize('executor_type', [SingleThreadedExecutor, MultiThreadedExecutor])
def test_node_spun_in_a_thread_answers_the_main_thread(node: Any, executor_type: Any) -> None:
    node.create_service(Trigger, 'ask', answer)
    executor = executor_type()
    thread = spun(executor, node)
    other = rclpy.create_node('other')
    client = other.create_client(Trigger, 'ask')
    future = client.call_async(Trigger.Request())
    rclpy.spin_until_future_complete(other, future, timeout_sec=20.0)
    assert future.done() and future.result().success
    executor.shutdown()
    thread.join(5)
    other.destroy_node()
    assert not thread.is_alive()
    for worker in threading.enumerate():
        if worker.name.startswith('executor-'):
            worker.join(5)
            assert not worker.is_alive(), 'as long as it is there simulated time is real time'


@pytest.mark.parametrize('executor_type', [SingleThreadedExecutor, MultiThreadedExecutor])
def test_callbacks_run_while_the_main_thread_does_something_else(node: Any, executor_type: Any) -> None:
    heard, fired = threading.Event(), threading.Event()
    node.create_subscription(String, 'words', lambda message: heard.set(), 10)
    node.create_timer(0.02, fired.set)
    executor = executor_type()
    thread = spun(executor, node)
    node.create_publisher(String, 'words', 10).publish(String(data='x'))
    assert heard.wait(5) and fired.wait(5)
    executor.shutdown()
    thread.join(5)


def test_client_may_wait_for_a_call_that_a_thread_completes(node: Any) -> None:
    node.create_service(Trigger, 'ask', answer)
    executor, clients = SingleThreadedExecutor(), SingleThreadedExecutor()
    other = rclpy.create_node('other')
    threads = [spun(executor, node), spun(clients, other)]
    assert other.create_client(Trigger, 'ask').call(Trigger.Request()).success
    executor.shutdown()
    clients.shutdown()
    for thread in threads:
        thread.join(5)
    other.destroy_node()


def test_thread_takes_part_only_where_the_main_thread_uses_ros(node: Any) -> None:
    found: list[Any] = []
    thread = threading.Thread(target=lambda: found.append(current_task()))
    thread.start()
    thread.join(5)
    assert isinstance(found[0], RealThreadTask) and found[0].owner is current_task().owner


def test_time_of_such_a_thread_is_real(node: Any) -> None:
    slept: list[float] = []

    def sleep() -> None:
        clock = node.get_clock()
        clock.sleep_for(rclpy.duration.Duration(seconds=0.01))
        began, ros = time.monotonic(), clock.now()
        clock.sleep_for(rclpy.duration.Duration(seconds=0.05))
        slept.extend((time.monotonic() - began, (clock.now() - ros).nanoseconds / 1e9))

    thread = threading.Thread(target=sleep)
    thread.start()
    thread.join(5)
    assert slept[0] >= 0.045 and slept[1] >= 0.045


def test_a_program_that_a_thread_starts_is_begun_by_the_main_thread_whatever_time_it_is(node: Any) -> None:
    sim = current_task().sim
    asked: list[threading.Thread] = []

    class Ticking(Simulation):
        """The time goes on whenever somebody looks."""

        @property
        def now_ns(self) -> int:  # type: ignore[override]
            self.__dict__['now'] += 1
            return int(self.__dict__['now'])

        @now_ns.setter
        def now_ns(self, now: int) -> None:
            self.__dict__['now'] = now

    def start() -> None:
        current_task()
        sim.__class__, sim.__dict__['now'] = Ticking, sim.__dict__.pop('now_ns')
        try:
            Task(sim, lambda: asked.append(threading.current_thread())).start()
        finally:
            sim.__class__, sim.__dict__['now_ns'] = Simulation, sim.__dict__.pop('now')

    thread = threading.Thread(target=start)
    thread.start()
    thread.join(5)
    rclpy.spin_once(node, timeout_sec=0.01)
    assert asked == [threading.main_thread()]


def test_time_never_goes_back_wherever_threads_change(node: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    clock, sim = current_task().real_threads, current_task().sim
    ticks, times = itertools.count(time.monotonic_ns(), 1000), []
    monkeypatch.setattr(real_threads, 'time', SimpleNamespace(monotonic_ns=lambda: next(ticks)))

    def at_each_line(frame: Any, event: str, _: Any) -> Any:
        if frame.f_code.co_filename != real_threads.__file__:
            return None
        times.append(sim.now_ns)
        if not clock._setting_time.locked():
            times.append(clock.now_ns())  # as the main thread does, when it comes in here
        return at_each_line

    def park() -> None:
        task = current_task()
        sys.settrace(at_each_line)
        try:
            task.park(sim.now_ns + 10)
        finally:
            sys.settrace(None)

    thread = threading.Thread(target=park)
    thread.start()
    thread.join(5)
    assert len(times) > 10 and times == sorted(times)


class Bell:
    """A real world in which time passes only while somebody waits; what was waited for."""

    def __init__(self) -> None:
        self.now_ns = 0
        self.waits: list[float] = []

    def monotonic_ns(self) -> int:
        return self.now_ns

    def wait(self, seconds: float) -> None:
        self.waits.append(round(seconds, 4))
        self.now_ns += round(seconds * 1e9)

    def set(self) -> None:
        """Ring."""

    clear = set


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> tuple[real_threads.RealThreads, Bell]:
    bell = Bell()
    monkeypatch.setattr(real_threads, 'time', bell)
    monkeypatch.setattr(real_threads.threading, 'Event', lambda: bell)
    return real_threads.RealThreads(AmbientTask(Simulation())), bell


def test_the_main_thread_waits_until_its_next_item_but_never_for_long(clock: tuple[real_threads.RealThreads, Bell]) -> None:
    threads, bell = clock
    began = threads.now_ns()
    assert [threads.await_turn(due) for due in (None, began + 10**10, began + 24_000_000)] == [False] * 3
    assert bell.waits == [0.01, 0.01, 0.004] and threads.await_turn(began + 24_000_000)


def test_a_thread_that_parks_is_told_of_its_deadline_and_of_a_wake(clock: tuple[real_threads.RealThreads, Bell]) -> None:
    threads, bell = clock
    task = threads.join()
    began = threads.now_ns()
    assert not task.park(began + 4_000_000) and bell.waits == [0.004]
    assert task.park() and task.park(began + 10**10), 'it looks again after a moment'
    assert bell.waits == [0.004, 0.01, 0.01]
    task.wake()
    assert task.park(began) and bell.waits == [0.004, 0.01, 0.01]
    assert not task.park(began) and bell.waits == [0.004, 0.01, 0.01]

"""Programs that block take turns."""

from __future__ import annotations

import threading
from collections.abc import Callable

import pytest

from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.task import AmbientTask, Task, current_task, running_task
from edulaunch.errors import SimulationError

Log = list[tuple[float, str]]


def start(sim: Simulation, body: Callable[[], object], name: str = 'task') -> Task:
    task = Task(sim, body, name=name)
    task.start()
    return task


def note(sim: Simulation, log: Log, what: object) -> None:
    log.append((sim.elapsed_s, str(what)))


def sleeper(sim: Simulation, log: Log, name: str, seconds: float, times: int) -> Callable[[], None]:
    def body() -> None:
        for _ in range(times):
            current_task().sleep_until(sim.now_ns + round(seconds * 1e9))
            log.append((sim.elapsed_s, name))

    return body


def test_sleepers_interleave_by_time_then_by_who_asked_first() -> None:
    sim, log = Simulation(), []
    start(sim, sleeper(sim, log, 'a', 1.0, 2))
    start(sim, sleeper(sim, log, 'b', 0.5, 4))
    sim.run()
    assert log == [(0.5, 'b'), (1.0, 'a'), (1.0, 'b'), (1.5, 'b'), (2.0, 'a'), (2.0, 'b')]


def test_an_interrupt_is_raised_where_the_task_waits() -> None:
    sim, log = Simulation(), []

    def fail() -> None:
        raise KeyboardInterrupt

    def body() -> None:
        try:
            current_task().park()
        except KeyboardInterrupt:
            log.append((sim.elapsed_s, 'interrupted'))

    task = start(sim, body)
    sim.schedule(sim.now_ns + 10**9, lambda: task.interrupt(fail))
    sim.run()
    assert log == [(1.0, 'interrupted')] and task.finished and task.exception is None


def test_a_killed_task_unwinds_and_cannot_go_on() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        try:
            current_task().park()
        finally:
            log.append('cleaned up')
            current_task().park()
            log.append('never')

    task = start(sim, body)
    sim.step()
    task.kill()
    sim.run()
    assert log == ['cleaned up'] and task.finished


def test_an_exception_ends_only_its_own_task() -> None:
    sim, log = Simulation(), []
    broken = start(sim, lambda: 1 / 0)
    start(sim, sleeper(sim, log, 'other', 1.0, 1))
    sim.run()
    assert isinstance(broken.exception, ZeroDivisionError)
    assert log == [(1.0, 'other')]


def test_done_callbacks_come_once_and_late_ones_at_once() -> None:
    sim, seen = Simulation(), []
    task = start(sim, lambda: 42)
    task.add_done_callback(lambda done: seen.append(done.result))
    sim.run()
    task.add_done_callback(lambda done: seen.append('late'))
    assert seen == [42, 'late']


def test_current_task_is_the_running_one_and_outside_the_ambient_one() -> None:
    sim, seen = Simulation(), []
    task = start(sim, lambda: seen.append(running_task()))
    sim.run()
    assert seen == [task]
    assert isinstance(current_task(), AmbientTask) and current_task() is current_task()


def test_ambient_waiting_runs_the_simulation_in_place() -> None:
    sim, log = Simulation(), []
    ambient = AmbientTask(sim)
    start(sim, sleeper(sim, log, 'node', 1.0, 3))
    assert ambient.park(sim.now_ns + 2_500_000_000) is False
    assert (sim.elapsed_s, log) == (2.5, [(1.0, 'node'), (2.0, 'node')])


def test_ambient_waiting_for_ever_is_an_error_not_a_hang() -> None:
    with pytest.raises(SimulationError, match='waiting forever.*\n  help: .* start it with ros2 run'):
        AmbientTask(Simulation()).park()


def test_two_interleaved_simulations_behave_as_each_alone() -> None:
    def run(sims: list[Simulation], step: int) -> list[Log]:
        logs: list[Log] = [[] for _ in sims]
        for sim, log in zip(sims, logs, strict=True):
            start(sim, sleeper(sim, log, 'a', 0.3, 5))
            start(sim, sleeper(sim, log, 'b', 0.2, 5))
        for moment in range(0, 2_000_000_001, step):
            for sim in sims:
                sim.run(sim.start_ns + moment)
        return logs

    alone = run([Simulation()], 2_000_000_000)[0]
    assert len(alone) == 10
    assert run([Simulation(), Simulation()], 40_000_000) == [alone, alone]


def test_a_task_that_is_started_at_once_runs_before_its_starter_goes_on() -> None:
    sim, log = Simulation(), []
    child = Task(
        sim, lambda: (note(sim, log, 'child'), current_task().sleep_until(sim.now_ns + 10**9), note(sim, log, 'child again'))
    )

    def body() -> None:
        child.start_at_once()
        note(sim, log, 'starter')

    start(sim, body)
    start(sim, lambda: note(sim, log, 'somebody else'))
    sim.run()
    assert log == [(0.0, 'child'), (0.0, 'starter'), (0.0, 'somebody else'), (1.0, 'child again')]


def test_starting_another_at_once_loses_no_wake_and_keeps_the_wait_that_follows() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        me = current_task()
        Task(sim, me.wake).start_at_once()
        note(sim, log, me.park(sim.now_ns + 10**9))
        note(sim, log, me.park(sim.now_ns + 10**9))

    start(sim, body)
    sim.run()
    assert log == [(0.0, 'True'), (1.0, 'False')]


def test_outside_any_task_another_can_be_started_at_once_too() -> None:
    ambient = AmbientTask(Simulation())
    log: Log = []
    Task(ambient.sim, lambda: note(ambient.sim, log, 'ran')).start_at_once()
    ambient.run_next_first()
    assert log == [(0.0, 'ran')]


def waiter(sim: Simulation, log: Log, name: str, then: Callable[[], object] = lambda: None) -> Task:
    def body() -> None:
        for _ in range(2):
            current_task().park()
            note(sim, log, name)
            then()

    return start(sim, body)


def test_turns_and_callbacks_of_one_instant_keep_the_order_in_which_they_were_asked_for() -> None:
    sim, log = Simulation(), []
    first, second, third = (waiter(sim, log, name) for name in 'abc')

    def wake_all() -> None:
        current_task().sleep_until(at)
        first.wake()
        second.wake()
        sim.schedule(at, lambda: note(sim, log, 'callback'))
        third.wake()
        current_task().park()

    at = sim.now_ns + 10**9
    start(sim, wake_all)
    sim.run(at - 1)
    sim.schedule(at, lambda: note(sim, log, 'asked for earlier'))
    sim.run()
    assert log == [(1.0, what) for what in ('asked for earlier', 'a', 'b', 'callback', 'c')]


def test_stop_holds_before_the_next_task_has_its_turn() -> None:
    sim, log = Simulation(), []
    tasks = [waiter(sim, log, 'a', sim.stop), waiter(sim, log, 'b')]
    sim.schedule(sim.now_ns + 10**9, lambda: [task.wake() for task in tasks])
    sim.run()
    assert log == [(1.0, 'a')]
    sim.run()
    assert log == [(1.0, 'a'), (1.0, 'b')]


def test_a_step_is_one_turn_though_the_next_task_waits() -> None:
    sim, log = Simulation(), []
    tasks = [waiter(sim, log, name) for name in 'ab']
    sim.run()
    for task in tasks:
        task.wake()
    assert (sim.step(), log) == (True, [(0.0, 'a')])


def in_a_thread(body: Callable[[], object]) -> None:
    thread = threading.Thread(target=body)
    thread.start()
    thread.join()


class WokenWhileItParks(Task):
    """Another thread wakes it in the middle of parking, at each of its parks."""

    def _set_timer(self, deadline_ns: int | None) -> None:
        super()._set_timer(deadline_ns)
        in_a_thread(self.wake)


def test_a_wake_of_another_thread_in_the_middle_of_parking_is_not_lost() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        for seconds in (1, 2, 3):
            note(sim, log, current_task().park(sim.now_ns + seconds * 10**9))

    task = WokenWhileItParks(sim, body)
    task.start()
    sim.run()
    assert log == [(0.0, 'True')] * 3 and task.finished


class LateWake(Task):
    """Another thread's wake halts between raising the flag and looking whether the task is parked."""

    def __init__(self, sim: Simulation, body: Callable[[], object]) -> None:
        self.halted, self.go_on = threading.Event(), threading.Event()
        self._is_parked = False
        super().__init__(sim, body)

    @property
    def _parked(self) -> bool:
        if threading.current_thread() is not threading.main_thread():
            self.halted.set()
            self.go_on.wait()
        return self._is_parked

    @_parked.setter
    def _parked(self, parked: bool) -> None:
        self._is_parked = parked


def test_a_wake_that_comes_in_two_parts_ends_one_park_and_no_later_one() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        note(sim, log, current_task().park(sim.now_ns + 10**9))
        note(sim, log, current_task().park(sim.now_ns + 10**9))
        note(sim, log, current_task().park())

    task = LateWake(sim, body)
    task.start()
    thread = threading.Thread(target=task.wake)
    thread.start()
    task.halted.wait()
    sim.run(sim.start_ns + 10**8)  # sees the flag, and parks again
    task.go_on.set()
    thread.join()
    sim.run(sim.start_ns + 3 * 10**9)
    assert log == [(0.0, 'True'), (1.0, 'False')]
    in_a_thread(task.wake)
    sim.run()
    assert log[2:] == [(3.0, 'True')] and task.finished

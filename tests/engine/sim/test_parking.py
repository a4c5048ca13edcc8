"""Waiting: parks, wakes, deadlines, and looks at the clock."""

from __future__ import annotations

from collections.abc import Callable

from edulaunch.engine.sim.parking import POLLS_AFTER_THAT, POLLS_BEFORE_TIME_PASSES
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.task import Task, current_task

Log = list[tuple[float, str]]


def start(sim: Simulation, body: Callable[[], object], name: str = 'task') -> Task:
    task = Task(sim, body, name=name)
    task.start()
    return task


def note(sim: Simulation, log: Log, what: object) -> None:
    log.append((sim.elapsed_s, str(what)))


def test_a_wake_before_the_park_is_not_lost() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        current_task().wake()
        note(sim, log, current_task().park(sim.now_ns + 10**9))

    start(sim, body)
    sim.run()
    assert log == [(0.0, 'True')]


def test_a_wake_before_the_first_turn_is_not_lost() -> None:
    sim, log = Simulation(), []
    task = start(sim, lambda: note(sim, log, current_task().park(sim.now_ns + 10**9)))
    task.wake()
    sim.run()
    assert log == [(0.0, 'True')]


def test_park_tells_wake_from_deadline() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        note(sim, log, current_task().park(sim.now_ns + 2 * 10**9))
        note(sim, log, current_task().park(sim.now_ns + 2 * 10**9))

    task = start(sim, body)
    sim.schedule(sim.now_ns + 10**9, task.wake)
    sim.run()
    assert log == [(1.0, 'True'), (3.0, 'False')]


def test_two_wakes_are_one() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        for _ in range(2):
            note(sim, log, current_task().park(sim.now_ns + 10**9))

    task = start(sim, body)
    sim.schedule(sim.now_ns + 1000, lambda: (task.wake(), task.wake()))
    sim.run()
    assert [what for _, what in log] == ['True', 'False']


def test_sleeping_ignores_wakes_and_hands_them_on() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        current_task().sleep_until(sim.now_ns + 10**9)
        log.append((sim.elapsed_s, 'slept'))
        note(sim, log, current_task().park(sim.now_ns + 10**9))

    task = start(sim, body)
    sim.schedule(sim.now_ns + 1000, task.wake)
    sim.run()
    assert log == [(1.0, 'slept'), (1.0, 'True')]


def test_a_loop_that_only_polls_is_moved_on_by_time() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        end = sim.now_ns + 5_000_000
        while sim.now_ns < end:
            current_task().poll()
        log.append(sim.now_ns - sim.start_ns)

    start(sim, body)
    sim.run()
    assert log == [5_000_000]


def test_a_suspended_task_goes_on_before_everything_else_and_nothing_is_scheduled_for_it() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        sim.schedule(sim.now_ns, lambda: note(sim, log, 'later'))
        note(sim, log, 'before')
        current_task().suspend()
        note(sim, log, 'after')

    start(sim, body)
    sim.run(sim.now_ns + 10**9)
    assert (log, sim.is_suspended, sim.elapsed_s) == ([(0.0, 'before')], True, 0.0)
    number = sim.last_number
    sim.run(sim.now_ns + 10**9)
    assert log == [(0.0, 'before'), (0.0, 'after'), (0.0, 'later')]
    assert (sim.is_suspended, sim.elapsed_s, sim.last_number) == (False, 1.0, number)


def test_a_suspended_task_can_be_killed() -> None:
    sim, log = Simulation(), []

    def body() -> None:
        try:
            current_task().suspend()
        finally:
            note(sim, log, 'unwound')

    task = start(sim, body)
    sim.run()
    task.kill()
    sim.run()
    assert (log, task.finished) == ([(0.0, 'unwound')], True)


def test_time_passes_for_the_first_reading_beyond_the_limit_and_then_after_fewer() -> None:
    sim, readings = Simulation(), list[int]()

    def body() -> None:
        for number in range(1, POLLS_BEFORE_TIME_PASSES + 2 * POLLS_AFTER_THAT + 2):
            before = sim.now_ns
            current_task().poll()
            if sim.now_ns != before:
                readings.append(number)

    start(sim, body)
    sim.run()
    first = POLLS_BEFORE_TIME_PASSES + 1
    assert readings == [first, first + POLLS_AFTER_THAT + 1]

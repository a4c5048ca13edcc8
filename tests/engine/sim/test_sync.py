"""Waiting in simulated time."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from edulaunch.engine.sim import sync
from edulaunch.engine.sim.simulation import Simulation
from edulaunch.engine.sim.task import Task

Log = list[tuple[float, str]]


def run(*programs: Callable[[Simulation, Log], None]) -> Log:
    sim, log = Simulation(), []
    tasks = [Task(sim, lambda program=program: program(sim, log), name=f'p{number}') for number, program in enumerate(programs)]
    for task in tasks:
        task.start()
    sim.run()
    for task in tasks:
        if task.exception is not None:
            raise task.exception
    return log


def test_sleep_takes_simulated_time_only() -> None:
    assert run(lambda sim, log: (sync.sleep(3600), log.append((sim.elapsed_s, 'up')))) == [(3600.0, 'up')]


def test_sleep_refuses_negative_lengths() -> None:
    with pytest.raises(ValueError, match='non-negative'):
        run(lambda sim, log: sync.sleep(-1))


def test_a_lock_goes_to_waiters_in_order() -> None:
    lock = sync.Lock()

    def holder(name: str) -> Callable[[Simulation, Log], None]:
        def program(sim: Simulation, log: Log) -> None:
            with lock:
                log.append((sim.elapsed_s, name))
                sync.sleep(1)

        return program

    assert run(holder('a'), holder('b'), holder('c')) == [(0.0, 'a'), (1.0, 'b'), (2.0, 'c')]


def test_a_lock_with_a_timeout_gives_up() -> None:
    lock = sync.Lock()

    def impatient(sim: Simulation, log: Log) -> None:
        for timeout in (0.5, 5):
            taken = lock.acquire(timeout=timeout)
            log.append((sim.elapsed_s, str(taken)))

    assert run(lambda sim, log: (lock.acquire(), sync.sleep(1), lock.release()), impatient) == [(0.5, 'False'), (1.0, 'True')]


def test_an_rlock_may_be_taken_again_and_must_be_given_back_as_often() -> None:
    lock = sync.RLock()

    def owner(sim: Simulation, log: Log) -> None:
        with lock, lock:
            sync.sleep(1)
        log.append((sim.elapsed_s, 'released'))

    assert run(owner, lambda sim, log: (lock.acquire(), log.append((sim.elapsed_s, 'mine')))) == [
        (1.0, 'released'),
        (1.0, 'mine'),
    ]


def test_releasing_what_one_does_not_hold_is_an_error() -> None:
    with pytest.raises(RuntimeError):
        run(lambda sim, log: sync.Lock().release())
    with pytest.raises(RuntimeError):
        run(lambda sim, log: sync.RLock().release())


def test_an_event_wakes_all_who_wait() -> None:
    event = sync.Event()

    def waiter(sim: Simulation, log: Log) -> None:
        happened = event.wait(5)
        log.append((sim.elapsed_s, str(happened)))

    assert run(waiter, waiter, lambda sim, log: (sync.sleep(2), event.set())) == [(2.0, 'True'), (2.0, 'True')]
    assert event.is_set()


def test_an_event_wait_times_out() -> None:
    event = sync.Event()

    def waiter(sim: Simulation, log: Log) -> None:
        result = event.wait(1.5)
        log.append((sim.elapsed_s, str(result)))

    assert run(waiter) == [(1.5, 'False')]


def test_a_condition_notifies_the_longest_waiting_first() -> None:
    condition = sync.Condition()

    def waiter(name: str) -> Callable[[Simulation, Log], None]:
        def program(sim: Simulation, log: Log) -> None:
            with condition:
                condition.wait()
                log.append((sim.elapsed_s, name))

        return program

    def notifier(sim: Simulation, log: Log) -> None:
        for _ in range(2):
            sync.sleep(1)
            with condition:
                condition.notify()

    assert run(waiter('first'), waiter('second'), notifier) == [(1.0, 'first'), (2.0, 'second')]


def test_wait_for_looks_again_after_each_notification() -> None:
    condition, box = sync.Condition(), []

    def consumer(sim: Simulation, log: Log) -> None:
        with condition:
            condition.wait_for(lambda: len(box) == 2)
            log.append((sim.elapsed_s, 'full'))

    def producer(sim: Simulation, log: Log) -> None:
        for item in 'ab':
            sync.sleep(1)
            with condition:
                box.append(item)
                condition.notify_all()

    assert run(consumer, producer) == [(2.0, 'full')]


def test_a_semaphore_counts() -> None:
    semaphore = sync.Semaphore(2)

    def worker(name: str) -> Callable[[Simulation, Log], None]:
        def program(sim: Simulation, log: Log) -> None:
            with semaphore:
                log.append((sim.elapsed_s, name))
                sync.sleep(1)

        return program

    assert run(worker('a'), worker('b'), worker('c')) == [(0.0, 'a'), (0.0, 'b'), (1.0, 'c')]


def test_a_bounded_semaphore_refuses_to_grow() -> None:
    with pytest.raises(ValueError, match='too many times'):
        sync.BoundedSemaphore(1).release()

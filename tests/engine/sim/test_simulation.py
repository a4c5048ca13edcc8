"""The agenda and the clock."""

from __future__ import annotations

from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.sim.simulation import EPOCH_NS, Simulation
from edulaunch.errors import SimulationError


def logged(sim: Simulation, log: list[tuple[int, str]], what: str):
    return lambda: log.append((sim.now_ns - EPOCH_NS, what))


def test_items_run_in_order_of_time_then_priority_then_asking() -> None:
    sim, log = Simulation(), []
    sim.schedule(EPOCH_NS + 20, logged(sim, log, 'late'))
    sim.schedule(EPOCH_NS + 10, logged(sim, log, 'second'))
    sim.schedule(EPOCH_NS + 10, logged(sim, log, 'third'))
    sim.schedule(EPOCH_NS + 10, logged(sim, log, 'first'), priority=-1)
    sim.run()
    assert log == [(10, 'first'), (10, 'second'), (10, 'third'), (20, 'late')]


@given(st.lists(st.tuples(st.integers(0, 50), st.integers(-2, 2))))
def test_any_agenda_runs_sorted(asked: list[tuple[int, int]]) -> None:
    sim, log = Simulation(), []
    for number, (at, priority) in enumerate(asked):
        sim.schedule(EPOCH_NS + at, lambda key=(at, priority, number): log.append(key), priority)
    sim.run()
    assert log == sorted((at, priority, number) for number, (at, priority) in enumerate(asked))


def test_a_cancelled_item_never_runs() -> None:
    sim, log = Simulation(), []
    sim.cancel(sim.schedule(EPOCH_NS + 5, logged(sim, log, 'cancelled')))
    sim.schedule(EPOCH_NS + 6, logged(sim, log, 'kept'))
    assert sim.next_time_ns() == EPOCH_NS + 6
    sim.run()
    assert log == [(6, 'kept')]


def test_run_until_stops_the_clock_exactly_there() -> None:
    sim, log = Simulation(), []
    sim.schedule(EPOCH_NS + 10, logged(sim, log, 'at the limit'))
    sim.schedule(EPOCH_NS + 11, logged(sim, log, 'after it'))
    sim.run(EPOCH_NS + 10)
    assert (log, sim.now_ns) == ([(10, 'at the limit')], EPOCH_NS + 10)
    sim.run(EPOCH_NS + 30)
    assert (log[-1], sim.now_ns) == ((11, 'after it'), EPOCH_NS + 30)


def test_stop_ends_the_run_after_the_present_item() -> None:
    sim, log = Simulation(), []
    sim.schedule(EPOCH_NS + 1, lambda: (log.append('one'), sim.stop()))
    sim.schedule(EPOCH_NS + 2, lambda: log.append('two'))
    sim.run()
    assert log == ['one']
    sim.run()
    assert log == ['one', 'two']


def test_the_past_is_closed() -> None:
    with pytest.raises(SimulationError, match='1 ns into the past'):
        Simulation().schedule(EPOCH_NS - 1, lambda: None)


def test_an_empty_agenda_has_no_step() -> None:
    assert Simulation().step() is False


def test_random_generators_depend_on_seed_and_name_only() -> None:
    draws = {(seed, name): Simulation(seed).random(name).random() for seed in (1, 2) for name in ('a', 'b')}
    assert len(set(draws.values())) == 4
    assert Simulation(1).random('a').random() == draws[1, 'a']


def test_a_leap_takes_the_agenda_along() -> None:
    sim, log = Simulation(start_ns=0), []
    for at_ns in (30, 10, 20, 10):
        sim.schedule(at_ns, lambda at_ns=at_ns: log.append((sim.now_ns, at_ns)))
    gone = sim.schedule(15, lambda: log.append(None))
    sim.leap(100)
    sim.leap(50)
    sim.cancel(gone)
    assert sim.now_ns == 100 and sim.next_time_ns() == 110
    sim.run()
    assert log == [(110, 10), (110, 10), (120, 20), (130, 30)]


def test_an_item_that_another_thread_cancels_as_it_is_taken_does_not_break_the_run() -> None:
    class Cancelled(list[Any]):
        looks = 0

        def __getitem__(self, index: Any) -> Any:
            self.looks += index == 3
            return None if index == 3 and self.looks > 1 else super().__getitem__(index)

    sim, log = Simulation(), []
    sim._soon.append(Cancelled([sim.now_ns, 0, 1, lambda: log.append('once')]))
    assert sim.step() and log == ['once']

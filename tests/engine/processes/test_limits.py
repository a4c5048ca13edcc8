"""How much a program may write at one instant of simulated time."""

from __future__ import annotations

import pytest

from edulaunch.engine.processes.limits import MOST_TEXT, MOST_WRITES, WriteLimit
from edulaunch.engine.sim.simulation import Simulation


@pytest.fixture
def limit() -> WriteLimit:
    return WriteLimit(Simulation())


def write(limit: WriteLimit, writes: int, text: str = 'x') -> list[bool]:
    return [limit.is_exceeded_by(text) for _ in range(writes)]


def test_the_last_write_that_is_allowed_and_the_first_that_is_not(limit: WriteLimit) -> None:
    assert write(limit, MOST_WRITES + 2)[-3:] == [False, True, True]
    assert limit.writes == MOST_WRITES + 2


def test_the_last_character_that_is_allowed_and_the_first_that_is_not(limit: WriteLimit) -> None:
    assert write(limit, 1, 'x' * (MOST_TEXT - 1)) + write(limit, 2) == [False, False, True]


def test_for_each_program_whose_output_it_passes_on_it_may_write_as_much_again(limit: WriteLimit) -> None:
    limit.programs = 3
    assert write(limit, 3 * MOST_WRITES + 1)[-2:] == [False, True]
    limit.reset()
    assert write(limit, 3, 'x' * MOST_TEXT) + write(limit, 1) == [False, False, False, True]


def test_another_instant_counts_from_zero(limit: WriteLimit) -> None:
    sim = limit._sim
    assert write(limit, 1, 'x' * (MOST_TEXT + 1)) == [True]
    sim.run(sim.now_ns + 1)
    assert write(limit, 1) == [False] and limit.writes == 1


def test_a_reset_counts_from_zero_at_the_same_instant(limit: WriteLimit) -> None:
    assert write(limit, MOST_WRITES + 1)[-1]
    limit.reset()
    assert write(limit, MOST_WRITES)[-1] is False

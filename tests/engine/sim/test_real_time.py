"""Simulated time that follows a clock while its owner does other things."""

from __future__ import annotations

import pytest

from edulaunch.engine.sim.pacing import RealTime
from edulaunch.engine.sim.simulation import Simulation

S = 1_000_000_000


class Clock:
    """Goes when it is told to."""

    def __init__(self) -> None:
        self.now_s = 100.0

    def __call__(self) -> float:
        return self.now_s


class World:
    """A simulation in which something happens each 100 ms, and a clock."""

    def __init__(self, speed: float = 1.0) -> None:
        self.sim, self.clock = Simulation(start_ns=0), Clock()
        self.time = RealTime(self.sim, speed, clock=self.clock)
        self.said: list[float] = []

    def each(self, period_s: float) -> None:
        def tick() -> None:
            self.said.append(round(self.sim.elapsed_s, 3))
            self.sim.schedule(self.sim.now_ns + round(period_s * S), tick)

        self.sim.schedule(self.sim.now_ns + round(period_s * S), tick)

    def let(self, seconds: float) -> None:
        """Do as an owner does: wait as long as it is told, until so much real time is over."""
        end_s = self.clock.now_s + seconds
        while self.clock.now_s < end_s:
            wait_s = self.time.advance()
            self.clock.now_s = min(end_s, self.clock.now_s + max(1e-6, wait_s if wait_s is not None else seconds))
        self.time.advance()


def test_it_says_how_long_to_wait() -> None:
    world = World()
    assert world.time.advance() is None
    world.each(0.1)
    assert world.time.advance() == 0.1
    world.clock.now_s += 0.04
    assert world.time.advance() == 0.06 and world.said == []


def test_simulated_time_is_real_time() -> None:
    world = World()
    world.each(0.1)
    world.let(0.35)
    assert world.said == [0.1, 0.2, 0.3] and world.sim.elapsed_s == 0.35


def test_time_passes_while_nothing_happens() -> None:
    world = World()
    world.let(5.0)
    assert world.sim.elapsed_s == 5.0


def test_speed_counts_from_where_it_is_changed() -> None:
    world = World(speed=2.0)
    world.let(1.0)
    world.time.speed = 0.5
    world.let(1.0)
    assert world.sim.elapsed_s == 2.5 and world.time.speed == 0.5


def test_time_stands_still_while_paused_and_what_is_due_now_runs() -> None:
    world = World()
    world.time.paused = True
    world.sim.schedule(0, lambda: world.said.append(0.0))
    world.let(3.0)
    assert world.sim.elapsed_s == 0.0 and world.said == [0.0] and world.time.advance() is None
    world.time.paused = False
    world.let(1.0)
    assert world.sim.elapsed_s == 1.0


def test_a_short_delay_is_made_up_for_in_slices_a_long_one_is_lost() -> None:
    world = World()
    world.each(0.01)
    world.clock.now_s += 0.1
    world.time.advance()
    assert len(world.said) < 5  # the owner gets its turn in between
    world.let(0.01)
    assert world.said[-1] == 0.11
    world.clock.now_s += 60.0
    world.let(0.05)
    assert 0.3 < world.sim.elapsed_s < 0.5


def test_on_the_wall_it_is_the_time_of_the_wall_at_once_and_nothing_stays_lost(monkeypatch: pytest.MonkeyPatch) -> None:
    world = World()
    world.each(0.1)
    world.let(0.3)
    monkeypatch.setattr('time.time_ns', lambda: 50 * S)
    world.time.is_wall = True
    assert world.sim.now_ns == 50 * S
    world.said.clear()
    world.let(0.2)
    assert world.said == [50.1, 50.2]
    world.clock.now_s += 7.0
    world.let(0.1)
    assert world.sim.now_ns == round(57.3 * S)
    assert world.said == [50.1, 50.2, 57.2, 57.3]
    world.time.is_wall = False
    world.clock.now_s += 7.0
    world.let(0.1)
    assert world.sim.now_ns < 58 * S  # a part is made up for, the rest stays lost


def test_on_the_wall_neither_speed_nor_pause_change_anything() -> None:
    world = World(speed=4.0)
    world.time.is_wall = True
    world.time.paused = True
    began_ns = world.sim.now_ns
    world.let(0.5)
    assert world.sim.now_ns - began_ns == 5 * S // 10 and not world.time.paused

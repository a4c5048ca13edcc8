"""Keeping pace with a clock on the wall."""

from __future__ import annotations

import pytest

from edulaunch.engine.sim.pacing import Pacer, RealTime
from edulaunch.engine.sim.simulation import Simulation


class Wall:
    """A clock that only waiting moves."""

    def __init__(self) -> None:
        self.now_s = 100.0

    def wait(self, seconds: float) -> None:
        self.now_s += seconds


def paced(speed: float, until_s: float | None, stop_after: int = 100) -> tuple[list[tuple[float, float]], Simulation, Wall]:
    sim, wall, log = Simulation(), Wall(), []
    for second in (1, 2, 3):
        sim.schedule(sim.now_ns + second * 10**9, lambda: log.append((sim.elapsed_s, round(wall.now_s - 100, 3))))
    until = None if until_s is None else sim.now_ns + round(until_s * 1e9)
    Pacer(sim, speed, clock=lambda: wall.now_s, wait=wall.wait).run(until, lambda: len(log) >= stop_after)
    return log, sim, wall


def test_speed_one_is_real_time() -> None:
    assert paced(1.0, None)[0] == [(1.0, 1.0), (2.0, 2.0), (3.0, 3.0)]


def test_speed_four_is_four_times_as_fast() -> None:
    assert paced(4.0, None)[0] == [(1.0, 0.25), (2.0, 0.5), (3.0, 0.75)]


def test_speed_zero_never_waits() -> None:
    assert paced(0.0, None)[0] == [(1.0, 0.0), (2.0, 0.0), (3.0, 0.0)]


def test_it_holds_until_the_end_although_nothing_happens() -> None:
    log, sim, wall = paced(1.0, 5.0)
    assert (len(log), sim.elapsed_s, round(wall.now_s - 100, 3)) == (3, 5.0, 5.0)


def test_it_ends_when_told() -> None:
    assert paced(1.0, None, stop_after=2)[0] == [(1.0, 1.0), (2.0, 2.0)]


def test_a_long_wait_is_cut_into_short_ones() -> None:
    """A stop or Ctrl-C has its effect between two waits."""
    sim, wall, waits = Simulation(), Wall(), []
    sim.schedule(sim.now_ns + 120_000_000, lambda: None)

    def wait(seconds: float) -> None:
        waits.append(round(seconds, 6))
        wall.wait(seconds)

    Pacer(sim, clock=lambda: wall.now_s, wait=wait).run(None, lambda: False)
    assert waits == [0.05, 0.05, 0.02]
    Pacer(sim, clock=lambda: wall.now_s, wait=wait).run(sim.now_ns + 60_000_000, lambda: False)
    assert waits[3:] == [0.05, 0.01]


def test_an_item_at_the_end_runs_and_a_later_one_does_not() -> None:
    assert paced(0.0, 2.0)[0] == [(1.0, 0.0), (2.0, 0.0)]
    assert paced(2.0, 2.5)[1].elapsed_s == 2.5


def test_it_does_not_hold_when_it_is_over() -> None:
    log, sim, wall = paced(1.0, 5.0, stop_after=3)
    assert (len(log), sim.elapsed_s, wall.now_s) == (3, 3.0, 103.0)


def live(speed: float = 1.0, seconds: tuple[float, ...] = (1.0, 2.0)) -> tuple[RealTime, Simulation, Wall, list[float]]:
    sim, wall, log = Simulation(), Wall(), []
    for second in seconds:
        sim.schedule(sim.now_ns + round(second * 1e9), lambda: log.append(sim.elapsed_s))
    return RealTime(sim, speed, clock=lambda: wall.now_s), sim, wall, log


def test_each_turn_runs_what_is_due_and_tells_the_time_until_the_next_item() -> None:
    time, sim, wall, log = live()
    assert time.advance() == 1.0
    wall.wait(0.25)
    assert (time.advance(), sim.elapsed_s) == (0.75, 0.25)
    wall.wait(0.75)
    assert (time.advance(), log) == (1.0, [1.0])
    wall.wait(1.0)
    assert (time.advance(), log, sim.elapsed_s) == (None, [1.0, 2.0], 2.0)


def test_a_speed_changes_from_now_on() -> None:
    time, sim, wall, _ = live(speed=2.0)
    wall.wait(0.25)
    assert (time.advance(), sim.elapsed_s) == (0.25, 0.5)
    time.speed = 4.0
    assert time.speed == 4.0
    wall.wait(0.0625)
    assert (time.advance(), sim.elapsed_s) == (0.0625, 0.75)


def test_a_pause_is_not_made_up_for() -> None:
    time, sim, wall, log = live()
    assert not time.paused
    time.paused = True
    wall.wait(60.0)
    assert (time.paused, time.advance(), sim.elapsed_s) == (True, None, 0.0)
    time.paused = False
    assert (time.paused, time.advance(), log) == (False, 1.0, [])


def test_time_that_nobody_advanced_is_forgotten_when_it_goes_on() -> None:
    time, sim, wall, _ = live()
    wall.wait(0.5)
    time.go_on()
    assert (time.advance(), sim.elapsed_s) == (1.0, 0.0)


@pytest.mark.parametrize(('late_s', 'elapsed_s', 'next_s'), [(0.25, 1.02, 0.75), (10.0, 1.02, 0.75)])
def test_a_long_delay_remains_and_one_turn_is_short(late_s: float, elapsed_s: float, next_s: float) -> None:
    """Ten seconds late is as good as a quarter of a second late, and the owner has its turn after 20 ms."""
    time, sim, wall, log = live()
    wall.wait(1.0 + late_s)
    assert time.advance() == pytest.approx(next_s)
    assert (log, sim.elapsed_s) == ([1.0], elapsed_s)


def test_wall_time_leaps_over_every_delay(monkeypatch: pytest.MonkeyPatch) -> None:
    time, sim, wall, log = live()
    monkeypatch.setattr('time.time_ns', lambda: 1_800_000_000 * 10**9)
    assert not time.is_wall
    time.is_wall = True
    assert time.is_wall and sim.now_ns == 1_800_000_000 * 10**9
    time.paused = True
    assert not time.paused, 'the time of the real world cannot be paused'
    time.speed = 3.0
    wall.wait(7.0)
    time.advance()
    assert sim.now_ns - 1_800_000_000 * 10**9 == pytest.approx(7e9, abs=3e7) and log
    time.is_wall = False
    before = sim.now_ns
    wall.wait(0.1)
    time.advance()
    assert (sim.now_ns - before) / 1e9 == pytest.approx(0.3)

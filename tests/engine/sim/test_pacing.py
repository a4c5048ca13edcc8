"""Keeping pace with a clock on the wall."""

from __future__ import annotations

from edulaunch.engine.sim.pacing import Pacer
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

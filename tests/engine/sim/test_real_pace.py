"""Simulated time that waits for real time."""

from __future__ import annotations

from edulaunch.engine.sim.real_pace import LOOK_EVERY_NS, RealPace
from edulaunch.engine.sim.simulation import Simulation


def test_however_many_ask_it_is_waited_once() -> None:
    sim, real_ns = Simulation(), 0
    pace = RealPace(sim, lambda: real_ns)
    waited_s = []
    for _ in range(100):
        sim.now_ns += LOOK_EVERY_NS
        for _ in range(4):
            waited_s.append(pace.ahead_s())
            real_ns += round(waited_s[-1] * 1e9)
    assert round(sum(waited_s), 6) == 1.0 and waited_s[1:4] == [0, 0, 0]


def test_who_is_late_waits_for_nobody() -> None:
    sim, real_ns = Simulation(), 0
    pace = RealPace(sim, lambda: real_ns)
    sim.now_ns, real_ns = sim.now_ns + LOOK_EVERY_NS, 5 * LOOK_EVERY_NS
    assert pace.ahead_s() == 0
    sim.now_ns += 5 * LOOK_EVERY_NS
    assert pace.ahead_s() == LOOK_EVERY_NS / 1e9


def test_a_long_silence_on_either_side_counts_for_nothing() -> None:
    sim, real_ns = Simulation(), 0
    pace = RealPace(sim, lambda: real_ns)
    sim.now_ns += 3600 * 10**9
    assert pace.ahead_s() == LOOK_EVERY_NS / 1e9
    real_ns += 3600 * 10**9
    sim.now_ns += LOOK_EVERY_NS
    assert pace.ahead_s() == LOOK_EVERY_NS / 1e9
    real_ns += 10**8
    pace.begin()
    sim.now_ns += LOOK_EVERY_NS
    assert pace.ahead_s() == LOOK_EVERY_NS / 1e9

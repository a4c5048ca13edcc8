"""Countdowns of deadlines and leases, and what is counted between two calls of a callback."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest
from rclpy.impl.qos_watch import Count, Countdown, LivelinessWatch, watch_deadline, watch_lease

from edulaunch.engine.graph.qos import MANUAL_BY_TOPIC
from edulaunch.engine.sim.simulation import Simulation


class Watched(SimpleNamespace):
    """An endpoint with a clock of its own."""

    __hash__ = object.__hash__

    def __init__(self, **changes: Any) -> None:
        self.sim = changes.pop('sim', None) or Simulation()
        qos = {'deadline_ns': 10, 'lease_ns': 10, 'liveliness': MANUAL_BY_TOPIC, **changes.pop('qos', {})}
        given = {'kind': 'publisher', 'destroyed': False, 'on_publish': [], 'on_life': [], **changes}
        super().__init__(graph=SimpleNamespace(sim=self.sim), qos=SimpleNamespace(**qos), log=[], **given)

    def note(self) -> None:
        self.log.append(self.sim.now_ns - self.sim.start_ns)

    def at(self, *times: int, act: Any) -> None:
        for time in times:
            self.sim.schedule(self.sim.start_ns + time, act)

    def run(self, until: int) -> list[int]:
        self.sim.run(self.sim.start_ns + until)
        return self.log


@pytest.mark.parametrize(
    ('seen', 'repeat', 'log'),
    [
        ([0], False, [10]),
        ([0], True, [10, 20, 30]),
        ([0, 6], False, [16]),
        ([0, 6, 12], True, [22, 32]),
        ([0, 10], False, [20]),
        ([0, 15], False, [10, 25]),
        ([], True, []),
    ],
)
def test_a_countdown_ends_a_period_after_the_last_message(seen: list[int], repeat: bool, log: list[int]) -> None:
    end = Watched()
    countdown = Countdown(end, 10, end.note, repeat=repeat)
    end.at(*[time for time in seen if time != 10], act=countdown.seen)
    if 10 in seen:
        end.sim.schedule(end.sim.start_ns + 10, countdown.seen, -1)
    assert end.run(34) == log


def test_nothing_expires_of_what_is_destroyed() -> None:
    end = Watched()
    Countdown(end, 10, end.note).seen()
    end.destroyed = True
    assert end.run(50) == []


def test_a_deadline_of_a_publisher_is_kept_by_what_it_sends() -> None:
    end = Watched()
    watch_deadline(end, end.note)
    (seen,) = end.on_publish
    end.at(1, 9, act=seen)
    assert end.run(40) == [19, 29, 39]
    without = Watched(qos={'deadline_ns': 0})
    watch_deadline(without, without.note)
    assert without.on_publish == []


def test_a_deadline_of_a_subscription_is_kept_by_what_it_hears() -> None:
    heard: list[str] = []
    end = Watched(kind='subscription', on_ready=lambda: heard.append('x'))
    watch_deadline(end, end.note)
    end.at(1, 9, act=end.on_ready)
    assert (end.run(20), heard, end.on_publish) == ([19], ['x', 'x'], [])


@pytest.mark.parametrize(('qos', 'is_watched'), [({}, True), ({'lease_ns': 0}, False), ({'liveliness': 'automatic'}, False)])
def test_a_lease_is_watched_if_there_is_one_to_assert(qos: dict[str, Any], is_watched: bool) -> None:
    end = Watched(qos=qos)
    watch_lease(end, end.note)  # type: ignore[arg-type]
    assert len(end.on_life) == is_watched
    end.at(2, act=lambda: [seen() for seen in end.on_life])
    assert end.run(40) == ([12] if is_watched else [])


def test_events_are_counted_until_they_are_taken() -> None:
    told: list[int] = []
    count = Count(lambda *given: given, lambda: told.append(1))
    assert count.take() is None
    count.add('a')
    count.add('b', 'c')
    assert (count.take(), count.take(), len(told)) == ((2, 2, 'b', 'c'), None, 2)
    count.add()
    assert count.take() == (3, 1)


def test_publishers_with_a_lease_live_from_their_first_assertion_to_its_end() -> None:
    sim, told = Simulation(), list[int]()
    own, always = Watched(sim=sim), Watched(sim=sim, qos={'liveliness': 'automatic'})
    subscription: Any = SimpleNamespace(publishers=[own, always], destroyed=False, qos=SimpleNamespace(lease_ns=20))
    watch = LivelinessWatch(subscription, lambda *given: given, lambda: told.append(sim.now_ns - sim.start_ns))
    watch.look()
    assert (watch.take(), watch.take()) == ((1, 1, 1, 1), None)
    for act in own.on_life:
        act()
    watch.look()
    assert (watch.take(), told) == ((2, 0, 1, -1), [0, 0])
    sim.run(sim.start_ns + 30)
    assert (watch.take(), told) == ((1, 1, -1, 1), [0, 0, 20])
    subscription.publishers = [own]
    watch.look()
    assert (watch.take(), told) == ((0, 1, -1, 0), [0, 0, 20, 30])
    subscription.destroyed = True
    subscription.publishers = []
    watch.look()
    assert (watch.take(), len(told)) == ((0, 0, 0, -1), 4)

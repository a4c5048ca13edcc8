"""Rates, sizes and delays that `ros2 topic hz`, `bw` and `delay` compute."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

from edulaunch.desk.cli.ros2 import topic_measuring
from edulaunch.desk.cli.ros2.topic_measuring import Bandwidth, Delay, Rate, Reports, mean, spread

S = 1_000_000_000


@pytest.fixture
def clock(monkeypatch: pytest.MonkeyPatch) -> SimpleNamespace:
    sim = SimpleNamespace(now_ns=0)
    monkeypatch.setattr(topic_measuring, 'current_task', lambda: SimpleNamespace(sim=sim))
    return sim


def test_mean_and_spread() -> None:
    assert mean([1.0, 2.0, 6.0]) == 3.0
    assert spread([1.0, 3.0], 5) == '\tmin: 1.000s max: 3.000s std dev: 1.00000s window: 5'
    assert spread([0.5, 0.5, 2.0], 3) == '\tmin: 0.500s max: 2.000s std dev: 0.70711s window: 3'


@pytest.mark.parametrize(
    ('window', 'times', 'report'),
    [
        (10, [0.0], None),
        (10, [0.0, 0.5], 'average rate: 2.000\n\tmin: 0.500s max: 0.500s std dev: 0.00000s window: 2'),
        (10, [1.0, 1.1, 1.4], 'average rate: 5.000\n\tmin: 0.100s max: 0.300s std dev: 0.10000s window: 3'),
        (2, [0.0, 5.0, 5.1], 'average rate: 10.000\n\tmin: 0.100s max: 0.100s std dev: 0.00000s window: 2'),
        (1, [0.0, 5.0, 5.1], 'average rate: 10.000\n\tmin: 0.100s max: 0.100s std dev: 0.00000s window: 2'),
        (3, [0.0, 5.0, 5.1, 5.2], 'average rate: 10.000\n\tmin: 0.100s max: 0.100s std dev: 0.00000s window: 3'),
        (10, [2.0, 2.0], 'average rate: 0.000\n\tmin: 0.000s max: 0.000s std dev: 0.00000s window: 2'),
    ],
)
def test_a_rate_is_that_of_the_last_messages(window: int, times: list[float], report: str | None) -> None:
    rate = Rate(window, None)
    for time in times:
        rate.take(None, round(time * S))
    assert rate.report() == report


def test_a_rate_of_some_messages() -> None:
    rate = Rate(10, 'm.x > 1')
    for x, time in ((2, 0), (1, 1), (3, 2), (0, 3)):
        rate.take(SimpleNamespace(x=x), time * S)
    assert rate.report() == 'average rate: 0.500\n\tmin: 2.000s max: 2.000s std dev: 0.00000s window: 2'


@pytest.mark.parametrize(
    ('sizes', 'rate', 'sizes_shown'),
    [
        ([500, 1500], '1.00 KB/s', 'mean: 1.00 KB min: 0.50 KB max: 1.50 KB'),
        ([2_000_000], '1.00 MB/s', 'mean: 2.00 MB min: 2.00 MB max: 2.00 MB'),
        ([999_999], '500.00 KB/s', 'mean: 1000.00 KB min: 1000.00 KB max: 1000.00 KB'),
        ([0], '0.00 B/s', 'mean: 0.00 B min: 0.00 B max: 0.00 B'),
        ([7, 500, 1500], '1.00 KB/s', 'mean: 1.00 KB min: 0.50 KB max: 1.50 KB'),
    ],
)
def test_sizes_are_told_in_a_fitting_unit(clock: Any, sizes: list[int], rate: str, sizes_shown: str) -> None:
    bandwidth = Bandwidth(2)
    for size in sizes:
        bandwidth.take(b'x' * size, S)
    clock.now_ns = 3 * S
    report = bandwidth.report()
    assert report is not None
    heading, below = report.split('\n')
    assert rate in heading
    assert below == f'\tMessage size {sizes_shown}'
    clock.now_ns = S
    assert bandwidth.report() is None


def stamped(sec: int, nanosec: int) -> Any:
    return SimpleNamespace(header=SimpleNamespace(stamp=SimpleNamespace(sec=sec, nanosec=nanosec)))


def test_a_delay_is_the_age_of_a_message() -> None:
    delay = Delay(2)
    for sec, nanosec, now in ((0, 0, 9.0), (1, 500_000_000, 2.0), (2, 0, 3.5)):
        delay.take(stamped(sec, nanosec), round(now * S))
    assert delay.report() == 'average delay: 1.000\n\tmin: 0.500s max: 1.500s std dev: 0.50000s window: 2'
    with pytest.raises(RuntimeError, match='msg does not have header'):
        delay.take(SimpleNamespace(), 0)


def test_reports_come_once_a_second_if_there_is_something_to_report(clock: Any, monkeypatch: pytest.MonkeyPatch) -> None:
    said: list[str] = []
    monkeypatch.setattr(topic_measuring, 'say', said.append)
    answers = iter(['one', None, 'two'])
    measure: Any = SimpleNamespace(take=lambda message, now: None, report=lambda: next(answers))
    reports = Reports(measure)
    told = []
    for tenths in (5, 10, 14, 15, 20, 25, 26, 27, 35):
        clock.now_ns = tenths * S // 10
        reports.on_message(None)
        told.append(len(said))
    assert (said, told) == (['one', 'two'], [0, 0, 0, 1, 1, 1, 2, 2, 2])

"""Where a launch stops that is stepped through."""

from __future__ import annotations

from typing import Any

import pytest
from launch.actions import LogInfo

from edulaunch.advice.plan.stepping import Stepper
from edulaunch.advice.plan.steps import Step
from edulaunch.engine.processes import Origin


def step(depth: int = 0, line: int = 1, file: str = '/w/a.launch.py') -> Step:
    found = Step(LogInfo(msg=''), Origin(file, line))
    found.depth = depth
    return found


@pytest.mark.parametrize(
    ('way', 'place', 'stops'),
    [
        ('go', None, [False, False, False]),
        ('into', None, [True, True, True]),
        ('event', None, [False, False, False]),
        ('line', ('a.launch.py', 7), [False, True, False]),
        ('line', ('/w/a.launch.py', 7), [False, True, False]),
        ('line', ('b.launch.py', 7), [False, False, False]),
    ],
)
def test_each_way_has_its_stops(way: str, place: Any, stops: list[bool]) -> None:
    stepper = Stepper()
    stepper.go(way, place)
    assert [stepper.stops_before(one) for one in (step(), step(1, 7), step(2, 8))] == stops


def test_what_launch_makes_itself_is_no_stop() -> None:
    stepper = Stepper()
    stepper.go('into')
    assert not stepper.stops_before(Step(LogInfo(msg='')))


def test_over_an_include_stops_behind_it_and_an_event_is_never_inside() -> None:
    stepper = Stepper()
    stepper.at = step(1)
    stepper.go('next')
    assert [stepper.stops_before(step(depth)) for depth in (2, 3, 1, 0)] == [False, False, True, True]
    assert not stepper.stops_at(Step(object()))
    assert stepper.stops_before(step(5))


def test_an_event_is_a_stop_when_it_is_asked_for() -> None:
    stepper = Stepper()
    stepper.go('event')
    assert stepper.stops_at(Step(object()))

"""The differential-drive robot: exact arcs, limits, memory."""

from __future__ import annotations

from math import inf, nan, pi

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.worlds.planar_robot import PlanarRobot

SECOND = 1_000_000_000


def place(robot: PlanarRobot) -> tuple[float, float, float]:
    return robot.x, robot.y, robot.theta


def test_it_drives_straight_ahead() -> None:
    robot = PlanarRobot(1.0, 0.5, pi / 2)
    robot.command(0.2, 0.0, 0)
    robot.advance_to(5 * SECOND)
    assert place(robot) == pytest.approx((1.0, 1.5, pi / 2))


def test_it_drives_a_circle_of_radius_linear_over_angular() -> None:
    robot = PlanarRobot()
    robot.command(0.1, 0.2, 0)
    robot.advance_to(round(pi / 0.2 * SECOND))
    assert (robot.x, robot.y) == pytest.approx((0.0, 1.0), abs=1e-8)


def test_velocities_are_cut_to_the_waffles_limits() -> None:
    robot = PlanarRobot()
    robot.command(5.0, -7.0, 0)
    assert (robot.linear, robot.angular) == (0.26, -1.82)


@pytest.mark.parametrize('value, expected', [(nan, 0.0), (inf, 0.26), (-inf, -0.26)])
def test_a_command_that_is_no_number_means_zero(value: float, expected: float) -> None:
    robot = PlanarRobot()
    robot.command(value, 0.0, 0)
    assert robot.linear == expected


def test_the_last_command_is_kept() -> None:
    robot = PlanarRobot()
    robot.command(0.1, 0.0, 0)
    robot.advance_to(3600 * SECOND)
    assert robot.x == pytest.approx(360.0)


def test_time_does_not_run_backward() -> None:
    robot = PlanarRobot(time_ns=SECOND)
    robot.command(0.1, 0.0, SECOND)
    robot.advance_to(0)
    assert (place(robot), robot.time_ns) == ((0.0, 0.0, 0.0), SECOND)


@given(st.floats(-0.3, 0.3), st.floats(-2.0, 2.0), st.lists(st.integers(1, SECOND), min_size=1, max_size=30))
def test_the_way_does_not_depend_on_the_step(linear: float, angular: float, steps: list[int]) -> None:
    often, once = PlanarRobot(), PlanarRobot()
    for robot in (often, once):
        robot.command(linear, angular, 0)
    now = 0
    for step in steps:
        now += step
        often.advance_to(now)
    once.advance_to(now)
    assert (often.x, often.y) == pytest.approx((once.x, once.y), abs=1e-9)


def test_a_new_command_ends_the_way_of_the_last_one() -> None:
    robot = PlanarRobot()
    assert robot.time_ns == 0
    robot.command(0.2, 0.0, 0)
    robot.command(0.0, 0.0, 5 * SECOND)
    robot.advance_to(9 * SECOND)
    assert place(robot) == pytest.approx((1.0, 0.0, 0.0))

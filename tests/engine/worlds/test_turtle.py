"""Golden numbers of one turtle's motion, computed from turtlesim's rules (facts_turtlesim.md, section 3)."""

from __future__ import annotations

from math import inf, nan
from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.worlds.drawing import SIDE, as_float32
from edulaunch.engine.worlds.turtle import PI, Turtle
from edulaunch.engine.worlds.turtle_world import TurtleWorld

T0 = 1_700_000_000_000_000_000
TICK = 16_000_000


def ticks(world: TurtleWorld, count: int, start: int = T0) -> int:
    for number in range(count):
        world.update(start + number * TICK)
    return start + count * TICK


@pytest.fixture
def world() -> TurtleWorld:
    return TurtleWorld(Random(1))


@pytest.fixture
def turtle(world: TurtleWorld) -> Turtle:
    return world.spawn_first()


def pose(turtle: Turtle) -> tuple[float, float, float]:
    return as_float32(turtle.x), as_float32(turtle.y), as_float32(turtle.theta)


@pytest.mark.parametrize(
    'linear, angular, expected',
    [
        (2.0, 0.0, (7.560444355010986, 5.544444561004639, 0.0)),
        (2.0, 1.8, (6.602816581726074, 6.938989639282227, 1.8143999576568604)),
        (0.0, 2.0, (5.544444561004639, 5.544444561004639, 2.0160000324249268)),
    ],
)
def test_one_command_acts_for_63_ticks(
    world: TurtleWorld, turtle: Turtle, linear: float, angular: float, expected: tuple[float, float, float]
) -> None:
    turtle.command(linear, angular, T0)
    ticks(world, 63)
    assert pose(turtle) == expected
    ticks(world, 20, T0 + 63 * TICK)
    assert pose(turtle) == expected


def test_a_command_each_second_gives_motion_without_a_gap(world: TurtleWorld, turtle: Turtle) -> None:
    now = T0
    speeds = []
    for number in range(200):
        if number % 62 == 0:
            turtle.command(1.0, 0.5, now)
        now = ticks(world, 1, now)
        speeds.append(turtle.linear_velocity)
    assert set(speeds) == {1.0}


def test_velocity_is_a_magnitude(world: TurtleWorld, turtle: Turtle) -> None:
    turtle.command(-3.0, 0.0, T0, sideways=4.0)
    ticks(world, 1)
    assert turtle.linear_velocity == 5.0
    turtle.command(-3.0, 0.0, T0, sideways=0.0)
    assert turtle.linear_velocity == 3.0


def test_a_wall_stops_the_turtle_but_not_its_velocity(world: TurtleWorld, turtle: Turtle) -> None:
    turtle.teleport_absolute(11.0, 1.0, 0.0)
    turtle.command(20.0, 0.0, T0)
    ticks(world, 1)
    assert turtle.wall_hit == (pytest.approx(11.32), SIDE - 1.0)
    assert (turtle.x, turtle.linear_velocity) == (SIDE, 20.0)
    ticks(world, 1, T0 + TICK)
    assert turtle.wall_hit is not None


def test_spawning_outside_is_put_right_by_the_first_update(world: TurtleWorld) -> None:
    turtle = world.spawn(-3.0, 20.0, 0.0)
    assert turtle is not None
    world.update(T0)
    assert turtle.wall_hit == (-3.0, as_float32(SIDE - 20.0))
    assert (turtle.x, turtle.y) == (0.0, SIDE)
    world.update(T0 + TICK)
    assert turtle.wall_hit is None


def test_teleport_above_the_top_hits_no_wall(world: TurtleWorld, turtle: Turtle) -> None:
    turtle.teleport_absolute(1.0, 99.0, 0.0)
    world.update(T0)
    assert (turtle.x, turtle.y, turtle.wall_hit) == (1.0, SIDE, None)


def test_teleports_are_executed_in_order_in_the_next_update(world: TurtleWorld, turtle: Turtle) -> None:
    turtle.teleport_absolute(2.0, 2.0, 0.0)
    turtle.teleport_relative(1.0, PI / 2.0)
    assert pose(turtle)[:2] == (5.544444561004639, 5.544444561004639)
    world.update(T0)
    assert pose(turtle) == pytest.approx((2.0, 3.0, PI / 2.0))


def test_a_teleport_does_not_stop_the_turtle(world: TurtleWorld, turtle: Turtle) -> None:
    turtle.command(1.0, 0.0, T0)
    turtle.teleport_absolute(2.0, 2.0, 0.0)
    ticks(world, 63)
    assert turtle.x == pytest.approx(2.0 + 63 * 0.016)


@pytest.mark.parametrize(
    'theta, count, first, last, delta',
    [
        (1.57, 98, [1.5700000524520874, 1.5540000200271606, 1.5380001068115234], 0.018000006675720215, -1.5520000457763672),
        (0.7854, 49, [], None, -0.7680000066757202),
        (3.1416, 197, [-3.141585350036621], None, 3.135999917984009),
        (-2.3562, 148, [], None, 2.3519999980926514),
        (0.0, 1, [0.0], 0.0, 0.0),
    ],
)
def test_rotation_goals_step_as_in_the_golden_runs(
    world: TurtleWorld, turtle: Turtle, theta: float, count: int, first: list[float], last: float | None, delta: float
) -> None:
    goal = turtle.rotate_to(as_float32(theta))
    feedback = []
    while not turtle.turned:
        world.update(T0 + len(feedback) * TICK)
        feedback.append(goal.remaining)
    assert (len(feedback), goal.delta) == (count, delta)
    assert feedback[: len(first)] == first
    assert last is None or feedback[-1] == last
    assert (turtle.rotation, turtle.linear_velocity, turtle.turning) == (None, 0.0, 0.0)


@given(st.floats(-30.0, 30.0), st.floats(-30.0, 30.0), st.floats(-30.0, 30.0), st.integers(1, 80))
def test_a_turtle_stays_on_the_canvas_and_its_heading_in_one_turn(
    linear: float, angular: float, sideways: float, count: int
) -> None:
    world = TurtleWorld(Random(1))
    turtle = world.spawn_first()
    turtle.command(linear, angular, T0, sideways)
    ticks(world, count)
    assert 0.0 <= turtle.x <= SIDE and 0.0 <= turtle.y <= SIDE
    assert -PI <= turtle.theta < PI + 1e-9


@given(st.lists(st.sampled_from([nan, inf, -inf, 1e300, -1e300, 3.0]), min_size=5, max_size=5))
def test_numbers_that_are_none_never_stop_the_world(numbers: list[float]) -> None:
    world = TurtleWorld(Random(1))
    turtle = world.spawn_first()
    turtle.command(numbers[0], numbers[1], T0)
    turtle.teleport_absolute(numbers[2], numbers[3], numbers[4])
    ticks(world, 3)
    assert turtle.color in ((255, 255, 255), (179, 184, 255))


def test_a_turtle_is_still_when_it_has_no_velocity_and_did_not_move(world: TurtleWorld, turtle: Turtle) -> None:
    seen = []
    for number, act in enumerate((None, None, 'go', None, 'stop', None, 'teleport', None)):
        if act == 'go':
            turtle.command(1.0, 0.0, T0 + number * TICK)
        elif act == 'stop':
            turtle.stop()
        elif act == 'teleport':
            turtle.teleport_absolute(1.0, 1.0, 0.0)
        world.update(T0 + number * TICK)
        seen.append(turtle.still)
    assert seen == [False, True, False, False, False, True, False, True]

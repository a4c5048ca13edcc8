"""What pens leave on the canvas and what the colour sensor reads of it."""

from __future__ import annotations

from random import Random

import pytest

from edulaunch.engine.worlds.drawing import METRE_PX, SIDE, UNTOUCHED, DrawingLayer, Pen
from edulaunch.engine.worlds.turtle import Turtle
from edulaunch.engine.worlds.turtle_world import TurtleWorld

T0 = 10**18
TICK = 16_000_000
TRAIL = (179, 184, 255)
RED = (255, 0, 0)


@pytest.fixture
def world() -> TurtleWorld:
    return TurtleWorld(Random(1))


@pytest.fixture
def turtle(world: TurtleWorld) -> Turtle:
    return world.spawn_first()


def at_pixel(layer: DrawingLayer, column: int, row: int) -> tuple[int, int, int]:
    return layer.color_at(column / METRE_PX, row / METRE_PX)


def test_the_side_of_the_canvas_is_single_precision() -> None:
    assert SIDE == 11.088889122009277


def test_an_untouched_canvas_reads_white(turtle: Turtle, world: TurtleWorld) -> None:
    world.update(T0)
    assert turtle.color == UNTOUCHED == (255, 255, 255)


def test_the_sensor_sees_the_trail_one_tick_late(turtle: Turtle, world: TurtleWorld) -> None:
    turtle.command(1.0, 0.0, T0)
    colors = []
    for number in range(3):
        world.update(T0 + number * TICK)
        colors.append(turtle.color)
    assert colors == [UNTOUCHED, TRAIL, TRAIL]


@pytest.mark.parametrize(
    'width, rows', [(0, [100]), (1, [100]), (2, [100, 101]), (3, [99, 100, 101]), (5, [98, 99, 100, 101, 102])]
)
def test_a_line_is_as_wide_as_its_pen(width: int, rows: list[int]) -> None:
    layer = DrawingLayer()
    layer.draw(Pen(RED, width), 50 / METRE_PX, 100 / METRE_PX, 90 / METRE_PX, 100 / METRE_PX)
    assert [row for row in range(90, 111) if at_pixel(layer, 70, row) == RED] == rows


def test_a_long_line_has_no_gap() -> None:
    layer = DrawingLayer()
    layer.draw(Pen(RED, 1), 0.0, 0.0, 499 / METRE_PX, 250 / METRE_PX)
    for column in range(500):
        row = round(column * 250 / 499)
        assert RED in [at_pixel(layer, column, row + offset) for offset in (-1, 0, 1)]


def test_a_line_that_leaves_the_canvas_is_cut_there() -> None:
    layer = DrawingLayer()
    layer.draw(Pen(RED, 3), 5.0, 5.0, 1e9, 5.0)
    assert at_pixel(layer, 499, 225) == RED
    assert at_pixel(layer, 0, 226) == UNTOUCHED
    layer.draw(Pen((0, 255, 0), 3), -7.0, 20.0, -3.0, 20.0)
    assert at_pixel(layer, 0, 499) == UNTOUCHED


def test_a_lifted_pen_draws_nothing(turtle: Turtle, world: TurtleWorld) -> None:
    turtle.set_pen(RED, 7, off=True)
    turtle.command(1.0, 0.0, T0)
    world.update(T0)
    turtle.teleport_absolute(turtle.x, turtle.y, 0.0)
    world.update(T0 + TICK)
    assert (turtle.color, turtle.pen.color) == (UNTOUCHED, TRAIL)


def test_a_new_pen_colours_what_follows(turtle: Turtle, world: TurtleWorld) -> None:
    turtle.set_pen(RED, 5, off=False)
    turtle.teleport_absolute(1.0, 1.0, 0.0)
    world.update(T0)
    assert turtle.color == RED
    assert [at_pixel(world.drawing, column, 499 - column) for column in (45, 150, 249)] == [RED] * 3
    assert [at_pixel(world.drawing, column, 350) for column in (143, 155)] == [UNTOUCHED] * 2


def test_clear_wipes_the_drawing_and_a_resting_turtle_sees_it(turtle: Turtle, world: TurtleWorld) -> None:
    turtle.command(1.0, 0.0, T0)
    for number in range(70):
        world.update(T0 + number * TICK)
    assert turtle.color == TRAIL
    world.clear()
    world.update(T0 + 70 * TICK)
    assert turtle.color == UNTOUCHED == at_pixel(world.drawing, 260, 250)


def test_a_resting_turtle_sees_the_line_another_one_draws_over_it(turtle: Turtle, world: TurtleWorld) -> None:
    other = world.spawn(5.0, 5.544444561004639, 0.0)
    assert other is not None
    other.set_pen(RED, 3, off=False)
    other.command(30.0, 0.0, T0)
    for number in range(4):
        world.update(T0 + number * TICK)
    assert turtle.color == RED


def test_a_turtle_that_jumps_with_its_pen_up_reads_the_place_it_came_to(turtle: Turtle, world: TurtleWorld) -> None:
    turtle.teleport_absolute(1.0, 5.0, 0.0)
    world.update(T0)
    turtle.set_pen(RED, 3, off=True)
    turtle.teleport_absolute(9.0, 9.0, 0.0)
    world.update(T0 + TICK)
    assert turtle.color == UNTOUCHED


@pytest.mark.parametrize('width', [1, 2, 3, 40])
@pytest.mark.parametrize('speed', [0.05, 1.0])
def test_a_turtle_on_its_way_reads_and_leaves_what_single_looks_and_lines_do(width: int, speed: float) -> None:
    traced, drawn = DrawingLayer(), DrawingLayer()
    pens = Pen(RED, width), Pen(RED, width)
    place = (0.0, 3.0)
    for tick in range(300):
        to = (place[0] + 0.016 * speed, 3.0 + 0.05 * (tick % 100 == 99))
        color = drawn.color_at(*to)
        drawn.draw(pens[1], *place, *to)
        assert traced.trace(pens[0], *place, *to) == color
        if tick == 150:  # somebody else draws over it
            for layer in (traced, drawn):
                layer.draw(Pen((0, 9, 0), 5), 0.0, 3.0, *to)
        place = to
    assert traced._pixels == drawn._pixels

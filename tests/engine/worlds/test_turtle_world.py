"""Who lives in the turtle world: names, order, killing and starting over."""

from __future__ import annotations

from random import Random

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.engine.worlds.turtle_world import CENTER, PICTURES, TurtleWorld


@pytest.fixture
def world() -> TurtleWorld:
    return TurtleWorld(Random(1))


def test_turtles_are_in_alphabetical_order(world: TurtleWorld) -> None:
    for _ in range(10):
        world.spawn(1.0, 1.0, 0.0)
    assert [turtle.name for turtle in world.turtles][:3] == ['turtle1', 'turtle10', 'turtle2']


def test_the_first_turtle_stands_in_the_middle(world: TurtleWorld) -> None:
    turtle = world.spawn_first()
    assert (turtle.x, turtle.y, turtle.theta) == (CENTER, CENTER, 0.0)
    assert CENTER == 5.544444561004639


def test_a_taken_name_spawns_nothing(world: TurtleWorld) -> None:
    world.spawn(1.0, 1.0, 0.0, 'bob')
    assert world.spawn(2.0, 2.0, 0.0, 'bob') is None
    assert len(world.turtles) == 1


def test_automatic_names_skip_taken_ones_and_are_not_used_again(world: TurtleWorld) -> None:
    world.spawn(1.0, 1.0, 0.0, 'turtle2')
    names = [world.spawn(1.0, 1.0, 0.0).name for _ in range(2)]  # type: ignore[union-attr]
    assert names == ['turtle1', 'turtle3']
    world.kill('turtle3')
    assert world.spawn(1.0, 1.0, 0.0).name == 'turtle4'  # type: ignore[union-attr]


def test_killing_a_stranger_says_so(world: TurtleWorld) -> None:
    world.spawn_first()
    assert world.kill('turtle1')
    assert not world.kill('turtle1')


def test_starting_over_counts_from_turtle1(world: TurtleWorld) -> None:
    world.spawn_first()
    world.spawn(1.0, 1.0, 0.0)
    world.remove_all()
    assert [world.spawn_first().name] == [turtle.name for turtle in world.turtles] == ['turtle1']


def test_pictures_repeat_with_the_seed() -> None:
    worlds = [TurtleWorld(Random(5)) for _ in range(2)]
    pictures = [[world.spawn(1.0, 1.0, 0.0).picture for _ in range(20)] for world in worlds]  # type: ignore[union-attr]
    assert pictures[0] == pictures[1]
    assert all(0 <= picture < len(PICTURES) for picture in pictures[0])


@given(st.lists(st.sampled_from(['', 'turtle1', 'turtle2', 'bob', '-turtle1', '-bob']), max_size=20))
def test_names_are_never_shared(orders: list[str]) -> None:
    world = TurtleWorld(Random(1))
    for order in orders:
        if order.startswith('-'):
            world.kill(order[1:])
        else:
            world.spawn(1.0, 1.0, 0.0, order)
    names = [turtle.name for turtle in world.turtles]
    assert names == sorted(set(names))

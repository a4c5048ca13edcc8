"""Robots from above."""

from __future__ import annotations

from pathlib import Path

import pytest

from edulaunch.canvas.outlines import Part, outline_of, outline_of_footprint

BURGER = Path(__file__).parents[2] / 'edulaunch/ros/share/turtlebot3_gazebo/urdf/turtlebot3_burger.urdf'


def extent(part: Part) -> tuple[float, float, float, float]:
    xs, ys = zip(*part.corners, strict=True)
    return min(xs), max(xs), min(ys), max(ys)


def test_a_burger_has_two_wheels_below_a_square() -> None:
    parts = outline_of(BURGER.read_text())
    assert [part.kind for part in parts] == ['wheel', 'wheel', 'body', 'nose']
    assert extent(parts[2]) == (-0.07, 0.07, -0.07, 0.07)
    left = next(part for part in parts[:2] if part.corners[0][1] > 0)
    assert extent(left) == pytest.approx((-0.033, 0.033, 0.071, 0.089), abs=2e-4)


def urdf(geometry: str, origin: str = '', more: str = '') -> str:
    return f'<robot name="r"><link name="base"><visual>{origin}<geometry>{geometry}</geometry></visual>{more}</link></robot>'


def test_turned_shapes_are_seen_from_above() -> None:
    box, nose = outline_of(urdf('<box size="2 1 0.2"/>', '<origin xyz="1 0 0" rpy="0 0 1.5707963"/>'))
    assert extent(box) == (0.5, 1.5, -1.0, 1.0)
    assert nose.kind == 'nose' and nose.corners[0] == (1.5, 0.0)
    tipped, _ = outline_of(urdf('<box size="2 1 0.2"/>', '<origin rpy="0 1.5707963 0"/>'))
    assert extent(tipped) == (-0.1, 0.1, -0.5, 0.5)
    ball, _ = outline_of(urdf('<sphere radius="0.5"/>', '<origin xyz="0 2 0"/>'))
    assert extent(ball) == (-0.5, 0.5, 1.5, 2.5)


def test_collision_shapes_count_before_visual_ones_and_meshes_are_not_known() -> None:
    collision = '<collision><geometry><cylinder radius="0.2" length="0.1"/></geometry></collision>'
    part, _ = outline_of(urdf('<box size="2 1 0.2"/>', more=collision))
    assert extent(part) == (-0.2, 0.2, -0.2, 0.2)
    mesh = '<collision><geometry><mesh filename="package://a/b.stl"/></geometry></collision>'
    part, _ = outline_of(urdf('<box size="2 1 0.2"/>', more=mesh))
    assert extent(part) == (-1.0, 1.0, -0.5, 0.5)


@pytest.mark.parametrize(
    'text',
    [
        '',
        'no xml',
        '<robot/>',
        urdf('<box size="1 2"/>'),
        urdf('<box size="nan 1 1"/>'),
        urdf('<cylinder/>'),
        '<!DOCTYPE a [<!ENTITY b "c">]><robot/>',
        '<robot><link name="a"/><joint name="j"><parent link="a"/><child link="a"/></joint></robot>',
    ],
)
def test_what_is_no_robot_has_no_outline(text: str) -> None:
    assert outline_of(text) == []


def test_a_footprint_is_a_polygon_or_a_circle() -> None:
    part, _ = outline_of_footprint('[[0.2, 0.1], [-0.2, 0.1], [-0.2, -0.1], [0.2, -0.1]]')
    assert extent(part) == (-0.2, 0.2, -0.1, 0.1)
    assert extent(outline_of_footprint('0.22')[0]) == (-0.22, 0.22, -0.22, 0.22)
    assert (
        outline_of_footprint('[]')
        == outline_of_footprint('{')
        == outline_of_footprint('"x"')
        == outline_of_footprint('[1]')
        == []
    )

"""Names that do not cover one another."""

from __future__ import annotations

from collections.abc import Sequence

import pytest
from hypothesis import given
from hypothesis import strategies as st
from matplotlib.axes import Axes

from edulaunch.canvas.sheet import (
    Box,
    Sheet,
    along,
    box_of,
    layout,
    leader,
    place_labels,
    png_of,
    points_of,
    rgb,
    rows_of,
    side_of,
    world,
)
from edulaunch.canvas.style import BLUE

BOUNDS = Box(0, 0, 400, 400)


def test_a_lone_label_stands_above_its_point() -> None:
    assert place_labels([(200, 200)], [(40, 12)], BOUNDS, 8) == [Box(180, 208, 220, 220)]


def test_at_the_upper_border_it_stands_below() -> None:
    assert place_labels([(200, 398)], [(40, 12)], BOUNDS, 8)[0].top == 390


def test_what_is_taken_is_left_free() -> None:
    taken = [Box(150, 201, 250, 240)]
    assert place_labels([(200, 200)], [(40, 12)], BOUNDS, 8, taken)[0].overlap(taken[0]) == 0


@given(st.lists(st.tuples(st.floats(60, 340), st.floats(60, 340)), min_size=1, max_size=8))
def test_few_labels_never_overlap_even_at_one_point(anchors: list[tuple[float, float]]) -> None:
    boxes = place_labels(anchors, [(50.0, 12.0)] * len(anchors), BOUNDS, 6)
    assert all(one.overlap(other) == 0 for number, one in enumerate(boxes) for other in boxes[:number])


def test_a_far_label_gets_a_leader_and_a_near_one_none() -> None:
    assert leader((0, 0), Box(30, 5, 60, 20)) == (30, 5)
    assert leader((0, 0), Box(-10, 6, 10, 18)) is None


def test_boxes_along_a_line_reach_from_end_to_end() -> None:
    boxes = along((0, 0), (30, 0))
    assert (boxes[0].left, boxes[-1].right) == (-3, 33)
    assert all(b.left <= a.right for a, b in zip(boxes, boxes[1:], strict=False))


@pytest.mark.parametrize(
    ('other', 'area'),
    [
        (Box(5, 5, 20, 20), 25.0),
        (Box(10, 0, 20, 10), 0.0),
        (Box(0, 10, 10, 20), 0.0),
        (Box(2, 3, 4, 7), 8.0),
        (Box(-20, -20, -10, -10), 0.0),
    ],
)
def test_the_area_that_two_boxes_share(other: Box, area: float) -> None:
    box = Box(0, 0, 10, 10)
    assert (box.overlap(other), other.overlap(box)) == (area, area)
    assert other.outside(box) == (other.right - other.left) * (other.top - other.bottom) - area


def test_the_next_places_are_below_right_and_left() -> None:
    """Each label covers the place of the one before it, so each takes the next free place."""
    boxes = place_labels([(200, 200)] * 5, [(40, 12)] * 5, BOUNDS, 8)
    assert boxes == [
        Box(180, 208, 220, 220),
        Box(180, 180, 220, 192),
        Box(208, 194, 248, 206),
        Box(152, 194, 192, 206),
        Box(180, 222, 220, 234),  # the third ring above: all places of the first two cover a label
    ]


def test_a_label_that_fits_nowhere_covers_as_little_as_possible() -> None:
    taken = [Box(0, 0, 400, 220), Box(0, 240, 400, 400)]
    (box,) = place_labels([(200, 200)], [(40, 12)], BOUNDS, 8, taken)
    assert box.overlap(taken[0]) == box.overlap(taken[1]) == 0.0, 'a further ring is free'
    (box,) = place_labels([(200, 200)], [(40, 12)], BOUNDS, 8, [BOUNDS])
    assert box == Box(180, 208, 220, 220), 'the nearest place, if all cover the same'


@pytest.mark.parametrize(
    ('box', 'end'), [(Box(12, -5, 20, 5), None), (Box(13, -5, 20, 5), (13, 0)), (Box(-30, -25, -10, -20), (-10, -20))]
)
def test_a_leader_ends_at_the_nearest_point_of_its_label(box: Box, end: tuple[float, float] | None) -> None:
    assert leader((0, 0), box) == end


def test_boxes_along_a_line_have_their_size_and_a_point_has_two() -> None:
    assert along((0, 0), (0, 12), 2.0) == [Box(-2, y - 2, 2, y + 2) for y in (0, 4, 8, 12)]
    assert along((5, 5), (5, 5)) == [Box(2, 2, 8, 8)] * 2


def test_squares_stand_in_rows_from_the_upper_left() -> None:
    sheet = rows_of(3, 2, side=100, left=30, between=10, above=20, below=15)
    assert (sheet.width, sheet.height) == (280, 270)
    assert sheet.boxes == [Box(30, 150, 130, 250), Box(170, 150, 270, 250), Box(30, 15, 130, 115)]
    assert rows_of(1, 4, 100, 30, 10, 20, 15)[:2] == (140, 135)


def test_the_axes_of_a_picture_stand_where_the_sheet_has_them() -> None:
    sheet, seen = Sheet(200, 100, [Box(20, 10, 120, 60)]), []

    def draw(axes: Sequence[Axes]) -> None:
        (ax,) = axes
        world(ax, (0.0, 10.0, 0.0, 5.0), BLUE, grid=False)
        seen.extend([box_of(ax), side_of(ax), points_of(ax, [(0.0, 0.0), (10.0, 5.0)]), ax.get_facecolor(), ax.get_aspect()])
        seen.append(layout(ax, 50, 25))
        seen.extend([ax.get_ylim(), points_of(ax, [(0.0, 0.0)])])

    png = png_of(sheet, draw, scale=3)
    assert png[16:24] == (600).to_bytes(4, 'big') + (300).to_bytes(4, 'big')
    assert seen[0] == pytest.approx(Box(20, 10, 120, 60)) and seen[1] == pytest.approx(100)
    assert [pytest.approx(place) for place in ((20, 10), (120, 60))] == seen[2]
    assert seen[3] == (*rgb(BLUE), 1.0) and seen[4] == 1.0
    assert seen[5] == pytest.approx(2.0)
    assert seen[6] == (25.0, 0.0) and seen[7] == [pytest.approx((20, 60))]
    assert png_of(sheet, draw, scale=3) == png and b'Software' not in png


def test_a_colour_is_given_to_matplotlib_in_parts_of_one() -> None:
    assert rgb((255, 51, 0)) == (1.0, 0.2, 0.0)

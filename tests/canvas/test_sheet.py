"""Names that do not cover one another."""

from __future__ import annotations

from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas.sheet import Box, along, leader, place_labels

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

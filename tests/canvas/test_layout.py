"""Rules that every layout keeps: no two boxes overlap, and no arrow crosses a box."""

from __future__ import annotations

import json
from pathlib import Path
from typing import Any

import pytest
from hypothesis import given, settings
from hypothesis import strategies as st

from edulaunch.canvas.layout import Layout, lay_out

sizes = st.tuples(st.integers(30, 200).map(float), st.integers(26, 60).map(float))
graphs = st.lists(sizes, min_size=1, max_size=14).flatmap(
    lambda boxes: st.tuples(
        st.just(boxes),
        st.lists(
            st.tuples(st.integers(0, len(boxes) - 1), st.integers(0, len(boxes) - 1)).filter(lambda edge: edge[0] != edge[1]),
            max_size=20,
            unique=True,
        ),
    )
)
CASES = json.loads(Path(__file__).with_name('layouts.json').read_text(encoding='utf-8'))
"""Layouts that the page's own code (`desk/view/page/layout.js`) makes, too: see tests/browser/test_layout.py."""
Graph = tuple[list[tuple[float, float]], list[tuple[int, int]]]


def rectangles(layout: Layout, boxes: list[tuple[float, float]]) -> list[tuple[float, float, float, float]]:
    return [(x, y, x + width, y + height) for (x, y), (width, height) in zip(layout.corners, boxes, strict=True)]


@given(graphs, st.sampled_from(['right', 'down']))
def test_no_two_boxes_overlap(graph: Graph, direction: str) -> None:
    boxes, edges = graph
    places = rectangles(lay_out(boxes, edges, direction), boxes)
    for number, (left, top, right, bottom) in enumerate(places):
        for other in places[:number]:
            assert right <= other[0] or other[2] <= left or bottom <= other[1] or other[3] <= top


@given(graphs, st.sampled_from(['right', 'down']))
@settings(max_examples=60)
def test_no_arrow_crosses_a_box(graph: Graph, direction: str) -> None:
    """A straight stretch may touch its own two boxes only; an S-curve lies in the gap between two layers."""
    boxes, edges = graph
    layout = lay_out(boxes, edges, direction)
    places = rectangles(layout, boxes)
    for edge, route in zip(edges, layout.routes, strict=True):
        for start, end in zip(route.points, route.points[1:], strict=False):
            low, high = (min(start[0], end[0]), min(start[1], end[1])), (max(start[0], end[0]), max(start[1], end[1]))
            hit = [
                number
                for number, (left, top, right, bottom) in enumerate(places)
                if low[0] < right - 0.01
                and left + 0.01 < high[0]
                and low[1] < bottom - 0.01
                and top + 0.01 < high[1]
                or low[0] == high[0]
                and left < low[0] < right
                and low[1] < bottom - 0.01
                and top + 0.01 < high[1]
                or low[1] == high[1]
                and top < low[1] < bottom
                and low[0] < right - 0.01
                and left + 0.01 < high[0]
            ]
            assert set(hit) <= set(edge)


@given(graphs)
@settings(max_examples=60)
def test_all_boxes_and_arrows_are_on_the_sheet(graph: Graph) -> None:
    boxes, edges = graph
    layout = lay_out(boxes, edges)
    for left, top, right, bottom in rectangles(layout, boxes):
        assert left >= 0 and top >= 0 and right <= layout.width + 0.01 and bottom <= layout.height + 0.01
    assert all(
        -0.01 <= x <= layout.width + 0.01 and -0.01 <= y <= layout.height + 0.01
        for route in layout.routes
        for x, y in route.points
    )


def test_an_arrow_begins_and_ends_at_its_boxes() -> None:
    layout = lay_out([(60, 30), (80, 30)], [(0, 1)], 'right')
    (x0, y0), (x1, y1) = layout.routes[0].points[0], layout.routes[0].points[-1]
    assert (x0, y0) == (layout.corners[0][0] + 60, layout.corners[0][1] + 15)
    assert (x1, y1) == (layout.corners[1][0], layout.corners[1][1] + 15)


@pytest.mark.parametrize(('count', 'direction'), [(3, 'right'), (12, 'down')])
def test_a_long_chain_goes_down(count: int, direction: str) -> None:
    assert lay_out([(120.0, 30.0)] * count, [(number, number + 1) for number in range(count - 1)]).direction == direction


@pytest.mark.parametrize('case', CASES)
def test_layouts_are_those_that_the_page_makes(case: dict[str, Any]) -> None:
    edges = [(a, b) for a, b in case['edges']]
    found = lay_out([(width, height) for width, height in case['sizes']], edges, case['direction'])
    assert (found.width, found.height, found.direction) == (case['width'], case['height'], case['chosen'])
    assert [list(corner) for corner in found.corners] == case['corners']
    assert [[list(point) for point in route.points] for route in found.routes] == case['routes']

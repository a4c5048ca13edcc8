"""Pictures on matplotlib's axes: what is drawn where, on our sheet and on the axes of a student."""

from __future__ import annotations

import struct
from collections.abc import Callable
from typing import Any

import matplotlib as mpl
import pytest
from matplotlib.figure import Figure
from matplotlib.patches import FancyBboxPatch, PathPatch

from edulaunch.canvas import plot_distance, plot_frames, plot_graph, plot_tf_tree, plot_turtles, style
from edulaunch.canvas.draw_graph import draw_graph
from edulaunch.canvas.graph_scene import Box as GraphBox
from edulaunch.canvas.graph_scene import GraphScene
from edulaunch.canvas.sheet import Box, Sheet, box_of, png_of, points_of, rgb, side_of, world
from edulaunch.engine.recording import Recording
from tests.canvas.conftest import POSE, TWIST

PLOTS: dict[str, Callable[..., Any]] = {
    'turtles': plot_turtles,
    'frames': plot_frames,
    'tree': plot_tf_tree,
    'graph': plot_graph,
    'distance': lambda recording, **more: plot_distance(recording, 'turtle1', 'world', **more),
}


def texts(ax: Any) -> list[str]:
    return [text for text in (item.get_text() for item in [*ax.texts, ax.title, ax._left_title]) if text]


@pytest.mark.parametrize('name', PLOTS)
def test_a_picture_is_drawn_on_given_axes_which_are_returned(name: str, walk: Callable[..., Recording]) -> None:
    ax = Figure().add_subplot()
    (line,) = ax.plot([1, 2], [1, 2])
    assert PLOTS[name](walk(0.0, 2.0), ax=ax) is ax
    assert line in ax.lines and len(ax.get_children()) > len(Figure().add_subplot().get_children()) + 2
    assert isinstance(PLOTS[name](walk(0.0, 2.0)).png(), bytes)


def test_turtles_stand_in_metres(walk: Callable[..., Recording]) -> None:
    ax = plot_turtles(walk(0.0, 2.0), ax=Figure().add_subplot())
    assert ax.get_xlim() == ax.get_ylim() == pytest.approx((0.0, 11.088889), abs=1e-5)
    (trail,) = ax.lines
    assert [trail.get_xydata()[index].tolist() for index in (0, -1)] == [[2.0, 3.0], [4.0, 3.0]]
    shell = max(ax.patches, key=lambda patch: len(patch.get_xy()))
    assert shell.get_xy()[:-1].mean(axis=0).tolist() == pytest.approx([4.0, 3.0], abs=0.01)
    assert texts(ax) == ['turtle1', '/sim', 't = 2.00 s\n']


def test_the_frames_have_axes_names_and_an_arrow_to_the_parent(walk: Callable[..., Recording]) -> None:
    ax = plot_frames(walk(0.0, 2.0), ax=Figure().add_subplot())
    said = texts(ax)
    assert [said.count(text) for text in ('x', 'y', 'world', 'turtle1', 'fixed frame: world')] == [2, 2, 1, 1, 1]
    arrows = [text for text in ax.texts if text.arrow_patch is not None and text.xy == (0.0, 0.0) and text.xyann == (4.0, 3.0)]
    assert len(arrows) == 1


def test_the_graph_has_a_box_for_each_node_and_topic(walk: Callable[..., Recording]) -> None:
    ax = plot_graph(walk(0.0, 1.0), ax=Figure().add_subplot())
    assert {'/sim', '/broadcaster', 'pose'} <= set(texts(ax)) and not ax.axison


def test_the_distance_is_a_line_in_seconds_and_metres(walk: Callable[..., Recording]) -> None:
    ax = PLOTS['distance'](walk(0.0, 2.0), ax=Figure().add_subplot())
    ends = [line.get_xydata()[index].tolist() for line in ax.lines[1:2] for index in (0, -1)]
    assert ends == [[0.0, pytest.approx(13**0.5)], [2.0, pytest.approx(5.0)]]
    assert ax.get_xlabel() == 'time [s]'


def test_as_many_axes_as_windows(walk: Callable[..., Recording]) -> None:
    axes = Figure().subplots(1, 2)
    with pytest.raises(ValueError, match='ax must have 1 axes, one for each window or tree, not 2'):
        plot_turtles(walk(0.0, 1.0), ax=axes)
    assert plot_turtles(walk(0.0, 1.0), ax=axes[:1]) is not None


def test_the_style_of_a_user_does_not_change_our_pictures(walk: Callable[..., Recording]) -> None:
    plain = plot_turtles(walk(0.0, 1.0)).png()
    with mpl.rc_context({'font.size': 30, 'axes.facecolor': 'black', 'lines.linewidth': 9}):
        assert plot_turtles(walk(0.0, 1.0)).png() == plain


def test_the_file_holds_nothing_but_the_picture() -> None:
    data = png_of(Sheet(5, 5, []), lambda axes: None)
    kinds, position = [], 8
    while position < len(data):
        length = struct.unpack('>I', data[position : position + 4])[0]
        kinds.append(data[position + 4 : position + 8])
        position += 12 + length
    assert {*kinds} == {b'IHDR', b'pHYs', b'IDAT', b'IEND'}


def test_layout_pixels_are_points_whatever_the_scale() -> None:
    seen: list[Any] = []

    def draw(axes: Any) -> None:
        world(axes[0], (0.0, 2.0, 0.0, 2.0), grid=False)
        seen.append((side_of(axes[0]), box_of(axes[0]), points_of(axes[0], [(1.0, 2.0)])))

    for scale in (1, 2):
        png_of(Sheet(60, 60, [Box(10, 20, 50, 60)]), draw, scale)
    assert seen[0] == seen[1]
    assert (seen[0][0], *seen[0][1], *seen[0][2][0]) == pytest.approx((40, 10, 20, 50, 60, 30, 60))


def test_a_letter_that_no_font_has_is_no_warning(maker: Any) -> None:
    maker.frame(0.0, 'world', '\u4e16', 1.0, 1.0)
    assert plot_frames(maker.done(1.0)).png()


def test_what_is_missing_or_does_not_fit_in_a_graph_is_dashed_and_named(maker: Any) -> None:
    """Nobody publishes /cmd: its box and its arrow are dashed, and grey. The arrow of /pose is not."""
    maker.node('/sim', publishes={'/pose': POSE}, hears={'/cmd': TWIST})
    maker.node('/eye', hears={'/pose': POSE})
    ax = plot_graph(maker.done(1.0), ax=Figure().add_subplot())
    boxes = [patch for patch in ax.patches if isinstance(patch, FancyBboxPatch)]
    arrows = [patch for patch in ax.patches if isinstance(patch, PathPatch)]
    assert [sum(patch.get_linestyle() != '-' for patch in patches) for patches in (boxes, arrows)] == [1, 1]
    dashed = next(patch for patch in boxes if patch.get_linestyle() != '-')
    assert dashed.get_edgecolor()[:3] == pytest.approx(rgb(style.MUTED)[:3])
    assert {'no publisher', 'oval: node   box: topic   dashed: an end is missing'} <= set(texts(ax))


def test_what_does_not_fit_in_a_graph_is_red() -> None:
    boxes = [
        GraphBox('node', '/sim', 0.0, 0.0, 60.0, 30.0, ''),
        GraphBox('topic', '/pose', 100.0, 0.0, 60.0, 30.0, 'QoS does not fit'),
    ]
    scene = GraphScene(
        boxes=boxes, arrows=[(0, 1)], routes=[[(60.0, 15.0), (100.0, 15.0)]], width=200, height=60, direction='right'
    )
    ax = Figure().add_subplot()
    draw_graph(scene, [ax])
    edges = [patch.get_edgecolor()[:3] for patch in ax.patches if isinstance(patch, (FancyBboxPatch, PathPatch))]
    red, blue = rgb(style.RED)[:3], rgb(style.BLUE)[:3]
    assert edges == [pytest.approx(red), pytest.approx(blue), pytest.approx(red)]

"""Numbers and distances over time as data and pictures; wrong names are answered with the nearest one; lines with fewer points."""

from __future__ import annotations

import math
from collections.abc import Callable
from typing import Any

import pytest
from hypothesis import given
from hypothesis import strategies as st

from edulaunch.canvas.series_scene import distance_scene, thinned
from edulaunch.engine.recording import Recording
from edulaunch.engine.recording.absent import NothingToDraw, NotRecorded

Walk = Callable[[float, float], Recording]


def test_a_plot_says_what_it_shows(walk: Walk) -> None:
    picture = walk(0.0, 2.0).plot('/turtle1/pose', 'x', 'y')
    assert picture.caption == '/turtle1/pose: x from 2.000 to 4.000, y from 3.000 to 3.000'
    assert picture.png().startswith(b'\x89PNG')


def test_a_plot_goes_on_axes_of_ones_own(walk: Walk) -> None:
    from matplotlib.figure import Figure

    ax = Figure().subplots()
    assert walk(0.0, 2.0).plot('/turtle1/pose', 'x', ax=ax) is ax
    assert [line.get_label() for line in ax.lines] == ['x']


@pytest.mark.parametrize(
    ('topic', 'field', 'error', 'text'),
    [
        ('/turtle1/poes', 'x', NotRecorded, '/turtle1/pose'),
        ('/turtle1/pose', 'thetta', NotRecorded, "did you mean 'theta'"),
        ('/tf', 'transforms', NothingToDraw, 'not a number'),
        ('/turtle1/pose', 'x..y', ValueError, 'not a path of a field'),
        ('/turtle1/cmd_vel', 'linear.x', NothingToDraw, 'nothing was published'),
    ],
)
def test_what_cannot_be_plotted_is_told(walk: Walk, topic: str, field: str, error: type[Exception], text: str) -> None:
    with pytest.raises(error, match=text.replace('(', r'\(')):
        walk(0.0, 1.0).plot(topic, field)


def test_an_element_of_a_list(walk: Walk) -> None:
    rows = walk(0.0, 1.0).series('/tf', 'transforms[0]')
    assert rows[-1][1].child_frame_id == 'turtle1'  # type: ignore[attr-defined]
    with pytest.raises(NotRecorded, match='no element 7, only 1'):
        walk(0.0, 1.0).series('/tf', 'transforms[7]')


def test_a_table_of_messages_shows_both_ends(walk: Walk) -> None:
    table = walk(0.0, 2.0).table('/turtle1/pose', 'x')
    lines = str(table).splitlines()
    assert len(table) == 101
    assert lines[0].split() == ['time', 'x'] and lines[1].split() == ['0.000', '2'] and lines[-1].split() == ['2.000', '4']
    assert '... 61 more' in lines[21]
    assert '<th scope="col"' in table._repr_mimebundle_()['text/html']


def test_a_log_table_is_filtered(demo: Recording) -> None:
    every = demo.log_table()
    assert len(demo.log_table(word='spawning')) < len(every)
    assert {row[2] for row in demo.log_table(process='turtlesim_node-1').rows} == {'turtlesim_node-1'}
    assert len(demo.log_table(level='FATAL')) == 0
    with pytest.raises(ValueError, match='unknown level'):
        demo.log_table(level='LOUD')


def test_a_data_frame_has_the_time_as_its_index(walk: Walk) -> None:
    pytest.importorskip('pandas')
    frame = walk(0.0, 2.0).to_pandas('/turtle1/pose')
    assert list(frame.columns) == ['x', 'y', 'theta', 'linear_velocity', 'angular_velocity']
    assert frame['x'].iloc[-1] == pytest.approx(4.0)
    assert frame.index[-1] == pytest.approx(2.0)


POSE, TF = 'turtlesim/msg/Pose', 'tf2_msgs/msg/TFMessage'


@pytest.fixture
def chase(maker: Any) -> Any:
    """turtle2 comes nearer to turtle1, which stands, at 1 m/s from 3 m on; a frame stands beside turtle1."""
    maker.node('/sim', publishes={'/turtle1/pose': POSE, '/turtle2/pose': POSE})
    maker.node('/broadcaster', publishes={'/tf': TF})
    for step in range(51):
        maker.pose(step / 20, 5.0, 5.0)
        maker.pose(step / 20, 2.0 + step / 20, 5.0, turtle='/turtle2')
        maker.frame(step / 20, 'world', 'carrot1', 5.0, 6.0)
    return maker.done(2.5)


def test_the_distance_falls_and_closeness_is_dated(chase: Any) -> None:
    scene = distance_scene(chase, 'turtle2', 'turtle1', 1.0)
    assert scene.points[0] == (0.0, 3.0) and scene.points[-1] == (2.5, 0.5)
    assert scene.close_since_s == 2.0
    assert scene.caption() == 'turtle2 to turtle1: 3.000 m at t=0.00 s, 0.500 m at t=2.50 s, at most 1 m from t=2.00 s on'


def test_closeness_that_does_not_last_does_not_count(chase: Any) -> None:
    assert distance_scene(chase, 'turtle1', 'turtle2', 0.2).caption().endswith('not close at the end')


def test_a_tf_frame_can_be_followed_too(chase: Any) -> None:
    assert distance_scene(chase, 'turtle1', 'carrot1', 1.0).points[-1] == (2.5, 1.0)


def test_an_unknown_name_is_answered_with_the_known_ones(chase: Any) -> None:
    with pytest.raises(
        KeyError, match="nothing called 'turtle3' moved in this recording; there are: turtle1, turtle2, world, carrot1"
    ):
        distance_scene(chase, 'turtle3', 'turtle1', 1.0)


def test_things_that_never_met_have_no_distance(maker: Any) -> None:
    maker.node('/sim', publishes={'/turtle1/pose': POSE, '/turtle2/pose': POSE})
    maker.pose(0.0, 1.0, 1.0)
    maker.pose(5.0, 1.0, 1.0, turtle='/turtle2')
    with pytest.raises(ValueError, match="'turtle1' and 'turtle2' did not exist at the same time"):
        distance_scene(maker.done(6.0), 'turtle1', 'turtle2', 1.0)


points = st.lists(st.tuples(st.floats(0, 11), st.floats(0, 11)), min_size=2, max_size=40)


def distance_to_line(point: tuple[float, float], line: list[tuple[float, float]]) -> float:
    def to_stretch(a: tuple[float, float], b: tuple[float, float]) -> float:
        dx, dy = b[0] - a[0], b[1] - a[1]
        length = dx * dx + dy * dy
        part = 0.0 if length == 0 else max(0.0, min(1.0, ((point[0] - a[0]) * dx + (point[1] - a[1]) * dy) / length))
        return math.hypot(point[0] - a[0] - part * dx, point[1] - a[1] - part * dy)

    return min(to_stretch(a, b) for a, b in zip(line, line[1:], strict=False))


def test_points_on_a_straight_line_are_left_out() -> None:
    assert thinned([(x / 10, 1.0) for x in range(11)]) == [(0.0, 1.0), (1.0, 1.0)]


def test_a_corner_stays() -> None:
    assert thinned([(0.0, 0.0), (0.5, 0.0), (1.0, 0.0), (1.0, 0.5), (1.0, 1.0)]) == [(0.0, 0.0), (1.0, 0.0), (1.0, 1.0)]


def test_going_back_on_the_same_line_keeps_the_turning_point() -> None:
    assert thinned([(0.0, 0.0), (1.0, 0.0), (0.5, 0.0)]) == [(0.0, 0.0), (1.0, 0.0), (0.5, 0.0)]


def test_a_slow_curve_does_not_drift_away() -> None:
    circle = [(math.cos(step / 200), math.sin(step / 200)) for step in range(1257)]
    kept = thinned(circle)
    assert len(kept) < 100
    assert max(distance_to_line(point, kept) for point in circle) <= 0.0021


@given(points)
def test_thinning_keeps_both_ends_and_invents_nothing(line: list[tuple[float, float]]) -> None:
    kept = thinned(line)
    assert (kept[0], kept[-1]) == (line[0], line[-1])
    assert all(point in line for point in kept)


@given(points)
def test_no_point_left_out_is_further_off_than_the_tolerance(line: list[tuple[float, float]]) -> None:
    kept = thinned(line, 0.01)
    assert max(distance_to_line(point, kept) for point in line) <= 0.0101

"""Numbers of topics as pictures and tables; wrong names are answered with the nearest one."""

from __future__ import annotations

from collections.abc import Callable

import pytest

from edulaunch.recording import Recording
from edulaunch.recording.absent import NothingToDraw, NotRecorded

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
        ('/tf', 'transforms', NothingToDraw, 'no number'),
        ('/turtle1/pose', 'x..y', ValueError, 'no path of a field'),
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
    with pytest.raises(ValueError, match='no level'):
        demo.log_table(level='LOUD')


def test_a_data_frame_has_the_time_as_its_index(walk: Walk) -> None:
    pytest.importorskip('pandas')
    frame = walk(0.0, 2.0).to_pandas('/turtle1/pose')
    assert list(frame.columns) == ['x', 'y', 'theta', 'linear_velocity', 'angular_velocity']
    assert frame['x'].iloc[-1] == pytest.approx(4.0)
    assert frame.index[-1] == pytest.approx(2.0)

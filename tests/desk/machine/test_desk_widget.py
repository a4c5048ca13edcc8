"""The desk as a widget: what is seen where no front end is, and what happens when a page or a kernel goes in mid-run."""

from __future__ import annotations

from types import SimpleNamespace
from typing import Any

import pytest

pytest.importorskip('anywidget')

import edulaunch  # noqa: E402
from edulaunch.desk.machine.desk_widget import DeskWidget, who_is_there  # noqa: E402

DEMO = ('turtle_tf2_py', 'turtle_tf2_demo.launch.py')


def bundle_of(widget: DeskWidget) -> dict[str, Any]:
    bundle = widget._repr_mimebundle_()
    data: dict[str, Any] = bundle[0] if isinstance(bundle, tuple) else bundle
    return data


def test_without_a_front_end_there_is_a_still_and_its_text() -> None:
    with edulaunch.start(*DEMO) as machine:
        machine.run(3)
        data = bundle_of(machine.view())
    assert data['text/plain'] == (
        'live view, t=3.000 s: turtle1 at (5.544, 5.544), turtle2 at (4.000, 2.000); '
        'nodes: /sim, /broadcaster1, /broadcaster2, /listener; frames: turtle1, turtle2'
    )
    assert '<title>t=3.000 s: turtle1 at' in data['image/svg+xml'] and data['image/svg+xml'].count('>turtle2<') == 1
    assert 'application/vnd.jupyter.widget-view+json' in data


def test_where_nothing_moves_the_text_says_who_is_there() -> None:
    with edulaunch.start() as machine:
        assert bundle_of(machine.view())['text/plain'] == 'live view, t=0.000 s: nodes: none'


def test_nbconvert_shows_the_still() -> None:
    nbconvert = pytest.importorskip('nbconvert')
    nbformat = pytest.importorskip('nbformat')
    with edulaunch.start(*DEMO) as machine:
        machine.run(1)
        output = nbformat.v4.new_output('execute_result', data=bundle_of(machine.view()), execution_count=1)
    cell = nbformat.v4.new_code_cell('machine.view()', outputs=[output], execution_count=1)
    html, _ = nbconvert.HTMLExporter().from_notebook_node(nbformat.v4.new_notebook(cells=[cell]))
    assert '<img alt="live view, t=1.000 s: turtle1 at (5.544, 5.544)' in html


def test_a_page_comes_asks_and_goes() -> None:
    with edulaunch.start() as machine:
        widget = machine.view()
        for odd in (None, 'next', {'op': 'next'}, {'page': 3, 'op': 'next'}, {'page': 'never', 'op': 'bye'}):
            widget._take(odd)
        assert machine.pages == []
        widget._take({'page': 'a', 'op': 'next'})
        widget._take({'page': 'b', 'op': 'speed', 'speed': 2.0})
        assert [page.is_shown() for page in machine.pages] == [True, False] and machine.time.speed == 2.0
        widget._take({'page': 'a', 'op': 'next'})
        first, _ = machine.pages
        widget._take({'page': 'b', 'op': 'bye'})
        assert machine.pages == [first]


def test_nodes_that_have_ended_and_hidden_ones_are_not_there() -> None:
    with edulaunch.start() as machine:
        machine.ros2('node list')
        machine.run(1)
        recording = machine.recording()
        assert who_is_there(recording) == 'nodes: none'
    ended = SimpleNamespace(name='/gone', ended_s=0.5)
    here = [SimpleNamespace(name=name, ended_s=None) for name in ('/a', '/_hidden', '/ns/_hidden', '/ns/b')]
    shown = SimpleNamespace(nodes=[ended, *here], duration_s=1.0, frames_at=lambda time_s: {'f': time_s})
    assert who_is_there(shown) == 'nodes: /a, /ns/b; frames: f'  # type: ignore[arg-type]

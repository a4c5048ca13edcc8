"""The desk as a widget: what is seen where no front end is, and what happens when a page or a kernel goes in mid-run."""

from __future__ import annotations

from typing import Any

import pytest

pytest.importorskip('anywidget')

import edulaunch  # noqa: E402
from edulaunch.desk.machine.desk_widget import DeskWidget  # noqa: E402

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

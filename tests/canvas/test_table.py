"""The parameter table."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.canvas.table import yaml_text


@pytest.fixture
def recording(maker: Any) -> Any:
    maker.node('/sim')
    maker.node('/listener')
    maker.parameters += [
        [0, '/sim', 'use_sim_time', False, 'default'],
        [0, '/sim', 'background_r', 69, 'default'],
        [0, '/listener', 'use_sim_time', True, 'launch argument sim'],
        [0, '/listener', 'target_frame', 'carrot<1>', 'demo.yaml line 3'],
    ]
    return maker.done(1.0)


def test_the_text_is_the_golden_table(recording: Any) -> None:
    assert str(recording.parameter_table()).splitlines() == [
        'node       parameter     value        origin',
        '---------  ------------  -----------  -------------------',
        '/sim       background_r  69           default',
        '/listener  use_sim_time  true         launch argument sim',
        "/listener  target_frame  'carrot<1>'  demo.yaml line 3",
    ]


def test_what_every_node_has_is_shown_on_request(recording: Any) -> None:
    assert [row.parameter for row in recording.parameter_table('/sim').rows] == ['background_r']
    assert [row.parameter for row in recording.parameter_table('/sim', every=True).rows] == ['use_sim_time', 'background_r']


def test_the_repr_is_one_line(recording: Any) -> None:
    assert repr(recording.parameter_table()) == '3 parameters of 2 nodes, 2 of them not at their default'


def test_the_notebook_gets_html_and_the_same_as_text(recording: Any) -> None:
    bundle = recording.parameter_table()._repr_mimebundle_()
    assert '<b><code>&#x27;carrot&lt;1&gt;&#x27;</code></b>' in bundle['text/html']
    assert bundle['text/plain'].startswith('node       parameter')


def test_an_unknown_node_is_answered_with_the_known_ones(recording: Any) -> None:
    with pytest.raises(KeyError, match="no node '/simm' in this recording; there are: /sim, /listener"):
        recording.parameter_table('/simm')


def test_values_look_as_in_a_parameter_file() -> None:
    assert [yaml_text(value) for value in (True, 1.5, 'a', [1, 'b'])] == ['true', '1.5', "'a'", "[1, 'b']"]

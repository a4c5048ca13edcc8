"""Views of a recording: a wing registers them, and the loader brings the wing that nobody has imported yet."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.engine import outside
from edulaunch.engine.recording import views


def test_a_view_that_is_there_is_returned_and_a_later_one_takes_its_place(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(outside, 'load_view', lambda name: pytest.fail(f'{name} is there'))
    views.register(length_of_a_test=len)
    assert views.view('length_of_a_test') is len
    views.register(length_of_a_test=max)
    assert views.view('length_of_a_test') is max


def test_the_loader_is_asked_once_for_a_view_that_is_not_there(monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[str] = []

    def load(name: str) -> None:
        asked.append(name)
        views.register(**{name: sum})

    monkeypatch.setattr(outside, 'load_view', load)
    assert views.view('sum_of_a_test') is views.view('sum_of_a_test') is sum
    assert asked == ['sum_of_a_test']


@pytest.mark.parametrize(
    ('method', 'given', 'passed_on'),
    [
        ('plot_turtles', ((1.5,), {'trails': False}), ((1.5,), {'trails': False})),
        ('plot_frames', ((1.5,), {'side': 'xz'}), ((1.5,), {'side': 'xz', 'ax': None})),
        ('plot_tf_tree', ((), {}), ((), {'ax': None})),
        ('plot_graph', ((), {'unused': True}), ((), {'unused': True, 'services': False, 'ax': None})),
        ('plot_distance', (('a', 'b'), {}), (('a', 'b', 1.0), {'ax': None})),
        ('parameter_table', (('/sim',), {}), (('/sim',), {'every': False})),
        ('foxglove', ((), {}), ((0, ()), {})),
        ('replay', (('other',), {}), (('other',), {})),
    ],
)
def test_a_method_of_a_recording_returns_what_its_view_makes(
    monkeypatch: pytest.MonkeyPatch, method: str, given: Any, passed_on: Any
) -> None:
    recording = views.Views()
    monkeypatch.setattr(views, 'view', lambda name: lambda *words, **named: (name, words, named))
    assert getattr(recording, method)(*given[0], **given[1]) == (method, (recording, *passed_on[0]), passed_on[1])

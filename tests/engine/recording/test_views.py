"""Views of a recording: a wing registers them, and the loader brings the wing that nobody has imported yet."""

from __future__ import annotations

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

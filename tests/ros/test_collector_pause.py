"""Pauses of the garbage collector: what was made inside is not looked at again at once, and yet not for ever."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Callable, Iterator
from typing import Any

import pytest

from edulaunch.ros import collector_pause
from edulaunch.ros.collector_pause import MANY, collector_paused


class Knot:
    """Refers to itself."""

    def __init__(self) -> None:
        self.knot = self


@pytest.fixture
def asked(monkeypatch: pytest.MonkeyPatch) -> Iterator[list[str]]:
    """What is asked of the collector, and the generations that it looks at. What other tests have frozen stays frozen, and is not
    counted: to look at all of that takes seconds.
    """
    happened: list[str] = []

    def note(phase: str, info: dict[str, Any]) -> None:
        if phase == 'start':
            happened.append(f'looks at {info["generation"]}')

    def freeze(really: Callable[[], None] = gc.freeze) -> None:
        happened.append('freeze')
        really()

    monkeypatch.setattr(gc, 'freeze', freeze)
    monkeypatch.setattr(gc, 'unfreeze', lambda: happened.append('unfreeze'))
    monkeypatch.setattr(gc, 'get_freeze_count', lambda: 0)
    monkeypatch.setattr(collector_pause._Unseen, 'things', 0)
    monkeypatch.setattr(collector_pause._Unseen, 'has_frozen', False)
    gc.collect()
    gc.callbacks.append(note)
    yield happened
    gc.callbacks.remove(note)


@pytest.mark.parametrize(('things', 'ages'), [(2 * MANY, True), (MANY // 2, False)])
def test_many_things_that_were_made_in_a_pause_are_not_looked_at_again(asked: list[str], things: int, ages: bool) -> None:
    with collector_paused():
        made = [[number] for number in range(things)]
    assert asked == (['freeze', 'unfreeze'] if ages else []) and gc.isenabled()
    assert gc.get_count()[0] < MANY and len(made) == things


def test_garbage_of_many_pauses_goes(asked: list[str], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(collector_pause, 'MOST_UNSEEN', 3 * MANY)
    gone = []
    for _ in range(4):
        with collector_paused():
            knots = [Knot() for _ in range(MANY + 1)]
            gone.append(weakref.ref(knots[0]))
            del knots
    assert asked == ['freeze', 'unfreeze'] * 2 + ['looks at 2'] + ['freeze', 'unfreeze'] and gone[2]() is None


def test_a_pause_in_a_pause_ends_with_the_outer_one() -> None:
    with collector_paused():
        with collector_paused():
            pass
        assert not gc.isenabled()
    assert gc.isenabled()


def test_the_collector_is_back_after_an_error() -> None:
    with pytest.raises(KeyError), collector_paused():
        raise KeyError
    assert gc.isenabled()


def test_a_process_that_shares_frozen_things_keeps_them_so(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(collector_pause._Unseen, 'has_frozen', False)
    counted: list[int] = []

    def count(really: Callable[[], int] = gc.get_freeze_count) -> int:
        counted.append(really())
        return counted[-1]

    gc.freeze()
    monkeypatch.setattr(gc, 'get_freeze_count', count)
    made = []
    for _ in range(3):
        with collector_paused():
            made += [[number] for number in range(2 * MANY)]
    monkeypatch.undo()
    assert gc.get_freeze_count() and made
    assert len(counted) == 1, 'each count walks along all that is frozen'

"""Pauses of the garbage collector: what was made inside is not looked at again at once, and yet not for ever."""

from __future__ import annotations

import gc
import weakref
from collections.abc import Iterator
from typing import Any

import pytest

from edulaunch.ros import collector_pause
from edulaunch.ros.collector_pause import MANY, collector_paused


class Knot:
    """Refers to itself."""

    def __init__(self) -> None:
        self.knot = self


@pytest.fixture
def looked_at() -> Iterator[list[int]]:
    """The generations that the collector looks at meanwhile."""
    generations: list[int] = []

    def note(phase: str, info: dict[str, Any]) -> None:
        if phase == 'start':
            generations.append(info['generation'])

    gc.unfreeze()  # what other tests have frozen
    gc.collect()
    gc.callbacks.append(note)
    yield generations
    gc.callbacks.remove(note)


def test_many_things_that_were_made_in_a_pause_are_not_looked_at_again(looked_at: list[int]) -> None:
    with collector_paused():
        made = [[number] for number in range(2 * MANY)]
    assert looked_at == [] and gc.isenabled()
    assert gc.get_count()[0] < MANY < len(made)


def test_garbage_of_many_pauses_goes(looked_at: list[int], monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(collector_pause, 'MOST_UNSEEN', 3 * MANY)
    monkeypatch.setattr(collector_pause._Unseen, 'things', 0)
    gone = []
    for _ in range(3):
        with collector_paused():
            knots = [Knot() for _ in range(MANY + 1)]
            gone.append(weakref.ref(knots[0]))
            del knots
    assert [one() for one in gone] == [None] * 3 and looked_at == [2]


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


def test_a_process_that_shares_frozen_things_keeps_them_so(looked_at: list[int]) -> None:
    gc.freeze()
    with collector_paused():
        made = [[number] for number in range(2 * MANY)]
    assert gc.get_freeze_count() and made

"""edugrade.library.close: what is close passes, what is near gives a share of the points."""

from __future__ import annotations

import math
from types import SimpleNamespace
from typing import Any

import pytest
from edugrade.evidence import Mismatch
from edugrade.library.close import require_close

RUN: Any = SimpleNamespace(
    scenario=lambda name: SimpleNamespace(words=f'{name} values'), source=SimpleNamespace(place=('a.py', 3))
)


def share_of(seen: float, **options: Any) -> float:
    with pytest.raises(Mismatch) as raised:
        require_close(RUN, 'usual', 'the speed', seen, 1.0, 0.25, **options)
    return raised.value.share


@pytest.mark.parametrize('seen', [0.75, 1.0, 1.25])
def test_a_number_within_the_tolerance_passes(seen: float) -> None:
    require_close(RUN, 'usual', 'the speed', seen, 1.0, 0.25)


def test_a_number_outside_gives_nothing_unless_it_is_near() -> None:
    assert share_of(1.5) == 0.0
    assert share_of(1.5, near=0.5) == 0.5  # on its edge
    assert share_of(0.5, near=0.5, share=0.25) == 0.25
    assert share_of(1.625, near=0.5) == 0.0
    assert share_of(math.nan, near=0.5) == 0.0


def test_the_sentence_names_the_thing_and_the_numbers() -> None:
    with pytest.raises(Mismatch) as raised:
        require_close(RUN, 'usual', 'the speed', 2.0, 1.0, 0.25)
    assert str(raised.value) == 'the speed should be 1 ± 0.25 in the run with usual values'
    assert (raised.value.seen, raised.value.where) == ('2', ('a.py', 3))

"""Whatever a stranger's file or a command line holds: an answer or a sentence, never a traceback of ours.

`python -m tests.fuzz.targets NAME COUNT` tries more inputs than these.
"""

from __future__ import annotations

import os
from pathlib import Path

import pytest

from tests.fuzz.targets import TARGETS, attempt, printed_kind

INPUTS = 60 if os.environ.get('EDULAUNCH_THOROUGH') else 12
FOUND: dict[str, tuple[int, ...]] = {'command': (6005490,), 'recording': (6001367,)}
"""Inputs that once ended in a traceback of ours."""


@pytest.mark.parametrize('name', TARGETS)
def test_no_input_ends_in_a_traceback_of_ours(name: str, tmp_path: Path) -> None:
    numbers = [*FOUND.get(name, ()), *range(INPUTS)]
    kinds = {number: kind for number in numbers if (kind := attempt(name, number, tmp_path)) is not None}
    assert kinds == {}, f'python -m tests.fuzz.targets {name} 1 NUMBER shows one of them'


def test_a_traceback_of_ours_would_be_found(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    def broken(path: str) -> None:
        raise KeyError('x')

    monkeypatch.setattr('edulaunch.Recording.load', broken)
    kind = attempt('recording', 0, tmp_path)
    assert kind is not None and kind.startswith('KeyError at test_targets.py:')
    text = 'Traceback (most recent call last):\n  File "{}", line 3, in f\nKeyError: 1\n'
    import edulaunch

    assert printed_kind(text.format(edulaunch.__file__)) == 'KeyError at __init__.py:3'
    assert printed_kind(text.format(tmp_path / 'students.py')) is None

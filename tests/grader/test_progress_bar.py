"""A bar on a terminal, silence elsewhere."""

from __future__ import annotations

import io
import sys

import pytest
from edugrade.progress_bar import progress_bar


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_without_a_terminal_nothing_is_shown_or_loaded(capsys: pytest.CaptureFixture[str]) -> None:
    before = 'rich' in sys.modules
    with progress_bar(3) as advance:
        advance()
    assert capsys.readouterr() == ('', '')
    assert ('rich' in sys.modules) == before


def test_on_a_terminal_runs_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, 'stderr', Terminal())
    with progress_bar(2) as advance:
        advance()
        advance()
    assert '2/2' in sys.stderr.getvalue()

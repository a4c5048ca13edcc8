"""A bar on a terminal, silence elsewhere."""

from __future__ import annotations

import io
import sys

import pytest
from edugrade.progress_bar import progress_bar


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_without_a_terminal_nothing_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    with progress_bar(3) as advance:
        advance()
    assert capsys.readouterr() == ('', '')


def test_on_a_terminal_runs_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, 'stderr', Terminal())
    with progress_bar(2) as advance:
        advance()
        advance()
    said = sys.stderr.getvalue().split('\r\x1b[K')
    assert [line.rpartition(' ')[2] for line in said] == ['', '0/2', '1/2', '2/2', ''], 'at the end nothing is left of it'

"""The `ament_index` command."""

from __future__ import annotations

from typing import Any

import pytest
from ament_index_python.cli import main


def test_resources_are_listed_with_their_prefix(
    ask: Any, two_prefixes: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    over, under = two_prefixes
    assert ask(lambda: main(['packages'])) is None
    assert capsys.readouterr().out == f'alpha\t{over}\nbeta\t{over}\ngamma_robot\t{under}\n'
    assert ask(lambda: main(['packages', 'none'])) == "Could not find the resource 'none' of type 'packages'"

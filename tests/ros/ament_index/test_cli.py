"""The `ament_index` command."""

from __future__ import annotations

from argparse import Namespace
from typing import Any

import pytest
from ament_index_python.cli import main, resource_name_completer, resource_type_completer


def test_resources_are_listed_with_their_prefix(
    ask: Any, two_prefixes: tuple[str, str], capsys: pytest.CaptureFixture[str]
) -> None:
    over, under = two_prefixes
    assert ask(lambda: main(['packages'])) is None
    assert capsys.readouterr().out == f'alpha\t{over}\nbeta\t{over}\ngamma_robot\t{under}\n'
    assert ask(lambda: main(['packages', 'none'])) == "Could not find the resource 'none' of type 'packages'"


def test_a_shell_completes_types_and_names(ask: Any, two_prefixes: tuple[str, str]) -> None:
    def names(kind: str | None, prefix: str) -> list[str]:
        return ask(lambda: list(resource_name_completer(prefix, parsed_args=Namespace(resource_type=kind))))

    assert 'packages' in ask(lambda: list(resource_type_completer('pack')))
    assert ask(lambda: list(resource_type_completer('none'))) == []
    assert names('packages', '') == ['alpha', 'beta', 'gamma_robot']
    assert names('packages', 'be') == ['beta']
    assert names(None, 'be') == []

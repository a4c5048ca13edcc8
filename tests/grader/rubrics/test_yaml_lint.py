"""A rubric that pays for a bare name is found, with the line."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.rubrics.yaml_lint import points_for_names

RUBRIC = """title: A
runs: [{{name: one}}]
checks:
  - {{name: command, command: {{words: ros2 bag record}}}}
  - {check}
"""
BARE = ['hears: {node: /a, topic: /b}', 'nodes: {are: [/a]}', 'starts: {node: /a, at: 0}', 'ends: {node: /a, at: 0}']


def found(folder: Path, check: str) -> list[str]:
    file = folder / 'a.yaml'
    file.write_text(RUBRIC.format(check=check))
    return list(points_for_names(str(file)))


@pytest.mark.parametrize('check', BARE)
def test_points_for_a_name_are_found(tmp_path: Path, check: str) -> None:
    kind = check.partition(':')[0]
    sentence = f'line 5: {kind} gives points for a name that any node may have: add package: NAME to it'
    assert found(tmp_path, f'{{{check}, points: 1}}') == [sentence]


@pytest.mark.parametrize('check', BARE)
def test_a_package_a_command_or_no_points_are_in_order(tmp_path: Path, check: str) -> None:
    assert found(tmp_path, f'{{{check[:-1]}, package: a}}, points: 1}}') == []
    assert found(tmp_path, f'{{{check}, points: 1, needs: [command]}}') == []
    assert found(tmp_path, f'{{{check}}}') == []

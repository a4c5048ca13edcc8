"""A rubric that pays for a bare name, or for a default that no run shows, is found with the line."""

from __future__ import annotations

from pathlib import Path

import pytest
from edugrade.rubrics.yaml_lint import points_for_defaults, points_for_names

RUBRIC = """title: A
runs: [{{name: one}}]
checks:
  - {{name: command, command: {{words: ros2 bag record}}}}
  - {check}
"""
BARE = [
    'hears: {node: /a, topic: /b}',
    'receives: {node: /a, from: {package: b}}',
    'nodes: {are: [/a]}',
    'starts: {node: /a, at: 0}',
    'ends: {node: /a, at: 0}',
]


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


DEFAULTS = """title: A
runs: [{{name: one{run}}}, {{name: two, arguments: {{who: b}}}}]
checks:
  - {{name: node, node: {{name: /$(arg who), package: a}}}}
  - {{name: who, argument: {{name: who, default: anna{proof}}}, points: 1}}
"""
SHOWN = ', shows: [node]'


@pytest.mark.parametrize(
    ('run', 'proof', 'told'),
    [
        (', defaults: {who: anna}', SHOWN, []),
        (
            ', defaults: {who: anna}',
            '',
            ['line 5: nothing shows the default of who: add shows: [CHECK], a check of what happens'],
        ),
        (
            ', arguments: {who: anna}',
            SHOWN,
            ['line 5: no run shows the default of who: leave who out of a run that has defaults: {who: anna}'],
        ),
    ],
)
def test_points_for_a_default_that_no_run_shows_are_found(tmp_path: Path, run: str, proof: str, told: list[str]) -> None:
    file = tmp_path / 'a.yaml'
    file.write_text(DEFAULTS.format(run=run, proof=proof))
    assert list(points_for_defaults(str(file))) == told

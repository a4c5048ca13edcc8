"""Texts that mean far more than they say, or never end: an error that says so, at once."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest

from edulaunch.advice.plan import rehearse
from edulaunch.runtime.session import index_for

INDEX = index_for([])
LAUGHS = 'a0: &a0 [x, x, x, x, x, x, x, x, x]\n' + ''.join(
    f'a{level}: &a{level} [{", ".join([f"*a{level - 1}"] * 9)}]\n' for level in range(1, 12)
)
ENTITIES = (
    '<!DOCTYPE launch [<!ENTITY a0 "x">'
    + ''.join(f'<!ENTITY a{level} "{f"&a{level - 1};" * 9}">' for level in range(1, 12))
    + ']>\n'
)
NODE = (
    'import os\nfrom launch import LaunchDescription\nfrom launch_ros.actions import Node\n'
    "def generate_launch_description():\n    return LaunchDescription([Node(package='turtlesim', executable='turtlesim_node',\n"
    "        parameters=[os.path.join(os.path.dirname(__file__), 'p.yaml')])])\n"
)


def planned(path: Path, text: str) -> dict[str, Any]:
    path.write_text(text)
    return rehearse(path, {}, INDEX, {'PATH': '/nowhere'}).plan


@pytest.mark.parametrize(
    ('name', 'text', 'told', 'line'),
    [
        ('x.launch.yaml', f'{LAUGHS}launch: *a11\n', 'aliases multiply the text to more than', 4),
        ('x.launch.yaml', 'launch: &a\n- group: *a\n', 'nested more than 100 levels deep', 2),
        ('x.launch.yaml', f'launch:\n- {"[" * 50_000}\n', 'nested more than 100 levels deep', 2),
        ('x.launch.xml', f'{ENTITIES}<launch><log message="&a11;"/></launch>', 'launch files must not declare entities', 1),
        ('x.launch.xml', '<launch>\n' + '<group>' * 50_000, 'nested more than 100 levels deep', 2),
        (
            'x.launch.xml',
            '<launch>\n<log message="' + '$(var ' * 50_000 + '"/></launch>',
            'more than 50 substitutions stand inside',
            2,
        ),
    ],
)
def test_a_launch_file_that_would_explode_is_refused_with_its_line(
    name: str, text: str, told: str, line: int, tmp_path: Path
) -> None:
    error = planned(tmp_path / name, text)['error']
    assert told in error['text']
    assert error['origin'] == f'{tmp_path / name}:{line}'


@pytest.mark.parametrize(
    ('text', 'told'),
    [
        (f'{LAUGHS}/**:\n  ros__parameters:\n    x: *a11\n', 'Cannot have a value before ros__parameters at line 1'),
        ('/**:\n  ros__parameters: &a\n    x: *a\n', 'Will not support aliasing at line 3'),
        (f'/**:\n  ros__parameters: {"{a: " * 3000}1{"}" * 3000}\n', 'nested too deep'),
    ],
)
def test_a_parameter_file_that_would_explode_is_told_of(text: str, told: str, tmp_path: Path) -> None:
    (tmp_path / 'p.yaml').write_text(text)
    plan = planned(tmp_path / 'x.launch.py', NODE)
    assert plan['error'] is None
    (node,) = [item for item in plan['items'] if item['kind'] == 'node']
    assert told in node['parameter_error']
    assert node['parameter_sources'][0]['content'] is None


@pytest.mark.parametrize(
    'value',
    [
        '[&b0 [x, x, x, x, x, x, x, x, x]'
        + ''.join(f', &b{level} [{", ".join([f"*b{level - 1}"] * 9)}]' for level in range(1, 10))
        + ']',
        '[' * 3000 + ']' * 3000,
    ],
)
def test_a_value_that_would_explode_is_refused(value: str, tmp_path: Path) -> None:
    error = planned(
        tmp_path / 'x.launch.xml',
        '<launch>\n<node pkg="turtlesim" exec="turtlesim_node">\n'
        f'<param name="a" value="$(eval \'{value!r}\')"/></node></launch>',
    )['error']
    assert error['text']
    assert len(error['text']) < 10_000


@pytest.mark.parametrize('loop', ['while True:\n        pass', 'number = 0\n    while number >= 0:\n        number += 1'])
def test_a_loop_without_end_in_a_launch_file_is_stopped_at_its_line(
    tmp_path: Path, loop: str, monkeypatch: pytest.MonkeyPatch
) -> None:
    monkeypatch.setattr('edulaunch.advice.plan.planner.TURN_LIMIT_S', 0.02)
    path = tmp_path / 'x.launch.py'
    error = planned(path, f'def generate_launch_description():\n    {loop}\n')['error']
    assert (error['type'], error['text']) == ('RunawayProgramError', 'the launch file never came to its end and was stopped')
    assert error['origin'].startswith(f'{path}:') and 'loop that does not end' in error['help']

"""Every name that the counted repositories import from rclpy, tf2, message_filters or an interface package is there."""

from __future__ import annotations

import re
from importlib import import_module
from pathlib import Path

import pytest

TABLES = Path(__file__).resolve().parents[3] / 'shared' / 'reference' / 'api_in_the_wild.md'
OURS = (
    'rclpy',
    'tf2_ros',
    'tf2_py',
    'tf2_geometry_msgs',
    'tf_transformations',
    'message_filters',
    'geometry_msgs',
    'std_msgs',
    'std_srvs',
    'sensor_msgs',
    'nav_msgs',
    'turtlesim',
    'example_interfaces',
    'rcl_interfaces',
    'lifecycle_msgs',
    'tf2_msgs',
    'builtin_interfaces',
    'visualization_msgs',
    'trajectory_msgs',
    'action_msgs',
    'shape_msgs',
)


def imports() -> list[tuple[str, str]]:
    """(module, name) of each `from module import name` of the tables."""
    if not TABLES.is_file():
        return []
    found = re.findall(r'^\| `from (\S+) import (\w+)`', TABLES.read_text(encoding='utf-8'), re.MULTILINE)
    return [(module, name) for module, name in found if module.partition('.')[0] in OURS]


@pytest.mark.skipif(not TABLES.is_file(), reason='the counted tables are not beside this repository')
def test_the_tables_are_read() -> None:
    assert len(imports()) > 80


@pytest.mark.parametrize(('module', 'name'), imports())
def test_a_name_that_students_import_is_there(module: str, name: str) -> None:
    try:
        assert hasattr(import_module(module), name)
    except AssertionError:
        import_module(f'{module}.{name}')

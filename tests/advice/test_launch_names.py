"""Where the names of launch files live, and what a constructor takes."""

from __future__ import annotations

from typing import Any

import pytest

from edulaunch.advice.launch_names import class_named, home_of, import_line, keywords_of, names_in, nearest_anywhere


@pytest.mark.parametrize(
    ('name', 'line'),
    [
        ('Node', 'from launch_ros.actions import Node'),
        ('LaunchDescription', 'from launch import LaunchDescription'),
        ('get_package_share_directory', 'from ament_index_python.packages import get_package_share_directory'),
        ('os', 'import os'),
        ('Nowhere', None),
        (None, None),
    ],
)
def test_a_name_has_the_import_line_of_the_module_that_exports_it(name: str | None, line: str | None) -> None:
    assert import_line(name) == line


def test_a_module_is_at_home_in_no_other_module() -> None:
    assert 'actions' in names_in('launch') and home_of('actions') is None
    assert names_in('launch.nowhere') == []


def test_the_nearest_name_of_all_modules_is_found() -> None:
    assert nearest_anywhere('LaunchConfigration') == 'LaunchConfiguration'
    cls = class_named('TimerAction')
    assert (cls.__module__, cls.__name__) == ('launch.actions.timer_action', 'TimerAction') and class_named('Nowhere') is None


class Base:
    def __init__(self, far: int, *, also: int = 0) -> None: ...


class Passing(Base):
    def __init__(self, near: int, *, only: int = 0, far: int = 1, **kwargs: Any) -> None: ...


class Closed(Passing):
    def __init__(self, own: int) -> None: ...


class Silent(Passing):
    pass


@pytest.mark.parametrize(
    ('cls', 'keywords'),
    [(Passing, ['near', 'only', 'far', 'also']), (Closed, ['own']), (Silent, ['near', 'only', 'far', 'also'])],
)
def test_a_constructor_that_passes_keywords_on_takes_those_of_its_base(cls: type, keywords: list[str]) -> None:
    assert keywords_of(cls) == keywords

"""The pytest plugin. Every run of pytest in this environment loads this file, so it does nothing in unrelated projects.

A `package.xml` beside, above or one folder below the tests makes a project a ROS package or a workspace, which activates the
plugin. Other projects use `-p edulaunch`, on the command line or in `addopts`. Only an active plugin loads `asked.py`, which
changes tests.
"""

from __future__ import annotations

import os
from collections.abc import Iterator, Sequence

import pytest

NAME = 'edulaunch'
MARKER = 'package.xml'


@pytest.hookimpl(tryfirst=True)
def pytest_load_initial_conftests(early_config: pytest.Config, args: Sequence[str]) -> None:
    """Load the code that runs ROS tests, before the first conftest.py, if the project needs it."""
    if is_asked(early_config, args):
        from edulaunch.extras.pytest_plugin import asked

        asked.start(early_config)


def is_asked(config: pytest.Config, args: Sequence[str]) -> bool:
    """Return whether this run has ROS tests, because of `-p edulaunch`, or because its tests belong to a ROS package or a
    workspace.
    """
    options = config.known_args_namespace
    named = NAME in options.plugins or __name__ in options.plugins
    return named or any(map(_is_ros_project, _places(options.file_or_dir, config)))


def _places(given: Sequence[str], config: pytest.Config) -> Iterator[str]:
    words = [word.partition('::')[0] for word in given] or [str(path) for path in config.getini('testpaths')]
    folder = str(config.invocation_params.dir)
    yield from (os.path.abspath(os.path.join(folder, word)) for word in words or ['.'])


def _is_ros_project(place: str) -> bool:
    """Return whether a package.xml is at or above a folder, or one or two folders below it (`src/my_package`)."""
    above = place
    while above != os.path.dirname(above):
        if os.path.isfile(os.path.join(above, MARKER)):
            return True
        above = os.path.dirname(above)
    return os.path.isdir(place) and any(os.path.isfile(os.path.join(folder, MARKER)) for folder in _below(place, 2))


def _below(place: str, depth: int) -> Iterator[str]:
    try:
        folders = [entry.path for entry in os.scandir(place) if entry.is_dir() and not entry.name.startswith('.')]
    except OSError:
        return
    for folder in folders:
        yield folder
        if depth > 1:
            yield from _below(folder, depth - 1)

"""Tests of tests: runs of pytest inside a run of pytest, by its plugin `pytester`."""

from __future__ import annotations

import pkgutil
from importlib import import_module

LAZY_PACKAGES = (
    'edulaunch.sim',
    'edulaunch.graph',
    'edulaunch.packages',
    'edulaunch.processes',
    'launch',
    'launch_ros',
    'launch_testing',
    'launch_pytest',
)


def load_everything() -> None:
    """Import what is else imported when it is first used.

    `pytester` forgets after each inner run the modules that were imported in it, but the packages that refer to them do not:
    without this there would be two of many a class.
    """
    from edulaunch.sourcing import source

    source()
    for package in LAZY_PACKAGES:
        for found in pkgutil.walk_packages(import_module(package).__path__, f'{package}.'):
            import_module(found.name)

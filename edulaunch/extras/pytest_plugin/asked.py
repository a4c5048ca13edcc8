"""Support for pytest runs with ROS tests: launch tests, tests of launch_pytest, and plain tests of a package.

Tests of launch_pytest and plain tests run on the simulated machine of the test run. A launch test has its own simulation. Tests
of the plugin itself run pytest inside pytest, with pytest's plugin `pytester`.
"""

from __future__ import annotations

import ast
import importlib.machinery
import os
import pkgutil
import sys
from collections.abc import Iterable
from importlib import import_module
from pathlib import Path

import pytest

from edulaunch.engine.underlay_place import underlay_python
from edulaunch.extras.testing import absent_linter, is_of_own_package
from edulaunch.extras.testing.machine_plugin import ConftestImports, put_on_machine
from edulaunch.ros.sourcing import source

SPEAKS_OF_LAUNCH_TESTS = pytest.StashKey[bool]()
"""The key of a flag of the run: whether a test file has launch tests, or contains the source of launch tests."""
LAZY_PACKAGES = (
    'edulaunch.engine.sim',
    'edulaunch.engine.graph',
    'edulaunch.engine.packages',
    'edulaunch.engine.processes',
    'launch',
    'launch_ros',
    'launch_testing',
    'launch_pytest',
)


def start(config: pytest.Config) -> None:
    """Activate the plugin in this run. Do nothing if a real ROS 2 is on the path, whose plugins have the same options and
    tests.
    """
    if _is_installed_elsewhere('launch_testing', str(config.invocation_params.dir)):
        return
    source()
    from launch_testing.pytest import hooks

    from edulaunch.extras.testing.launch_test import run_launch_test

    config.stash[hooks.RUNNER] = run_launch_test
    for name, plugin in (('edulaunch_asked', sys.modules[__name__]), ('launch_testing', hooks)):
        if not config.pluginmanager.is_registered(plugin):
            config.pluginmanager.register(plugin, name)
    ConftestImports(config).install()


def _is_installed_elsewhere(name: str, here: str) -> bool:
    """Return whether Python would import a foreign module of that name. ROS 2 sources in the folder of the run do not count."""
    spec = importlib.machinery.PathFinder.find_spec(name)
    origin = None if spec is None else spec.origin
    return origin is not None and not origin.startswith((underlay_python(), here + os.sep))


def pytest_collection_finish(session: pytest.Session) -> None:
    """Prepare for inner runs of pytest that have launch tests."""
    if session.config.stash.get(SPEAKS_OF_LAUNCH_TESTS, False) and session.config.pluginmanager.has_plugin('pytester'):
        load_everything()


def pytest_pycollect_makemodule(module_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Prepare for a file of launch_pytest, or for a plain test file of a ROS package."""
    text = module_path.read_bytes()
    if b'launch_pytest' in text or b'generate_test_description' in text:
        parent.config.stash[SPEAKS_OF_LAUNCH_TESTS] = True
    if uses_launch_pytest(text):
        _prepare_launch_pytest(parent.config, module_path)
        return None
    linter = absent_linter(text) if is_of_own_package(str(module_path)) else None
    if linter is not None:
        module: StyleTestModule = StyleTestModule.from_parent(parent, path=module_path)
        module.linter = linter
        return module
    if is_of_own_package(str(module_path)) and b'def generate_test_description' not in text:
        put_on_machine(parent.config, module_path)
    return None


class StyleTestModule(pytest.File):
    """A test file for one of ROS 2's style checkers, which edulaunch does not contain."""

    linter = ''

    def collect(self) -> Iterable[pytest.Item]:
        """Return one item, which is skipped with a reason."""
        yield StyleTestItem.from_parent(self, name=self.path.stem)


class StyleTestItem(pytest.Item):
    """A placeholder for the tests in a test file of a style checker."""

    parent: StyleTestModule

    def runtest(self) -> None:
        """Skip the test, with the test file as the place."""
        text = f'{self.parent.linter} is not available: run style checks where ROS 2 is installed'
        raise pytest.skip.Exception(text, _use_item_location=True)

    def reportinfo(self) -> tuple[Path, int, str]:
        """Return the place and the name of the item."""
        return self.path, 0, self.name


def uses_launch_pytest(source: bytes) -> bool:
    """Return whether a test file imports launch_pytest, or has tests with launch fixtures from a conftest.py.

    A file that only contains other test files as strings does not count, and a mark `launch` alone is not enough.
    """
    marked = b'mark.launch(' in source and 'launch_pytest' in sys.modules
    if b'launch_pytest' not in source and not marked:
        return False
    try:
        nodes = list(ast.walk(ast.parse(source)))
    except (SyntaxError, ValueError):
        return False
    return any(_imports_launch_pytest(node) or (marked and _is_mark_launch(node)) for node in nodes)


def _imports_launch_pytest(node: ast.AST) -> bool:
    names = (
        [alias.name for alias in node.names]
        if isinstance(node, ast.Import)
        else [node.module or '']
        if isinstance(node, ast.ImportFrom)
        else []
    )
    return any(name.partition('.')[0] == 'launch_pytest' for name in names)


def _is_mark_launch(node: ast.AST) -> bool:
    return isinstance(node, ast.Attribute) and node.attr == 'launch' and ast.unparse(node.value).endswith('mark')


def _prepare_launch_pytest(config: pytest.Config, module_path: Path) -> None:
    """Activate launch_pytest in this run, and give the file simulated time."""
    put_on_machine(config, module_path)
    from launch_pytest import plugin

    if not config.pluginmanager.is_registered(plugin):
        config.pluginmanager.register(plugin, 'launch_pytest')


def load_everything() -> None:
    """Import modules early that are otherwise imported when they are first used.

    After each inner run, `pytester` forgets the modules that were imported in the run, but packages still refer to them.
    Without this function, many classes would exist twice.
    """
    source()
    for package in LAZY_PACKAGES:
        for found in pkgutil.walk_packages(import_module(package).__path__, f'{package}.'):
            import_module(found.name)

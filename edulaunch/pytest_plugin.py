"""The pytest plugin for launch tests: files whose `generate_test_description` is marked `launch_test` or `rostest`.

Such a file becomes one test, as in ROS 2, run in a fresh simulation. For a file that uses launch_pytest that package's own
plugin is registered; it and plain test files of a ROS package run on the simulated machine of the test run. This plugin is loaded
in every run of pytest, so it imports nothing until there is such a file.
"""

from __future__ import annotations

import ast
import importlib.machinery
import sys
from collections.abc import Iterable
from pathlib import Path
from typing import Any, NamedTuple

import pytest

from edulaunch.testing.package_tests import absent_linter, is_of_own_package
from edulaunch.underlay_place import underlay_python

MARKS = {
    'launch_test': 'a launch test: generate_test_description describes what its tests need (edulaunch)',
    'rostest': 'as launch_test, for ROS 2 packages (edulaunch)',
}

SPEAKS_OF_LAUNCH_TESTS = pytest.StashKey[bool]()
"""Of a run: whether any of its test files has launch tests, or texts of some."""


def pytest_addhooks(pluginmanager: pytest.PytestPluginManager) -> None:
    """Offer `pytest_launch_collect_makemodule` to other plugins."""
    if not _other_launch_testing():
        from edulaunch.testing import hooks

        pluginmanager.add_hookspecs(hooks)


def pytest_addoption(parser: pytest.Parser) -> None:
    """Launch arguments, packages and seed for launch tests."""
    if _other_launch_testing():
        return
    group = parser.getgroup('launch tests', 'launch tests in simulated time')
    group.addoption('--launch-args', action='append', nargs='*', default=[], metavar='name:=value', help='launch arguments')
    group.addoption(
        '--launch-workspace',
        action='append',
        metavar='DIR',
        help='folder with packages; default: the workspace of each test file',
    )
    group.addoption('--launch-seed', type=int, default=0, metavar='N', help='of all randomness in launch tests (default: 0)')


@pytest.hookimpl(tryfirst=True)
def pytest_load_initial_conftests(early_config: pytest.Config) -> None:
    """Let a conftest.py import ROS packages."""
    if _other_launch_testing():
        return
    from edulaunch.testing.late_source import LateSource

    LateSource(early_config).install()


def pytest_configure(config: pytest.Config) -> None:
    """Make the marks known."""
    for name, text in MARKS.items():
        config.addinivalue_line('markers', f'{name}: {text}')


def pytest_collection_finish(session: pytest.Session) -> None:
    """Prepare for inner runs of pytest that have launch tests."""
    if session.config.stash.get(SPEAKS_OF_LAUNCH_TESTS, False) and session.config.pluginmanager.has_plugin('pytester'):
        from edulaunch.testing.inner_pytest import load_everything

        load_everything()


def pytest_pycollect_makemodule(module_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Take a launch test; leave any other file to pytest, after preparing for those of launch_pytest."""
    source = module_path.read_bytes()
    if b'launch_pytest' in source or b'generate_test_description' in source:
        parent.config.stash[SPEAKS_OF_LAUNCH_TESTS] = True
    entrypoint, is_plain = _entrypoint_in(source), not uses_launch_pytest(source)
    if _other_launch_testing():
        return None
    if not is_plain:
        _prepare_launch_pytest(parent.config, module_path)
    if entrypoint is None:
        return None if not is_plain else _plain_module(source, module_path, parent)
    hook = parent.session.gethookproxy(module_path).pytest_launch_collect_makemodule
    module: pytest.Collector | None = hook(path=module_path, parent=parent, entrypoint=entrypoint)
    return module


def _plain_module(source: bytes, module_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Prepare for a plain test file of a ROS package. Who has sourced edulaunch himself decides himself what is simulated."""
    if not is_of_own_package(str(module_path)):
        return None
    linter = absent_linter(source)
    if linter is not None:
        module: StyleTestModule = StyleTestModule.from_parent(parent, path=module_path)
        module.linter = linter
        return module
    from edulaunch.testing.late_source import SOURCED_LATE

    is_ours = SOURCED_LATE in parent.config.stash or parent.config.pluginmanager.has_plugin('edulaunch_test_machine')
    if is_ours or underlay_python() not in sys.path:
        from edulaunch.testing.machine_plugin import put_on_machine

        put_on_machine(parent.config, module_path)
    return None


class StyleTestModule(pytest.File):
    """A test file that asks one of ROS 2's style checkers, which is not here."""

    linter = ''

    def collect(self) -> Iterable[pytest.Item]:
        """One item, which is skipped and tells why."""
        yield StyleTestItem.from_parent(self, name=self.path.stem)


class StyleTestItem(pytest.Item):
    """What such a file would have checked."""

    parent: StyleTestModule

    def runtest(self) -> None:
        """Say what is missing, as of the test file."""
        text = f'{self.parent.linter} is not here: style is checked where ROS 2 is installed'
        raise pytest.skip.Exception(text, _use_item_location=True)

    def reportinfo(self) -> tuple[Path, int, str]:
        """Where it is, and what it is called."""
        return self.path, 0, self.name


@pytest.hookimpl(trylast=True)
def pytest_launch_collect_makemodule(path: Path, parent: pytest.Collector, entrypoint: Entrypoint) -> pytest.Collector | None:
    """Take a file with one of our marks."""
    if not entrypoint.is_ours():
        return None
    module: LaunchTestModule = LaunchTestModule.from_parent(parent, path=path)
    return module


def _other_launch_testing() -> bool:
    """Whether somebody else's launch_testing (a real ROS 2) is on the path; its plugin has the same options and tests."""
    spec = importlib.machinery.PathFinder.find_spec('launch_testing')
    return spec is not None and not (spec.origin or '').startswith(underlay_python())


def uses_launch_pytest(source: bytes) -> bool:
    """Whether a test file imports launch_pytest, or has tests whose launch fixtures a conftest.py has made with it.

    A file that only speaks of it (tests of tests have other files as texts) does not; nor is every mark `launch` ours.
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
    """Let launch_pytest take part in this run, and let the file see simulated time."""
    from edulaunch.testing.machine_plugin import put_on_machine

    put_on_machine(config, module_path)
    from launch_pytest import plugin

    if not config.pluginmanager.is_registered(plugin):
        config.pluginmanager.register(plugin, 'launch_pytest')


class Entrypoint(NamedTuple):
    """The function `generate_test_description` of a file that has not been run yet, and its marks."""

    pytestmark: list[pytest.Mark]

    def is_ours(self) -> bool:
        """Whether it has a mark of this plugin."""
        return any(mark.name in MARKS for mark in self.pytestmark)


def find_launch_test_entrypoint(path: str | Path) -> Entrypoint | None:
    """The function `generate_test_description` in a file, or None."""
    return _entrypoint_in(Path(path).read_bytes())


def is_launch_test(source: bytes) -> bool:
    """Whether the text defines a function `generate_test_description` with one of the marks."""
    entrypoint = _entrypoint_in(source)
    return entrypoint is not None and entrypoint.is_ours()


def _entrypoint_in(source: bytes) -> Entrypoint | None:
    if b'generate_test_description' not in source:
        return None
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return None
    return next(
        (
            Entrypoint(_marks(node.decorator_list))
            for node in tree.body
            if isinstance(node, ast.FunctionDef) and node.name == 'generate_test_description'
        ),
        None,
    )


def _marks(decorators: Iterable[ast.expr]) -> list[pytest.Mark]:
    called = [node.func if isinstance(node, ast.Call) else node for node in decorators]
    names = [node.attr for node in called if isinstance(node, ast.Attribute) and 'mark' in ast.unparse(node.value)]
    return [pytest.Mark(name, (), {}, _ispytest=True) for name in names]


class LaunchTestFailure(Exception):
    """A launch test failed; the text says which of its tests, and why."""


class LaunchTestModule(pytest.File):
    """A launch test file."""

    def collect(self) -> Iterable[LaunchTestItem]:
        """One item, whatever is in the file, as in ROS 2."""
        yield LaunchTestItem.from_parent(self, name=self.path.stem)


class LaunchTestItem(pytest.Item):
    """All launches of a file with all their tests."""

    def runtest(self) -> None:
        """Run in a fresh simulation.

        :raises LaunchTestFailure: when anything went wrong.
        """
        from edulaunch.sourcing import source
        from edulaunch.testing.session import run_launch_test

        source()
        from launch_testing.launch_test import LaunchTest

        option = self.config.getoption
        test = LaunchTest(str(self.path), [word for words in option('--launch-args') for word in words])
        code = run_launch_test(test, workspaces=option('--launch-workspace'), seed=option('--launch-seed'))
        _skip_if_skipped(test)
        if code or test.error is not None:
            raise LaunchTestFailure(_told(test))

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """A failed launch test is told by its own text; there is nothing to see in our frames."""
        return str(excinfo.value) if isinstance(excinfo.value, LaunchTestFailure) else super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        """Where it is, and what it is called."""
        return self.path, 0, f'launch test {self.name}'


def _skip_if_skipped(test: Any) -> None:
    import unittest

    if isinstance(test.error, (unittest.SkipTest, pytest.skip.Exception)):
        pytest.skip(str(test.error))
    reasons = [reason for result in test.results.values() for _, reason in result.skipped if not result.testsRun]
    if reasons and len(reasons) == len(test.results):
        pytest.skip(reasons[0])


def _told(test: Any) -> str:
    """Each failed test with its text, or why the file could not be run."""
    if test.error is not None:
        text: str = test.error_text()
        return text
    lines = []
    for run, result in test.results.items():
        lines += [f'{what}: {name} [{run}]\n{text}' for what, name, text in result.problems()]
    return '\n'.join(lines)

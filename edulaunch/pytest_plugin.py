"""The pytest plugin for launch tests: files whose `generate_test_description` is marked `launch_test` or `rostest`.

Such a file becomes one test, as in ROS 2, run in a fresh simulation. The plugin is loaded in every run of pytest, so
it imports nothing until there is such a file.
"""
from __future__ import annotations

import ast
import importlib.machinery
from collections.abc import Iterable
from pathlib import Path
from typing import Any

import pytest

from edulaunch.underlay_place import underlay_python

MARKS = {'launch_test': 'a launch test: generate_test_description describes what its tests need (edulaunch)',
         'rostest': 'as launch_test, for ROS 2 packages (edulaunch)'}


def pytest_addoption(parser: pytest.Parser) -> None:
    """Launch arguments, packages and seed for launch tests."""
    if _other_launch_testing():
        return
    group = parser.getgroup('launch tests', 'launch tests in simulated time')
    group.addoption('--launch-args', action='append', nargs='*', default=[], metavar='name:=value', help='launch arguments')
    group.addoption('--launch-workspace', action='append', metavar='DIR',
                    help='folder with packages; default: the workspace of each test file')
    group.addoption('--launch-seed', type=int, default=0, metavar='N', help='of all randomness in launch tests (default: 0)')


def pytest_configure(config: pytest.Config) -> None:
    """Make the marks known."""
    for name, text in MARKS.items():
        config.addinivalue_line('markers', f'{name}: {text}')


def pytest_pycollect_makemodule(module_path: Path, parent: pytest.Collector) -> LaunchTestModule | None:
    """Take a launch test; leave any other file to pytest."""
    if not is_launch_test(module_path.read_bytes()) or _other_launch_testing():
        return None
    module: LaunchTestModule = LaunchTestModule.from_parent(parent, path=module_path)
    return module


def _other_launch_testing() -> bool:
    """Whether somebody else's launch_testing (a real ROS 2) is on the path; its plugin has the same options and tests."""
    spec = importlib.machinery.PathFinder.find_spec('launch_testing')
    return spec is not None and not (spec.origin or '').startswith(underlay_python())


def is_launch_test(source: bytes) -> bool:
    """Whether the text defines a function `generate_test_description` with one of the marks."""
    if b'generate_test_description' not in source or not any(mark.encode() in source for mark in MARKS):
        return False
    try:
        tree = ast.parse(source)
    except (SyntaxError, ValueError):
        return False
    return any(isinstance(node, ast.FunctionDef) and node.name == 'generate_test_description'
               and _is_marked(node.decorator_list) for node in tree.body)


def _is_marked(decorators: Iterable[ast.expr]) -> bool:
    called = [node.func if isinstance(node, ast.Call) else node for node in decorators]
    return any(isinstance(node, ast.Attribute) and node.attr in MARKS for node in called)


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
        from edulaunch.launch_test_session import run_launch_test
        from edulaunch.sourcing import source
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

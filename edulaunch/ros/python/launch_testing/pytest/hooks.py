"""The pytest plugin for launch tests: files whose `generate_test_description` is marked `launch_test` or `rostest`.

As in ROS 2, such a file becomes one test. The test runs in a new simulation.
"""

from __future__ import annotations

import ast
import unittest
from collections.abc import Callable, Iterable
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from launch_testing.launch_test import LaunchTest

RUNNER = pytest.StashKey[Callable[..., int]]()
"""The key in the stash of a run for the function that runs a launch test in its own simulation."""
MARKS = {
    'launch_test': 'a launch test: generate_test_description describes what its tests need (edulaunch)',
    'rostest': 'as launch_test, for ROS 2 packages (edulaunch)',
}


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the options for the launch arguments, packages and seed of launch tests."""
    group = parser.getgroup('launch tests', 'launch tests in simulated time')
    group.addoption('--launch-args', action='append', nargs='*', default=[], metavar='name:=value', help='launch arguments')
    group.addoption(
        '--launch-workspace',
        action='append',
        metavar='DIR',
        help='folder with packages (default: the workspace of each test file)',
    )
    group.addoption('--launch-seed', type=int, default=0, metavar='N', help='of all randomness in launch tests (default: 0)')


def pytest_configure(config: pytest.Config) -> None:
    """Register the marks."""
    for name, text in MARKS.items():
        config.addinivalue_line('markers', f'{name}: {text}')


def pytest_pycollect_makemodule(module_path: Path, parent: pytest.Collector) -> pytest.Collector | None:
    """Collect a file with a launch test, and leave other files to pytest."""
    if not is_launch_test(module_path.read_bytes()):
        return None
    module: LaunchTestModule = LaunchTestModule.from_parent(parent, path=module_path)
    return module


def is_launch_test(source: bytes) -> bool:
    """Return whether a file has a function `generate_test_description` with a mark for launch tests. The file is not executed."""
    if b'generate_test_description' not in source:
        return False
    try:
        statements = ast.parse(source).body
    except (SyntaxError, ValueError):
        return False
    functions = [node for node in statements if isinstance(node, ast.FunctionDef) and node.name == 'generate_test_description']
    decorators = [node.func if isinstance(node, ast.Call) else node for node in functions[0].decorator_list] if functions else []
    attributes = [node for node in decorators if isinstance(node, ast.Attribute)]
    return any(node.attr in MARKS and 'mark' in ast.unparse(node.value) for node in attributes)


class LaunchTestFailure(Exception):
    """A launch test has failed. The message names the failed tests and the reasons."""


class LaunchTestModule(pytest.File):
    """A launch test file."""

    def collect(self) -> Iterable[LaunchTestItem]:
        """Yield one item for the whole file, as in ROS 2."""
        yield LaunchTestItem.from_parent(self, name=self.path.stem)


class LaunchTestItem(pytest.Item):
    """All launches of a file with all their tests, as one item."""

    def runtest(self) -> None:
        """Run the file in a new simulation.

        :raises LaunchTestFailure: when a test has failed, or the file could not be run.
        """
        from launch_testing.launch_test import LaunchTest

        option = self.config.getoption
        test = LaunchTest(str(self.path), [word for words in option('--launch-args') for word in words])
        code = self.config.stash[RUNNER](test, workspaces=option('--launch-workspace'), seed=option('--launch-seed'))
        _skip_if_skipped(test)
        if code or test.error is not None:
            raise LaunchTestFailure(_failure_text(test))

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """Return the report of a failure. For a failed launch test, this is the failure's own message, because a traceback
        through edulaunch does not help.
        """
        return str(excinfo.value) if isinstance(excinfo.value, LaunchTestFailure) else super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int, str]:
        """Return the place and the name of the test."""
        return self.path, 0, f'launch test {self.name}'


def _skip_if_skipped(test: LaunchTest) -> None:
    if isinstance(test.error, (unittest.SkipTest, pytest.skip.Exception)):
        pytest.skip(str(test.error))
    reasons = [reason for result in test.results.values() for _, reason in result.skipped if not result.testsRun]
    if reasons and len(reasons) == len(test.results):
        pytest.skip(reasons[0])


def _failure_text(test: LaunchTest) -> str:
    """Return each failed test with its message, or the reason why the file could not be run."""
    if test.error is not None:
        return test.error_text()
    lines = []
    for run, result in test.results.items():
        lines += [f'{what}: {name} [{run}]\n{text}' for what, name, text in result.problems()]
    return '\n'.join(lines)

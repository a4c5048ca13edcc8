"""Running the launch tests of `corpus/`."""

from __future__ import annotations

from collections.abc import Callable
from pathlib import Path
from typing import Any

import pytest
from launch_testing.launch_test import LaunchTest
from launch_testing.pytest.hooks import pytest_configure

from edulaunch.extras.testing.launch_test import run_launch_test

CORPUS = Path(__file__).parent / 'corpus'
Run = Callable[..., Any]


@pytest.fixture
def run(pytestconfig: pytest.Config) -> Run:
    """Run a file of the corpus in a simulation of its own; gives the `LaunchTest`, with `code` as well."""
    if not any(line.startswith('launch_test:') for line in pytestconfig.getini('markers')):
        pytest_configure(pytestconfig)

    def run_file(name: str, *arguments: str) -> Any:
        test: Any = LaunchTest(str(CORPUS / f'{name}.py'), arguments)
        test.code = run_launch_test(test)
        return test

    return run_file


def outcome(test: Any) -> list[tuple[str, str]]:
    """(what, test method or 'launch') of everything that went wrong, in order."""
    return [(what, name.partition(' ')[0]) for result in test.results.values() for what, name, _ in result.problems()]

"""The pytest plugin with the machine of a test run. edulaunch's pytest plugin registers it for the first test file that needs it.

The plugin handles these test files, and the `conftest.py` files, which pytest imports before any test file.
"""

from __future__ import annotations

import os
import sys
from collections.abc import Generator, Sequence
from importlib.machinery import ModuleSpec
from importlib.util import find_spec
from pathlib import Path
from types import FrameType, ModuleType
from typing import Any

import pytest

from edulaunch.extras.testing import is_of_own_package
from edulaunch.extras.testing.machine import TestMachine
from edulaunch.ros.sourcing import source

MACHINE = pytest.StashKey[TestMachine]()


def machine_of(config: pytest.Config) -> TestMachine:
    """Return the machine of this run of pytest. Open it on first use."""
    if MACHINE not in config.stash:
        source()
        option = {
            **vars(config.known_args_namespace),
            **vars(config.option),
        }  # conftest files define options that only `vars` returns
        machine = config.stash[MACHINE] = TestMachine(option.get('launch_seed', 0), option.get('launch_workspace'))
        machine.open()
        config.add_cleanup(machine.close)
        config.pluginmanager.register(sys.modules[__name__], 'edulaunch_test_machine')
    return config.stash[MACHINE]


def put_on_machine(config: pytest.Config, path: Path) -> None:
    """Before pytest imports a test file, give it simulated time and make the packages in its workspace available to it."""
    machine = machine_of(config)
    machine.add(path)
    machine.enter(path)


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(collector: pytest.Collector) -> Generator[None, Any, Any]:
    """Make the packages in the workspace of a file available while pytest imports the file."""
    if isinstance(collector, pytest.Module):
        collector.config.stash[MACHINE].enter(collector.path)
    return (yield)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, Any, Any]:
    """Make the packages in the workspace of the test file available to the test, and limit its duration."""
    machine = item.config.stash[MACHINE]
    machine.enter(item.path)
    with machine.limited():
        return (yield)


def pytest_enter_pdb(config: pytest.Config) -> None:
    """Suspend the time limits while a person uses a debugger."""
    config.stash[MACHINE].let_debug(True)


def pytest_leave_pdb(config: pytest.Config) -> None:
    """Restore the time limits."""
    config.stash[MACHINE].let_debug(False)


class ConftestImports:
    """The first module finder of Python. It puts a `conftest.py` inside a package of the user on the machine of the tests.

    The `conftest.py` can then import that package and its interfaces. Modules that it imports before any search do not change.
    """

    def __init__(self, config: pytest.Config) -> None:
        self._config = config
        self._seen: set[str] = set()

    def install(self) -> None:
        """Install the finder until the end of the run."""
        sys.meta_path.insert(0, self)
        self._config.add_cleanup(lambda: sys.meta_path.remove(self))

    def find_spec(self, name: str, path: Sequence[str] | None = None, target: ModuleType | None = None) -> ModuleSpec | None:
        """Return the spec of a module if the machine of the tests knows it and this is the first import of a conftest.py.
        Otherwise, return None.
        """
        conftest = _importing_conftest(sys._getframe(1))
        if conftest is None or conftest in self._seen:
            return None
        self._seen.add(conftest)
        if not is_of_own_package(conftest):
            return None
        put_on_machine(self._config, Path(conftest))
        return find_spec(name)


def _importing_conftest(frame: FrameType | None) -> str | None:
    """Return the conftest.py with the import statement that is being executed."""
    while frame is not None and 'importlib' in frame.f_code.co_filename:
        frame = frame.f_back
    file = '' if frame is None else frame.f_code.co_filename
    return file if os.path.basename(file) == 'conftest.py' else None

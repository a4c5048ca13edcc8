"""The pytest plugin that keeps the machine of a test run. Ours registers it for the first test file that needs it."""

from __future__ import annotations

from collections.abc import Generator
from pathlib import Path
from typing import Any

import pytest

from edulaunch.testing.machine import TestMachine

MACHINE = pytest.StashKey[TestMachine]()


def machine_of(config: pytest.Config) -> TestMachine:
    """The machine of this run of pytest; it is opened when it is first asked for."""
    if MACHINE not in config.stash:
        import sys

        from edulaunch.sourcing import source

        source()
        option = {**vars(config.known_args_namespace), **vars(config.option)}  # the second comes after the conftest files
        machine = config.stash[MACHINE] = TestMachine(option.get('launch_seed', 0), option.get('launch_workspace'))
        machine.open()
        config.add_cleanup(machine.close)
        config.pluginmanager.register(sys.modules[__name__], 'edulaunch_test_machine')
    return config.stash[MACHINE]


def put_on_machine(config: pytest.Config, path: Path) -> None:
    """Let a test file that is to be imported see simulated time and the packages around it."""
    machine = machine_of(config)
    machine.add(path)
    machine.enter(path)


@pytest.hookimpl(wrapper=True)
def pytest_make_collect_report(collector: pytest.Collector) -> Generator[None, Any, Any]:
    """A file that is imported sees the packages around it."""
    if isinstance(collector, pytest.Module):
        collector.config.stash[MACHINE].enter(collector.path)
    return (yield)


@pytest.hookimpl(wrapper=True, tryfirst=True)
def pytest_runtest_protocol(item: pytest.Item) -> Generator[None, Any, Any]:
    """So does a test, and it does not wait for ever."""
    machine = item.config.stash[MACHINE]
    machine.enter(item.path)
    with machine.limited():
        return (yield)


def pytest_enter_pdb(config: pytest.Config) -> None:
    """Nobody is stopped for taking long while a person looks."""
    config.stash[MACHINE].let_debug(True)


def pytest_leave_pdb(config: pytest.Config) -> None:
    """From now on they are again."""
    config.stash[MACHINE].let_debug(False)

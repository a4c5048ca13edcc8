"""Running small files of launch tests in an inner pytest of this same program."""

from __future__ import annotations

import sys
from collections.abc import Callable
from pathlib import Path
from typing import Any, NamedTuple

import pytest

PREAMBLE = """
import asyncio, threading, time
import launch, launch_pytest, pytest
from launch.actions import ExecuteProcess, TimerAction
from launch_pytest import tools
from launch_pytest.actions import ReadyToTest
from launch_ros.actions import Node
from launch_testing.util import KeepAliveProc
"""
Run = Callable[..., Any]
"""What the fixture `inner` is."""


class Inner(NamedTuple):
    """What an inner pytest did: (test, 'passed' | 'failed' | 'skipped' | 'error') in order, and all it had to say."""

    outcomes: list[tuple[str, str]]
    text: str


class Collector:
    """A plugin that notes outcomes."""

    def __init__(self) -> None:
        self.outcomes: list[tuple[str, str]] = []
        self.texts: list[str] = []

    def pytest_runtest_logreport(self, report: pytest.TestReport) -> None:
        name = report.nodeid.partition('::')[2]
        if report.when == 'call' or (report.when == 'setup' and report.skipped):
            self.outcomes.append((name, report.outcome))
        elif report.failed:
            self.outcomes.append((name, 'error'))
        self.texts.append(report.longreprtext)

    def pytest_collectreport(self, report: pytest.CollectReport) -> None:
        if report.failed:
            self.outcomes.append((report.nodeid, 'error'))
            self.texts.append(report.longreprtext)

    def pytest_warning_recorded(self, warning_message: Any) -> None:
        self.texts.append(str(warning_message.message))


@pytest.fixture
def inner(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> Callable[..., Inner]:
    """Run a text as a file of tests; further files by name."""
    monkeypatch.setenv('PYTEST_DISABLE_PLUGIN_AUTOLOAD', '1')
    monkeypatch.setattr(sys, 'dont_write_bytecode', True)

    def run(text: str, *, options: tuple[str, ...] = (), **files: str) -> Inner:
        (tmp_path / 'test_it.py').write_text(PREAMBLE + text)
        for name, content in files.items():
            (tmp_path / f'{name}.py').write_text(content)
        collector = Collector()
        before, finders = set(sys.modules), list(sys.meta_path)
        pytest.main(
            [
                str(tmp_path),
                '-q',
                '-p',
                'edulaunch.extras.pytest_plugin',
                '-p',
                'no:cacheprovider',
                '--strict-markers',
                '--import-mode=importlib',
                f'--rootdir={tmp_path}',
                '-W',
                'always::pytest.PytestWarning',
                *options,
            ],
            plugins=[collector],
        )
        for name in [name for name in sys.modules if name not in before and name.startswith('test_it')]:
            del sys.modules[name]
        sys.meta_path[:] = finders
        return Inner(collector.outcomes, '\n'.join(collector.texts))

    return run

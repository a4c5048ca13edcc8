"""What pytest makes of launch test files, under the names that other plugins import.

The plugin itself is edulaunch's, which an installation registers; `-p launch_testing.pytest.hooks` registers it where none does.
"""

from __future__ import annotations

import pytest

from edulaunch import pytest_plugin
from edulaunch.pytest_plugin import LaunchTestFailure, LaunchTestItem, LaunchTestModule, find_launch_test_entrypoint

__all__ = ['LaunchTestFailure', 'LaunchTestItem', 'LaunchTestModule', 'find_launch_test_entrypoint']


def pytest_addoption(pluginmanager: pytest.PytestPluginManager) -> None:
    """Register edulaunch's plugin, unless somebody else has."""
    if not pluginmanager.is_registered(pytest_plugin):
        pluginmanager.register(pytest_plugin, 'edulaunch')

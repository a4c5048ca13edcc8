"""The hook that the plugin for launch tests offers to other plugins."""

from __future__ import annotations

from pathlib import Path
from typing import Any

import pytest


@pytest.hookspec(firstresult=True)
def pytest_launch_collect_makemodule(path: Path, parent: pytest.Collector, entrypoint: Any) -> pytest.Collector | None:
    """Make the collector of a launch test file, or leave it to others by returning None.

    :param path: of the file.
    :param entrypoint: its function `generate_test_description`, as syntax (`ast.FunctionDef`): the file has not been run yet.
    """

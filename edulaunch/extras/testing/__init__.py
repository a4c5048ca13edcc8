"""Tests of a package, plain ones and those of launch_pytest, on the simulated machine of a run of pytest.

Here: which files those are, which packages they see, and which of them need what is not here.
"""

from __future__ import annotations

import ast
import importlib.util
import os

from edulaunch.engine.packages.discovery import package_around, workspace_around
from edulaunch.engine.underlay_place import underlay_python


def workspaces_of(path: str) -> list[str]:
    """The workspace whose packages a test file can use, as :func:`workspace_around` finds it; none outside any package."""
    found = workspace_around(path)
    return [] if found is None else [found]


def is_of_own_package(path: str) -> bool:
    """Whether a file belongs to a package of the user; tests of the packages that ROS 2 itself consists of are none."""
    folder = package_around(path)
    return folder is not None and not os.path.isdir(os.path.join(underlay_python(), os.path.basename(folder)))


def absent_linter(source: bytes) -> str | None:
    """The first of ROS 2's style checkers that a test file imports and that is not here (`ament_flake8`)."""
    if b'ament_' not in source:
        return None
    try:
        statements = ast.parse(source).body
    except (SyntaxError, ValueError):
        return None
    names = [node.module or '' for node in statements if isinstance(node, ast.ImportFrom) and not node.level]
    names += [alias.name for node in statements if isinstance(node, ast.Import) for alias in node.names]
    tops = [name.partition('.')[0] for name in names]
    return next(
        (
            top
            for top in tops
            if top.startswith('ament_') and top != 'ament_index_python' and importlib.util.find_spec(top) is None
        ),
        None,
    )

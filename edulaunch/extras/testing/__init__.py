"""Tests of a package (plain tests and tests of launch_pytest) on the simulated machine of a pytest run.

This file selects these test files, and finds the packages that they can use and the packages that are missing.
"""

from __future__ import annotations

import ast
import importlib.util
import os

from edulaunch.engine.packages.discovery import package_around, workspace_around
from edulaunch.engine.underlay_place import underlay_python


def workspaces_of(path: str) -> list[str]:
    """Return the workspace whose packages a test file can use, as a list. The list is empty if :func:`workspace_around` finds
    no workspace.
    """
    found = workspace_around(path)
    return [] if found is None else [found]


def is_of_own_package(path: str) -> bool:
    """Return whether a file belongs to a package of the user. Tests of ROS 2's own packages do not count."""
    folder = package_around(path)
    return folder is not None and not os.path.isdir(os.path.join(underlay_python(), os.path.basename(folder)))


def absent_linter(source: bytes) -> str | None:
    """Return the first missing style checker of ROS 2 (such as `ament_flake8`) that a test file imports. Return None if there
    is no such import.
    """
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

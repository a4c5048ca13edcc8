"""Test files of ROS packages: which they are, which packages they see, and which of them need what is not here."""

from __future__ import annotations

import ast
import importlib.util
import os

from edulaunch.underlay_place import underlay_python


def workspaces_of(path: str) -> list[str]:
    """The folder whose packages a test file can use; none outside any package.

    It is the `src` folder above its package; without one, the folder above when it holds further packages, else the package.
    """
    folder = package_around(path)
    if folder is None:
        return []
    parts = folder.split(os.sep)
    if 'src' in parts:
        return [os.sep.join(parts[: parts.index('src') + 1])]
    above = os.path.dirname(folder)
    return [above if _packages_in(above) > 1 else folder]


def package_around(path: str) -> str | None:
    """The innermost folder with a `package.xml` around a file."""
    folder = os.path.dirname(os.path.abspath(path))
    while not os.path.isfile(os.path.join(folder, 'package.xml')):
        above = os.path.dirname(folder)
        if above == folder:
            return None
        folder = above
    return folder


def _packages_in(folder: str) -> int:
    return sum(os.path.isfile(os.path.join(folder, name, 'package.xml')) for name in os.listdir(folder))


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

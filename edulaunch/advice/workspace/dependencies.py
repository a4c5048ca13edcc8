"""Find dependencies in package.xml files that are not available here, as `rosdep check` does."""

from __future__ import annotations

from fnmatch import fnmatchcase
from importlib.util import find_spec
from typing import NamedTuple

from edulaunch.engine.nearest import nearest
from edulaunch.engine.packages import Index
from edulaunch.ros.sources import read_source
from edulaunch.ros.sources.source_package import Dependency, SourcePackage, source_packages

NOT_NEEDED = (
    *('ament_*', 'rosidl_*', 'cmake', 'catkin', 'pkg-config', 'launch_testing_ament_cmake'),
    *('rclcpp*', 'rcutils', 'rmw*', 'tf2', 'tf2_eigen', 'class_loader', 'pluginlib', 'eigen', 'yaml-cpp', 'boost'),
    *('qtbase5-dev', 'libqt5-*', 'python3-pytest', 'python3-setuptools', 'ros2[a-z]*'),
)
"""Dependencies that edulaunch does not need: tools to build, lint and generate, libraries of C++ programs, and the parts of the
`ros2` command. `*` matches any text.
"""
SAME = {'tf2_ros_py': 'tf2_ros'}
"""Packages whose Python part has another name."""
PYTHON_NAMES = {'opencv-python': 'cv2', 'opencv': 'cv2', 'pil': 'PIL', 'pyyaml': 'yaml', 'tk': 'tkinter', 'pyqt5': 'PyQt5'}
"""Python packages by the name in rosdep, if their module has another name."""


class Missing(NamedTuple):
    """A missing dependency of a package, and the most similar existing name."""

    package: SourcePackage
    dependency: Dependency
    nearest: str | None


def missing_dependencies(path: str) -> tuple[list[str], list[Missing]]:
    """Return the packages below `path`, and each dependency that neither edulaunch nor the workspace contains."""
    index = Index((), [path], read_source=read_source)
    packages = source_packages(index)
    here = list(index.packages())
    missing = []
    for package in packages:
        reported: set[str] = set()
        for dependency in package.dependencies:
            if dependency.name not in reported and not is_here(dependency.name, here):
                reported.add(dependency.name)
                missing.append(Missing(package, dependency, nearest(dependency.name, here)))
    return [package.name for package in packages], missing


def is_here(name: str, here: list[str]) -> bool:
    """Return whether a dependency is available or is not needed.

    Dependencies that are only for builds or for compiled programs are not needed, because edulaunch does not build packages.
    """
    if SAME.get(name, name) in here or any(fnmatchcase(name, pattern) for pattern in NOT_NEEDED):
        return True
    for prefix in ('python3-', 'python-'):
        if name.startswith(prefix):
            short = name.removeprefix(prefix).removesuffix('-pip')
            return _importable(PYTHON_NAMES.get(short, short.replace('-', '_')))
    return False


def _importable(module: str) -> bool:
    try:
        return find_spec(module) is not None
    except (ImportError, ValueError):
        return False

"""Dependencies of package.xml files that are not here: the counterpart of `rosdep check`."""

from __future__ import annotations

import os
from importlib.util import find_spec
from typing import NamedTuple

from edulaunch.nearest import nearest
from edulaunch.packages import Index
from edulaunch.workspace.sources import Dependency, SourcePackage, source_packages

BUILD_ONLY = (
    'ament_cmake',
    'ament_cmake_auto',
    'ament_cmake_python',
    'ament_cmake_gtest',
    'ament_cmake_pytest',
    'ament_python',
    'ament_package',
    'ament_lint_auto',
    'ament_lint_common',
    'ament_copyright',
    'ament_flake8',
    'ament_pep257',
    'ament_xmllint',
    'ament_mypy',
    'ament_cmake_ros',
    'ament_cmake_core',
    'rosidl_default_generators',
    'rosidl_default_runtime',
    'rosidl_interface_packages',
    'rosidl_cmake',
    'rosidl_generator_py',
    'rosidl_typesupport_cpp',
    'python3-pytest',
    'python3-setuptools',
    'cmake',
    'catkin',
    'pkg-config',
    'eigen',
    'rosidl_runtime_py',
    'launch_testing_ament_cmake',
)
"""Needed to build, to lint or to generate, all of which is not needed here."""
COMPILED_ONLY = (
    'rclcpp',
    'rclcpp_action',
    'rclcpp_components',
    'rclcpp_lifecycle',
    'rcutils',
    'rmw',
    'rmw_implementation',
    'tf2',
    'tf2_eigen',
    'class_loader',
    'pluginlib',
    'yaml-cpp',
    'qtbase5-dev',
    'libqt5-core',
    'libqt5-gui',
    'boost',
)
"""Libraries of C++ programs, which do not run here anyway."""
COMMAND_LINE = (
    'ros2cli',
    'ros2launch',
    'ros2run',
    'ros2topic',
    'ros2service',
    'ros2action',
    'ros2param',
    'ros2node',
    'ros2pkg',
    'ros2interface',
    'ros2bag',
)
"""What edulaunch does itself."""
SAME = {'tf2_ros_py': 'tf2_ros'}
"""Packages whose part for Python goes by another name."""
PYTHON_NAMES = {
    'opencv-python': 'cv2',
    'opencv': 'cv2',
    'pil': 'PIL',
    'serial': 'serial',
    'pyyaml': 'yaml',
    'tk': 'tkinter',
    'pyqt5': 'PyQt5',
    'sklearn': 'sklearn',
    'matplotlib': 'matplotlib',
}


class Missing(NamedTuple):
    """A dependency that is not here, of which package, and the nearest name that is."""

    package: SourcePackage
    dependency: Dependency
    nearest: str | None


def missing_dependencies(path: str) -> tuple[list[str], list[Missing]]:
    """The packages below `path`, and each dependency of theirs that neither the underlay nor the workspace has."""
    index = Index((), [path])
    packages = source_packages(index)
    here = sorted({*index.packages(), *faces()})
    missing = []
    for package in packages:
        told: set[str] = set()
        for dependency in package.dependencies:
            if dependency.name not in told and not is_here(dependency.name, here):
                told.add(dependency.name)
                missing.append(Missing(package, dependency, nearest(dependency.name, here)))
    return [package.name for package in packages], missing


def is_here(name: str, here: list[str]) -> bool:
    """Whether a dependency is satisfied, or needed only for what edulaunch does not do (building, compiled programs)."""
    if SAME.get(name, name) in here or name in (*BUILD_ONLY, *COMPILED_ONLY, *COMMAND_LINE):
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


def faces() -> list[str]:
    """The import packages of the underlay: they have no share folder of their own, and are there."""
    from edulaunch.underlay_place import underlay_python

    return sorted(name for name in os.listdir(underlay_python()) if os.path.isdir(os.path.join(underlay_python(), name)))

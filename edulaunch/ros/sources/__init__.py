"""Reads the build files of source packages, setup.py and CMakeLists.txt, without running them.

Code that creates an `Index` of source workspaces passes `read_source` to it. `setup_script.py` reads a setup.py, with
`static_python.py` and `static_values.py` as its small interpreter. `setup_tables.py` reads setup.cfg and pyproject.toml, and
`cmake.py` reads a CMakeLists.txt, whose syntax `cmake_text.py` parses. `source_package.py` describes one package of a
workspace with its files. `missing.py` collects facts about something that is not found, from which `edulaunch.advice`
creates messages.
"""

from __future__ import annotations

import os

from edulaunch.engine.packages.reading import Contents, Manifest, PackageWarning


def read_source(manifest: Manifest) -> Contents:
    """Return what a source package installs, by its build type; see `edulaunch.engine.packages.reading.SourceReader`."""
    if manifest.build_type == 'ament_python':
        from edulaunch.ros.sources.setup_script import (
            read_setup_script,
        )  # imported here, because most runs read only one kind of package, or none

        return read_setup_script(manifest)
    if manifest.build_type not in ('ament_cmake', 'catkin', 'cmake'):
        message = f'names the build type {manifest.build_type!r}, which colcon cannot build; write ament_python or ament_cmake'
        contents = Contents()
        contents.broken = PackageWarning(os.path.join(manifest.folder, 'package.xml'), 0, message)
        contents.warnings.append(contents.broken)
        return contents
    from edulaunch.ros.sources.cmake import read_cmake_lists

    contents = read_cmake_lists(manifest)
    if manifest.build_type == 'catkin':  # many commands in CMakeLists.txt have another meaning in catkin
        contents.unread = 'catkin'
        contents.warnings = [PackageWarning(os.path.join(manifest.folder, 'package.xml'), 0, manifest.name, 'ROS 1')]
    return contents

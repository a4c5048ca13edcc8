"""package.xml: the name of a package and how it is built."""

from __future__ import annotations

import os
import re
from typing import NamedTuple

from edulaunch.packages.reading import PackageWarning

_NAME = re.compile(r'[a-zA-Z0-9][a-zA-Z0-9_-]*')


class Manifest(NamedTuple):
    """Name, build type ('ament_python', 'ament_cmake', ...) and folder of a source package."""

    name: str
    build_type: str
    folder: str


def read_manifest(folder: str, warnings: list[PackageWarning]) -> Manifest | None:
    """Read `folder`/package.xml; what is wrong with it is added to `warnings`, and None returned when it has
    no name."""
    from xml.etree import ElementTree

    file = os.path.join(folder, 'package.xml')
    try:
        root = ElementTree.parse(file).getroot()
    except ElementTree.ParseError as error:
        warnings.append(
            PackageWarning(file, error.position[0], f'this is not well-formed XML ({error}), so {_what_colcon_does(folder)}')
        )
        return None
    except OSError as error:
        warnings.append(PackageWarning(file, 0, f'cannot be read ({error.strerror})'))
        return None
    name = (root.findtext('name') or '').strip()
    if root.tag != 'package' or not _NAME.fullmatch(name):
        warnings.append(
            PackageWarning(file, 0, f'has no usable <name> inside <package> (found {name!r}), so {_what_colcon_does(folder)}')
        )
        return None
    build_type = (root.findtext('export/build_type') or '').strip() or _guess_build_type(folder)
    return Manifest(name, build_type, folder)


def _what_colcon_does(folder: str) -> str:
    """To colcon a folder without a usable package.xml is a package of Python or CMake, and none of ROS 2."""
    for file, kind in (('setup.py', 'Python'), ('CMakeLists.txt', 'CMake')):
        if os.path.isfile(os.path.join(folder, file)):
            return f'colcon builds it as a plain {kind} package, which `ros2 launch` and `ros2 run` do not find'
    return 'colcon skips the package'


def _guess_build_type(folder: str) -> str:
    """ROS takes ament_cmake for packages that do not say; a lone setup.py can only mean the other one."""
    has_cmake = os.path.isfile(os.path.join(folder, 'CMakeLists.txt'))
    return 'ament_python' if not has_cmake and os.path.isfile(os.path.join(folder, 'setup.py')) else 'ament_cmake'

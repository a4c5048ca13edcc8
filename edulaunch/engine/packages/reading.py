"""Finds the packages of a source workspace, as colcon does, and defines the result of reading a package."""

from __future__ import annotations

import os
import re
from typing import NamedTuple, Protocol

from edulaunch.engine.underlay_place import help_text


class PackageWarning(NamedTuple):
    """A problem of a package: a build would reject the package, or only a build can determine a value.

    `line` counts from 1; 0 means the whole file. `about` is the kind of problem:
    - 'unknown': nothing is wrong, but only a build can determine a value
    - 'same name': another package has the same name
    - 'ROS 1': ROS 2 does not build the package
    - `stand-in`: a built-in program is used instead
    - '': any other problem
    """

    file: str
    line: int
    sentence: str
    about: str = ''

    def __str__(self) -> str:
        place = f'{self.file}:{self.line}' if self.line else self.file
        return f'{place}: {self.sentence}'


class Contents:
    """The files and programs that a package installs, according to its build file.

    :param files: path below the prefix -> absolute path of the source file.
    :param entry_points: path below the prefix (`lib/<package>/<executable>`) -> (module, function).
    :param programs: the entries of `files` that are installed as executables.
    :param python_modules: top-level import name -> absolute path of its folder or .py file.
    :param native: executables that are built from C++ or C and cannot run here (name -> line of the build file).
    :param announced: group of entry points -> lines `name = package.module:attribute`.
    :param version: the version in `setup()`, or ''.
    :param unread: the part of the build file that only a build can evaluate, or '' if there is no such part.
    :param broken: the reason why a build would stop before it installs anything, or ''. `warnings` contains this reason, too.
    :param interfaces: whether `files` contains .msg, .srv or .action files.
    """

    def __init__(self) -> None:
        self.files: dict[str, str] = {}
        self.entry_points: dict[str, tuple[str, str]] = {}
        self.programs: set[str] = set()
        self.python_modules: dict[str, str] = {}
        self.native: dict[str, int] = {}
        self.unread = ''
        self.broken: PackageWarning | None = None
        self.interfaces = False
        self.warnings: list[PackageWarning] = []


class Program(NamedTuple):
    """A program of a package. All programs except native and absent programs run in the simulation.

    :param kind: the kind of program. 'entry_point' is a function of a module, 'script' a file that runs as `__main__`, and
        'module' is for `python3 -m`. With 'shell', `file` is a shell line. A 'native' or 'absent' program ends immediately
        with an explanation. A 'native' program is built from C++, and `file` is its line in CMakeLists.txt. An 'absent'
        program is in a missing package, and `file` is the software that the package belongs to.
    :param path: `<prefix>/lib/<package>/<executable>`, the first word of a command line.
    :param module: dotted module name of an entry point, otherwise ''.
    :param function: name of the entry point's function, otherwise ''.
    :param file: the student's own script (never a generated link), otherwise ''.
    :param python_roots: folders from which this program's own modules are imported; the first folder with a module is used.
    """

    kind: str
    package: str
    executable: str
    path: str
    module: str = ''
    function: str = ''
    file: str = ''
    python_roots: tuple[str, ...] = ()


_NAME = re.compile(r'[a-zA-Z0-9][a-zA-Z0-9_-]*')


class Manifest(NamedTuple):
    """A source package: its name and build type ('ament_python', 'ament_cmake', ...) from package.xml, and its folder."""

    name: str
    build_type: str
    folder: str


class SourceReader(Protocol):
    """A function that reads a package's build file without running it, such as the one in `edulaunch.ros.sources`."""

    def __call__(self, manifest: Manifest, /) -> Contents:
        """Return the files and programs that the package installs. Its warnings include everything that a build would reject."""


def read_manifest(folder: str, warnings: list[PackageWarning]) -> Manifest | None:
    """Read `folder`/package.xml, and add its problems to `warnings`. Return None if it is invalid or contains no name."""
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
    tools = {(element.text or '').strip() for element in root.iter('buildtool_depend')}
    is_of_ros_1 = 'catkin' in tools and not any(tool.startswith('ament') for tool in tools)
    build_type = (root.findtext('export/build_type') or '').strip() or ('catkin' if is_of_ros_1 else _guess_build_type(folder))
    return Manifest(name, build_type, folder)


def _what_colcon_does(folder: str) -> str:
    """Return the end of a sentence: what colcon does with a folder without a usable package.xml."""
    for file, kind in (('setup.py', 'Python'), ('CMakeLists.txt', 'CMake')):
        if os.path.isfile(os.path.join(folder, file)):
            return help_text('plain-package', kind=kind)
    return help_text('skipped-package')


def _guess_build_type(folder: str) -> str:
    """Return ament_python for a package with setup.py and no CMakeLists.txt, otherwise ament_cmake."""
    has_cmake = os.path.isfile(os.path.join(folder, 'CMakeLists.txt'))
    return 'ament_python' if not has_cmake and os.path.isfile(os.path.join(folder, 'setup.py')) else 'ament_cmake'


_BUILD_FOLDERS = frozenset(('build', 'install', 'log', '__pycache__', 'node_modules'))
IGNORE_FILES = frozenset(('COLCON_IGNORE', 'AMENT_IGNORE', 'CATKIN_IGNORE', 'pyvenv.cfg'))
_MAX_FOLDERS = 5000


def find_packages(workspace: str, warnings: list[PackageWarning], most: int = _MAX_FOLDERS) -> list[str]:
    """Return the folders with a package.xml in `workspace` or below, sorted by depth and name.

    The search does not enter packages, build/ install/ log/, hidden folders, virtual environments, or folders with a
    COLCON_IGNORE. The search follows links to folders, as colcon does, but visits no folder twice. It stops with a warning
    after `most` folders, because the user may have named a whole home folder.
    """
    found: list[str] = []
    waiting = [workspace]
    seen: set[str] = set()
    while waiting:
        folder = waiting.pop()
        real = os.path.realpath(folder)
        if real in seen:
            continue
        seen.add(real)
        if len(seen) > most:
            warnings.append(
                PackageWarning(
                    workspace,
                    0,
                    f'more than {most} folders; the rest was not searched for packages. Name the workspace folder itself',
                )
            )
            break
        files, folders = list_folder(folder)
        if files & IGNORE_FILES:
            continue
        if 'package.xml' in files:
            found.append(folder)
        else:
            waiting += [os.path.join(folder, name) for name in reversed(folders)]
    return sorted(found, key=lambda folder: (folder.count(os.sep), folder))


def list_folder(folder: str) -> tuple[frozenset[str], list[str]]:
    """Return the names of the files in a folder, and of the folders to search. Real folders come before links, so that a folder
    that can be reached in both ways gets its real path.
    """
    files: list[str] = []
    folders: list[str] = []
    links: list[str] = []
    try:
        with os.scandir(folder) as entries:
            for entry in entries:
                if not entry.is_dir():
                    files.append(entry.name)
                elif not entry.name.startswith('.') and entry.name not in _BUILD_FOLDERS:
                    (links if entry.is_symlink() else folders).append(entry.name)
    except OSError:
        return frozenset(), []  # a folder we may not read holds no package that we could use
    return frozenset(files), [*sorted(folders), *sorted(links)]

"""The index, which combines source workspaces, install prefixes, the underlay, and their interfaces."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Protocol

from edulaunch.engine.interfaces.registry import Registry, underlay_registry
from edulaunch.engine.packages.absent import absent_kind
from edulaunch.engine.packages.prefix import Prefix, Underlay, expand_prefixes
from edulaunch.engine.packages.reading import Contents, PackageWarning, Program, SourceReader
from edulaunch.engine.packages.workspace import Workspace
from edulaunch.engine.underlay_place import help_text, underlay_prefix

if TYPE_CHECKING:
    from edulaunch.engine.interfaces.registry import Registry


class Place(Protocol):
    """A prefix, or a folder that is presented as a prefix.

    :attr:`path` is the prefix folder. Methods with a parameter `package` need the name of a package that :meth:`packages`
        returns.
    """

    path: str

    def packages(self) -> list[str]:
        """Return the names of the packages in this place, sorted."""

    def install(self, package: str) -> None:
        """Make sure that the package's files exist below :attr:`path`."""

    def executables(self, package: str) -> list[str]:
        """Return the names of the package's executables in `lib/<package>`, sorted."""

    def program(self, package: str, executable: str) -> Program | None:
        """Return the Python program of an executable. Return None if the executable is unknown or not a Python program."""

    def modules(self) -> dict[str, str]:
        """Return the folder or .py file of each top-level module of these packages, by import name."""

    def interface_packages(self) -> list[str]:
        """Return the packages with msg/, srv/ or action/ in their share folder, sorted."""

    def source_path(self, path: str) -> str | None:
        """Return the student's own file for a path below :attr:`path`, or None if there is no such file."""


_ON_PATH = ('rviz2', 'xacro')
"""Programs that ROS 2 also installs into `bin/`; each package has the name of its program."""

_OWN_MODULES = frozenset(
    ('ament_index_python', 'launch', 'launch_ros', 'launch_testing', 'launch_testing_ros', 'launch_xml', 'launch_yaml', 'rclpy')
    + ('ros2launch', 'rosidl_parser', 'rosidl_runtime_py', 'tf2_geometry_msgs', 'tf2_py', 'tf2_ros', 'tf2_sensor_msgs')
)
"""Modules of ROS that need a middleware; a clone of their sources in a workspace would need the real one."""


class Index:
    """An index that finds packages, their share folders, executables, modules and interfaces.

    The search begins with the workspaces in the given order, continues with the prefixes, and ends with the built-in
    underlay. Paths are strings. A package of a source workspace is presented as if it were installed, in a generated prefix
    of links. Use :meth:`source_path` to get the student's own file.

    :param prefixes: install prefixes, or colcon `install/` folders of either layout.
    :param workspaces: folders with source packages.
    :param read_source: the function that reads the build file of a package; not needed without workspaces.
    :param underlay: the prefix of the built-in packages, or None for an index without these packages.
    :param near: a folder. If a workspace has two packages with the same name, the package that is nearer to this folder is
        used.
    :ivar workspaces: the source workspaces, in order of search.
    """

    def __init__(
        self,
        prefixes: Iterable[str | os.PathLike[str]] = (),
        workspaces: Iterable[str | os.PathLike[str]] = (),
        *,
        read_source: SourceReader | None = None,
        underlay: str | None = underlay_prefix(),
        near: str = '',
    ) -> None:
        self.read_source = read_source
        self._warnings: list[PackageWarning] = []
        self.workspaces = [self._workspace(os.fspath(folder), near) for folder in workspaces]
        expanded = [path for prefix in prefixes for path in expand_prefixes(os.path.abspath(os.fspath(prefix)))]
        self._places: list[Place] = [*self.workspaces, *map(Prefix, dict.fromkeys(path for path in expanded if path != underlay))]
        self._underlay = underlay
        if underlay is not None:
            self._places.append(Underlay(underlay))

    def _workspace(self, folder: str, near: str) -> Workspace:
        if self.read_source is None:
            raise TypeError('an Index of source workspaces needs read_source')
        return Workspace(folder, self.read_source, self._warnings, near)

    @property
    def warnings(self) -> tuple[PackageWarning, ...]:
        """The problems of the packages that have been read so far."""
        return tuple(self._warnings)

    def search_paths(self) -> list[str]:
        """Return the prefixes in order of search, as in AMENT_PREFIX_PATH."""
        return [place.path for place in self._places]

    def packages(self) -> dict[str, str]:
        """Return the prefix of each package, by package name. If several places have a package, the first place is used."""
        found: dict[str, str] = {}
        for place in self._places:
            for name in place.packages():
                found.setdefault(name, place.path)
        return dict(sorted(found.items()))

    def prefix(self, package: str) -> str | None:
        """Return the prefix that has the package, or None if there is no such package. The package's files exist there after
        this call.
        """
        place = self._place(package)
        if place is None:
            return None
        place.install(package)
        return place.path

    def share(self, package: str) -> str | None:
        """Return `<prefix>/share/<package>`, or None if there is no such package.

        The folder itself may be missing, as in ROS.
        """
        prefix = self.prefix(package)
        return None if prefix is None else os.path.join(prefix, 'share', package)

    def absent(self, package: str) -> str | None:
        """Return the software that a missing well-known package belongs to ('Gazebo'). Return None for an existing or unknown
        package.

        The files of a missing package would be below :attr:`absent_prefix`.
        """
        return None if self._underlay is None or self._place(package) is not None else absent_kind(package)

    @property
    def absent_prefix(self) -> str:
        """The prefix in which missing packages would be: the prefix of the built-in packages, or '' without an underlay."""
        return self._underlay or ''

    def executables(self, package: str) -> list[str]:
        """Return the names of the package's executables, sorted. An unknown package has no executables.

        If a workspace contains the C++ source of a built-in package, the built-in executables are included.
        """
        place = self._place(package)
        if place is None:
            return []
        others = self._places[self._places.index(place) + 1 :] if isinstance(place, Workspace) else []
        built_in = [name for other in others if package in other.packages() for name in other.executables(package)]
        return sorted({*place.executables(package), *(name for name in built_in if self._stand_in(place, package, name))})

    def find_executable(self, package: str, executable: str) -> str | None:
        """Return `<prefix>/lib/<package>/<executable>`, or None if the package does not have this executable.

        For an entry point, the file may not exist.
        """
        place = self._place(package)
        if place is None or executable not in self.executables(package):
            return None
        return os.path.join(place.path, 'lib', package, executable)

    def native_executables(self, package: str) -> dict[str, str]:
        """Return the executables that would be built from C++ and cannot run here, as name -> 'file:line'."""
        place = self._place(package)
        if not isinstance(place, Workspace):
            return {}
        folder = place.package_folder(package)
        return {name: f'{os.path.join(folder, "CMakeLists.txt")}:{line}' for name, line in place.contents(package).native.items()}

    def contents(self, package: str) -> Contents | None:
        """Return the files and programs that a source package installs according to its build file. Return None for any other
        package.
        """
        place = self._place(package)
        return place.contents(package) if isinstance(place, Workspace) else None

    def source_folder(self, package: str) -> str | None:
        """Return the folder with the package.xml of a source package. Return None for any other package."""
        place = self._place(package)
        return place.package_folder(package) if isinstance(place, Workspace) else None

    def find_program(self, path: str) -> Program | None:
        """Return the program that `<prefix>/lib/<package>/<executable>` starts, or None for a program of the real machine.

        `rviz2` and `xacro` are found even if the path has another folder, because ROS also has them on the PATH.
        """
        folder, executable = os.path.split(path)
        lib, package = os.path.split(folder)
        prefix, name = os.path.split(lib)
        if executable in _ON_PATH and name != 'lib' and (place := self._place(executable)) is not None:
            return place.program(executable, executable)
        if name != 'lib':
            return None
        for place in self._places:
            if place.path == prefix and package in place.packages():
                own = place.program(package, executable)
                stand_in = None if own is not None else self._stand_in(place, package, executable)
                if isinstance(place, Workspace) and stand_in is not None:
                    self._note_stand_in(place, package, executable)
                return own or stand_in or self._native(package, executable, path)
        kind = self.absent(package) if prefix == self._underlay else None
        return None if kind is None else Program('absent', package, executable, path, file=kind)

    def _native(self, package: str, executable: str, path: str) -> Program | None:
        """Return a program of the workspace that only a C++ compiler could build, or None."""
        line = self.native_executables(package).get(executable)
        return None if line is None else Program('native', package, executable, path, file=line)

    def _stand_in(self, place: Place, package: str, executable: str) -> Program | None:
        """Return the built-in program that replaces a C++ program of a workspace, or None."""
        if not isinstance(place, Workspace) or place.contents(package).entry_points:
            return None
        for other in self._places[self._places.index(place) + 1 :]:
            program = other.program(package, executable) if package in other.packages() else None
            if program is not None:
                return program._replace(path=os.path.join(place.path, 'lib', package, executable))
        return None

    def _note_stand_in(self, place: Workspace, package: str, executable: str) -> None:
        file = os.path.join(place.package_folder(package), 'CMakeLists.txt')
        sentence = help_text('stand-in', executable=executable, package=package)
        warning = PackageWarning(file, place.contents(package).native.get(executable, 0), sentence, 'stand-in')
        if warning not in self._warnings:
            self._warnings.append(warning)

    def python_modules(self) -> dict[str, str]:
        """Return the folder or .py file of each top-level module that every program loads separately, by module name.

        ROS's own modules are always the built-in modules, because clones of them in a workspace need the real middleware.
        """
        found: dict[str, str] = {}
        for place in self._places:
            for name, path in _modules(place).items():
                found.setdefault(name, path)
        return found

    def python_roots(self) -> list[str]:
        """Return the folders in workspaces and prefixes that contain :meth:`python_modules`, in order of search."""
        places = [place for place in self._places if place.path != self._underlay]
        return list(dict.fromkeys(os.path.dirname(path) for place in places for path in _modules(place).values()))

    def interface_roots(self) -> list[str]:
        """Return the share folder of each package with interface files. The name of the folder is the name of the package."""
        found: dict[str, str] = {}
        for place in self._places:
            for package in place.interface_packages():
                found.setdefault(package, os.path.join(place.path, 'share', package))
        return list(found.values())

    def source_path(self, path: str) -> str:
        """Return the student's own file for a path in a generated prefix of links, and any other path unchanged."""
        for place in self._places:
            found = place.source_path(path)
            if found is not None:
                return found
        return path

    def _place(self, package: str) -> Place | None:
        return next((place for place in self._places if package in place.packages()), None)


def _modules(place: Place) -> dict[str, str]:
    """Return the modules of a place. A workspace's clones of ROS's own modules are left out."""
    is_own = isinstance(place, Workspace)
    return {name: path for name, path in place.modules().items() if not (is_own and name in _OWN_MODULES)}


def interfaces_of(index: Index) -> tuple[frozenset[str], Registry]:
    """Return the packages whose interfaces come from a workspace, and a registry of all interfaces.

    If the underlay has the same package, the underlay's interfaces are used, because the underlay's programs communicate
    with them. The workspace's interfaces are used only if the workspace has types that the underlay lacks.
    """
    shared, inside = underlay_registry(), os.path.join(underlay_prefix(), 'share')
    folders = {os.path.basename(folder): folder for folder in index.interface_roots() if os.path.dirname(folder) != inside}
    own = frozenset(name for name in folders if not shared.has(name) or _adds(folders[name], name, shared))
    if not own:
        return own, shared
    roots = list(dict.fromkeys(os.path.dirname(folder) for folder in folders.values()))
    return own, Registry(roots, shared, leave=frozenset(folders) - own)


def _adds(folder: str, package: str, shared: Registry) -> bool:
    """Return whether a share folder contains an interface that is missing in the underlay's package of the same name."""
    return any(
        name.removesuffix(f'.{kind}') not in shared.names(package, kind)
        for kind in ('msg', 'srv', 'action')
        if os.path.isdir(os.path.join(folder, kind))
        for name in sorted(os.listdir(os.path.join(folder, kind)))
        if name.endswith(f'.{kind}')
    )

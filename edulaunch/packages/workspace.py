"""A folder of source packages, read without building it."""

from __future__ import annotations

import os

from edulaunch.packages.image import Image
from edulaunch.packages.manifest import Manifest, read_manifest
from edulaunch.packages.prefix import is_python
from edulaunch.packages.program import Program
from edulaunch.packages.reading import Contents, PackageWarning
from edulaunch.packages.scan import find_packages


class Workspace:
    """One source workspace; packages are found at the first question, and read one by one.

    :param folder: the workspace, its `src/`, or a single package.
    :param warnings: where everything goes that a build would reject.
    """

    def __init__(self, folder: str, warnings: list[PackageWarning]) -> None:
        self.folder = os.path.abspath(folder)
        self._image = Image(self.folder)
        self.path = self._image.path
        self._warnings = warnings
        self._found: dict[str, Manifest] | None = None
        self._contents: dict[str, Contents] = {}
        self._installed: set[str] = set()

    def packages(self) -> list[str]:
        """Names from the package.xml files."""
        return sorted(self._manifests())

    def install(self, package: str) -> None:
        """Put the package into the generated prefix."""
        if package not in self._installed:
            self._image.add(package, self.contents(package))
            self._installed.add(package)

    def executables(self, package: str) -> list[str]:
        """Entry points and installed programs."""
        folder = f'lib/{package}'
        contents = self.contents(package)
        return sorted(
            os.path.basename(name) for name in {*contents.entry_points, *contents.programs} if os.path.dirname(name) == folder
        )

    def program(self, package: str, executable: str) -> Program | None:
        """A console script, or an installed Python file."""
        name = f'lib/{package}/{executable}'
        contents = self.contents(package)
        path = os.path.join(self.path, name)
        entry = contents.entry_points.get(name)
        roots = tuple(dict.fromkeys(os.path.dirname(place) for place in contents.python_modules.values()))
        if entry is not None:
            return Program('entry_point', package, executable, path, entry[0], entry[1], python_roots=roots)
        if name in contents.programs and is_python(contents.files[name]):
            return Program('script', package, executable, path, file=contents.files[name], python_roots=roots)
        return None

    def modules(self) -> dict[str, str]:
        """What the packages' build files install for import."""
        found: dict[str, str] = {}
        for package in self.packages():
            for name, path in self.contents(package).python_modules.items():
                found.setdefault(name, path)
        return found

    def interface_packages(self) -> list[str]:
        """Packages whose build file generates or installs interfaces; their files are put into the prefix."""
        found = [package for package in self.packages() if self.contents(package).interfaces]
        for package in found:
            self.install(package)
        return found

    def source_path(self, path: str) -> str | None:
        """The student's own file."""
        return self._image.source_path(path)

    def contents(self, package: str) -> Contents:
        """What the package installs; read at the first question."""
        contents = self._contents.get(package)
        if contents is None:
            contents = self._contents[package] = _read(self._manifests()[package])
            self._warnings += contents.warnings
        return contents

    def package_folder(self, package: str) -> str:
        """The folder with the package.xml."""
        return self._manifests()[package].folder

    def _manifests(self) -> dict[str, Manifest]:
        if self._found is None:
            self._found = {}
            for folder in find_packages(self.folder, self._warnings):
                manifest = read_manifest(folder, self._warnings)
                if manifest is not None:
                    self._note(self._found, manifest)
        return self._found

    def _note(self, found: dict[str, Manifest], manifest: Manifest) -> None:
        first = found.setdefault(manifest.name, manifest)
        if first is not manifest:
            other = os.path.relpath(first.folder, self.folder)
            self._warnings.append(
                PackageWarning(
                    os.path.join(manifest.folder, 'package.xml'),
                    0,
                    f'there is a package {manifest.name!r} in {other}/ already, which is used; colcon refuses duplicate names',
                )
            )


def _read(manifest: Manifest) -> Contents:
    if manifest.build_type == 'ament_python':
        from edulaunch.packages.setup_script import read_setup_script

        return read_setup_script(manifest)
    from edulaunch.packages.cmake import read_cmake_lists

    return read_cmake_lists(manifest)

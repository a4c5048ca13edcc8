"""Substitutions for folders of a package."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from launch.substitution import SomeSubstitutionsType, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions, plain_text

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class FindPackage(Substitution):
    """The base class of substitutions for folders of a package. Subclasses define :meth:`find`."""

    def __init__(self, package: SomeSubstitutionsType) -> None:
        super().__init__()
        text = plain_text(package)
        self.__package = text if text is not None else normalize_to_list_of_substitutions(package)

    @property
    def package(self) -> list[Substitution]:
        """The name of the package."""
        return normalize_to_list_of_substitutions(self.__package)

    def _package_name(self, context: LaunchContext) -> str:
        package = self.__package
        return package if isinstance(package, str) else perform_substitutions(context, package)

    def find(self, package_name: str) -> str:
        """Return the folder of the package.

        :raises NotImplementedError: in this base class, as in upstream.
        """
        raise NotImplementedError('find() is for subclasses of FindPackage')

    def describe(self) -> str:
        """Return the description that `ros2 launch -s` shows."""
        package = ' + '.join(sub.describe() for sub in self.package)
        return f'{type(self).__name__}(pkg={package})'

    def perform(self, context: LaunchContext) -> str:
        """Return the folder of the package.

        :raises PackageNotFoundError: when there is no such package.
        :raises ValueError: when the string cannot be a package name.
        """
        return self.find(self._package_name(context))


class FindPackagePrefix(FindPackage):
    """The install prefix of a package."""

    def find(self, package_name: str) -> str:
        """Return the install prefix of the package."""
        from ament_index_python.packages import get_package_prefix

        return get_package_prefix(package_name)


class FindPackageShare(FindPackagePrefix):
    """The share folder of a package, which contains its launch and configuration files."""

    def find(self, package_name: str) -> str:
        """Return `<prefix>/share/<package>`."""
        return os.path.join(super().find(package_name), 'share', package_name)

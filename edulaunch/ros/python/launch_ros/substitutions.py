"""Substitutions that look things up in packages and among global parameters."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly
from launch._engine import absent_package, state_of
from launch._lazy import has_ros_paths
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.substitutions.text_substitution import SubstitutionFailure
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions, plain_text

from edulaunch.engine.facts import with_facts

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class FindPackage(Substitution):
    """Base of the substitutions below; subclasses give :meth:`find`."""

    def __init__(self, package: SomeSubstitutionsType) -> None:
        super().__init__()
        text = plain_text(package)
        self.__package = text if text is not None else normalize_to_list_of_substitutions(package)

    @property
    def package(self) -> list[Substitution]:
        """The package's name."""
        return normalize_to_list_of_substitutions(self.__package)

    def _package_name(self, context: LaunchContext) -> str:
        package = self.__package
        return package if isinstance(package, str) else perform_substitutions(context, package)

    def find(self, package_name: str) -> str:
        """The path to substitute.

        :raises NotImplementedError: in this base class, as upstream.
        """
        raise NotImplementedError('find() is for subclasses of FindPackage')

    def describe(self) -> str:
        """As `ros2 launch -s` shows it."""
        package = ' + '.join(sub.describe() for sub in self.package)
        return f'{type(self).__name__}(pkg={package})'

    def perform(self, context: LaunchContext) -> str:
        """The path.

        :raises PackageNotFoundError: when there is no such package.
        :raises ValueError: when this cannot be a package name.
        """
        return self.find(self._package_name(context))


class FindPackagePrefix(FindPackage):
    """The install prefix of a package."""

    def find(self, package_name: str) -> str:
        """`<prefix>`."""
        from ament_index_python.packages import get_package_prefix

        return get_package_prefix(package_name)


class FindPackageShare(FindPackagePrefix):
    """The share folder of a package, where its launch and configuration files are."""

    def find(self, package_name: str) -> str:
        """`<prefix>/share/<package>`."""
        return os.path.join(super().find(package_name), 'share', package_name)


class ExecutableInPackage(FindPackagePrefix):
    """`<prefix>/lib/<package>/<executable>`.

    :raises SubstitutionFailure: on evaluation, when there is none; its facts say what there is.
    """

    def __init__(self, executable: SomeSubstitutionsType, package: SomeSubstitutionsType) -> None:
        super().__init__(package)
        text = plain_text(executable)
        self.__executable = text if text is not None else normalize_to_list_of_substitutions(executable)

    @property
    def executable(self) -> list[Substitution]:
        """The executable's name."""
        return normalize_to_list_of_substitutions(self.__executable)

    def describe(self) -> str:
        """As `ros2 launch -s` shows it."""
        package = ' + '.join(sub.describe() for sub in self.package)
        executable = ' + '.join(sub.describe() for sub in self.executable)
        return f'ExecInPkg(pkg={package}, exec={executable})'

    def perform(self, context: LaunchContext) -> str:
        """The path; the file need not exist for an entry point, nor for what is built from C++: the index knows both."""
        given = self.__executable
        executable = given if isinstance(given, str) else perform_substitutions(context, given)
        package = self._package_name(context)
        found: dict[tuple[str, str], str] = state_of(context).setdefault('launch_ros.executables', {})
        path = found.get((package, executable))
        if path is None:
            path = found[package, executable] = self.__find(context, package, executable)
        return path

    def __find(self, context: LaunchContext, package: str, executable: str) -> str:
        from edulaunch.engine.processes import current_process

        index = current_process().index
        if absent_package(package) is not None:  # it is where students have ROS 2; the program says here why it cannot run
            return os.path.join(index.absent_prefix, 'lib', package, executable)
        prefix = super().perform(context)
        folder = os.path.join(prefix, 'lib', package)
        native = index.native_executables(package)
        if index.find_executable(package, executable) or executable in native:
            return os.path.join(folder, executable)
        if not index.executables(package) and not native and not os.path.isdir(folder):
            raise _failure(
                f"package '{package}' found at '{prefix}', but libexec directory '{folder}' does not exist",
                index,
                package,
                executable,
            )
        raise _failure(f"executable '{executable}' not found on the libexec directory '{folder}' ", index, package, executable)


def _failure(message: str, index: Any, package: str, executable: str) -> SubstitutionFailure:
    """ROS's own error, with what is known of such an executable."""
    from edulaunch.advice.workspace.missing import missing_executable

    return with_facts(SubstitutionFailure(message), **missing_executable(index, package, executable))


class Parameter(Substitution):
    """The value that the nearest :class:`~launch_ros.actions.SetParameter` gave to a parameter, as a text.

    :param default: used when there is none.
    :raises SubstitutionFailure: on evaluation, when there is neither.
    """

    def __init__(self, name: SomeSubstitutionsType, *, default: SomeSubstitutionsType | None = None) -> None:
        super().__init__()
        self.__name = normalize_to_list_of_substitutions(name)
        self.__default = None if default is None else normalize_to_list_of_substitutions(default)

    name: ReadOnly[list[Substitution]] = ReadOnly("The parameter's name.")
    default: ReadOnly[list[Substitution] | None] = ReadOnly('The default.')

    def describe(self) -> str:
        """As `ros2 launch -s` shows it."""
        name = ' + '.join(sub.describe() for sub in self.name)
        return f'Parameter({name})'

    def perform(self, context: LaunchContext) -> str:
        """The text."""
        name = perform_substitutions(context, self.name)
        for entry in reversed(context.launch_configurations.get('global_params', [])):
            if isinstance(entry, tuple) and entry[0] == name:
                return str(entry[1])
        if self.__default is not None:
            return perform_substitutions(context, self.__default)
        from launch.substitutions.text_substitution import SubstitutionFailure

        raise SubstitutionFailure(f"parameter '{name}' not found")


has_ros_paths(__name__, 'ExecutableInPackage FindPackage FindPackagePrefix=find_package FindPackageShare=find_package Parameter')

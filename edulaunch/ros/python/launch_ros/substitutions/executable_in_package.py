"""The substitution `ExecutableInPackage`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from launch._engine import absent_package, state_of
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions, plain_text

from edulaunch.engine.facts import with_facts

from .find_package import FindPackagePrefix

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class ExecutableInPackage(FindPackagePrefix):
    """The path `<prefix>/lib/<package>/<executable>`.

    :raises SubstitutionFailure: on evaluation, for an unknown executable. The facts of the error list the known executables.
    """

    def __init__(self, executable: SomeSubstitutionsType, package: SomeSubstitutionsType) -> None:
        super().__init__(package)
        text = plain_text(executable)
        self.__executable = text if text is not None else normalize_to_list_of_substitutions(executable)

    @property
    def executable(self) -> list[Substitution]:
        """The name of the executable."""
        return normalize_to_list_of_substitutions(self.__executable)

    def describe(self) -> str:
        """Return the description that `ros2 launch -s` shows."""
        package = ' + '.join(sub.describe() for sub in self.package)
        executable = ' + '.join(sub.describe() for sub in self.executable)
        return f'ExecInPkg(pkg={package}, exec={executable})'

    def perform(self, context: LaunchContext) -> str:
        """Return the path of the executable. For an entry point or a C++ program, the file need not exist, because the index
        contains both.
        """
        unevaluated = self.__executable
        executable = unevaluated if isinstance(unevaluated, str) else perform_substitutions(context, unevaluated)
        package = self._package_name(context)
        found: dict[tuple[str, str], str] = state_of(context).setdefault('launch_ros.executables', {})
        path = found.get((package, executable))
        if path is None:
            path = found[package, executable] = self.__find(context, package, executable)
        return path

    def __find(self, context: LaunchContext, package: str, executable: str) -> str:
        from edulaunch.engine.processes import current_process

        index = current_process().index
        if absent_package(package) is not None:  # it exists in a real ROS 2; here, the program reports why it cannot run
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
    """Return ROS's own error, with facts about the missing executable."""
    from edulaunch.ros.sources.missing import missing_executable

    return with_facts(SubstitutionFailure(message), **missing_executable(index, package, executable))

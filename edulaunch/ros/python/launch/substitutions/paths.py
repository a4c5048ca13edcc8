"""Files and folders, and texts joined to such."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, ClassVar

from osrf_pycommon.process_utils import which

from .._absent_packages import absent_program
from .._bases import ReadOnly
from .._engine import assumptions, inside
from .._lazy import has_ros_paths
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .text_substitution import SubstitutionFailure, describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class StringJoinSubstitution(Substitution):
    """The parts joined with `delimiter` between them. Newer than Jazzy's first release."""

    def __init__(self, substitutions: Iterable[SomeSubstitutionsType], delimiter: SomeSubstitutionsType = '') -> None:
        self.__substitutions = [normalize_to_list_of_substitutions(part) for part in substitutions]
        self.__delimiter = normalize_to_list_of_substitutions(delimiter)

    substitutions: ReadOnly[list[list[Substitution]]] = ReadOnly('The parts, each a list of substitutions.')
    delimiter: ReadOnly[list[Substitution]] = ReadOnly('What stands between the parts.')

    def describe(self) -> str:
        """`StringJoin('a' + 'b')`."""
        return f'StringJoin({" + ".join(describe_all(part) for part in self.__substitutions)})'

    def perform(self, context: LaunchContext) -> str:
        """The joined text."""
        delimiter = perform_substitutions(context, self.__delimiter)
        return delimiter.join(perform_substitutions(context, part) for part in self.__substitutions)


class FindExecutable(Substitution):
    """The path of a program on the PATH of launch's process.

    :raises SubstitutionFailure: on evaluation, when it is not there.
    """

    def __init__(self, *, name: SomeSubstitutionsType) -> None:
        self.__name = normalize_to_list_of_substitutions(name)

    name: ReadOnly[list[Substitution]] = ReadOnly("The program's name, as substitutions.")

    def describe(self) -> str:
        """`FindExec('ls')`."""
        return f'FindExec({describe_all(self.__name)})'

    def perform(self, context: LaunchContext) -> str:
        """The path."""
        name = perform_substitutions(context, self.__name)
        path = which(name)
        assumed = assumptions() if path is None else None
        if assumed is not None:
            path = assumed.program(name)
        path = path or absent_program(name)
        if path is None:
            raise SubstitutionFailure(f"executable '{self.__name}' not found on the PATH")
        return path


class FileContent(Substitution):
    """The whole text of a file.

    :raises SubstitutionFailure: on evaluation, when there is no such file.
    """

    def __init__(self, path: SomeSubstitutionsType) -> None:
        self.__path = normalize_to_list_of_substitutions(path)

    path: ReadOnly[list[Substitution]] = ReadOnly('The path, as substitutions.')

    def describe(self) -> str:
        """`FileContent('path')`."""
        return f'FileContent({describe_all(self.__path)})'

    def perform(self, context: LaunchContext) -> str:
        """The text."""
        path = perform_substitutions(context, self.__path)
        try:
            with open(inside(path), encoding='utf-8') as file:
                return file.read()
        except FileNotFoundError as error:
            raise SubstitutionFailure(f'File not found: {path}') from error


class LaunchLogDir(Substitution):
    """The folder of this launch's log files. Asking for it makes it."""

    def describe(self) -> str:
        """`LaunchLogDir()`."""
        return 'LaunchLogDir()'

    def perform(self, context: LaunchContext) -> str:
        """The folder."""
        from ..logging import launch_config

        log_dir: str = launch_config.log_dir
        return log_dir


class PathJoinSubstitution(Substitution):
    """The parts joined with the path separator, by the rules of `os.path.join`.

    :param substitutions: each a text or one substitution (a list inside the list is a TypeError in Jazzy).
    """

    def __init__(self, substitutions: Iterable[str | Substitution]) -> None:
        self.__substitutions = normalize_to_list_of_substitutions(substitutions)

    substitutions: ReadOnly[list[Substitution]] = ReadOnly('The parts.')

    def describe(self) -> str:
        """`PathJoin(''a' + LaunchConfig('b')')`."""
        return f"PathJoin('{describe_all(self.__substitutions)}')"

    def perform(self, context: LaunchContext) -> str:
        """The joined path."""
        return os.path.join(*[context.perform_substitution(part) for part in self.__substitutions])


class PathSubstitution(PathJoinSubstitution):
    """As pathlib's paths: `PathSubstitution(FindPackageShare('p')) / 'launch' / ['robot_', name,
    '.launch.py']`.

    Newer than Jazzy's first release; here so that files written for it run.
    """

    def __init__(self, path: SomeSubstitutionsType) -> None:
        super().__init__([path] if isinstance(path, (str, Substitution)) else path)

    def __truediv__(self, part: SomeSubstitutionsType) -> PathSubstitution:
        """The path continued by one part; a list is joined to one part first."""
        whole = part if isinstance(part, (str, Substitution)) else StringJoinSubstitution(part)
        return PathSubstitution([*self.substitutions, whole])


class ThisLaunchFile(Substitution):
    """The path of the current launch file, absolute.

    "Current" is the file included last, also after its include has returned, as in ROS 2.

    :raises SubstitutionFailure: on evaluation, outside of launch files.
    """

    _local: ClassVar[str] = 'current_launch_file_path'

    def describe(self) -> str:
        """`ThisLaunchFile()`."""
        return f'{type(self).__name__}()'

    def perform(self, context: LaunchContext) -> str:
        """The path."""
        known = context.get_locals_as_dict()
        if self._local not in known:
            raise SubstitutionFailure(f'{type(self).__name__} used outside of a launch file (in a script)')
        path: str = known[self._local]
        return path


class ThisLaunchFileDir(ThisLaunchFile):
    """The folder of the current launch file, absolute.

    "Current" is the file included last, also after its include has returned, as in ROS 2.

    :raises SubstitutionFailure: on evaluation, outside of launch files.
    """

    _local = 'current_launch_file_directory'


has_ros_paths(__name__)

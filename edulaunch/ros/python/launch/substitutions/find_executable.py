"""The substitution `FindExecutable`."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING

from osrf_pycommon.process_utils import which

from edulaunch.engine.facts import with_facts
from edulaunch.engine.nearest import nearest_spelling

from .._absent_packages import absent_program
from .._bases import ReadOnly
from .._engine import assumptions
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class FindExecutable(Substitution):
    """The path of a program on the PATH of launch's process.

    :raises SubstitutionFailure: on evaluation, when the program does not exist.
    """

    def __init__(self, *, name: SomeSubstitutionsType) -> None:
        self.__name = normalize_to_list_of_substitutions(name)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name of the program, as substitutions.')

    def describe(self) -> str:
        """Return a description such as `FindExec('ls')`."""
        return f'FindExec({describe_all(self.__name)})'

    def perform(self, context: LaunchContext) -> str:
        """Return the path of the program."""
        name = perform_substitutions(context, self.__name)
        path = which(name)
        assumed = assumptions() if path is None else None
        if assumed is not None:
            path = assumed.program(name)
        path = path or absent_program(name)
        if path is None:
            error = SubstitutionFailure(f"executable '{self.__name}' not found on the PATH")
            raise with_facts(error, 'launch.program-absent', program=name, near=near_program(name))
        return path


def near_program(name: str) -> str | None:
    """Return the program on the PATH that a misspelt name probably means. Return None for names of up to four characters."""
    folders = [folder for folder in os.environ.get('PATH', '').split(os.pathsep) if os.path.isdir(folder)]
    return nearest_spelling(name, {program for folder in folders for program in os.listdir(folder)}) if len(name) > 4 else None

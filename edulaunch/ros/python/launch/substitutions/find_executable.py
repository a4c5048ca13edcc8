"""The substitution `FindExecutable`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from osrf_pycommon.process_utils import which

from edulaunch.engine.facts import with_facts

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

    :raises SubstitutionFailure: on evaluation, when it does not exist.
    """

    def __init__(self, *, name: SomeSubstitutionsType) -> None:
        self.__name = normalize_to_list_of_substitutions(name)

    name: ReadOnly[list[Substitution]] = ReadOnly("The program's name, as substitutions.")

    def describe(self) -> str:
        """`FindExec('ls')`."""
        return f'FindExec({describe_all(self.__name)})'

    def perform(self, context: LaunchContext) -> str:
        """Return the path."""
        name = perform_substitutions(context, self.__name)
        path = which(name)
        assumed = assumptions() if path is None else None
        if assumed is not None:
            path = assumed.program(name)
        path = path or absent_program(name)
        if path is None:
            error = SubstitutionFailure(f"executable '{self.__name}' not found on the PATH")
            raise with_facts(error, 'launch.program-absent', program=name)
        return path

"""The substitution `AnonName`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from .._bases import ReadOnly
from .._engine import running_process
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class AnonName(Substitution):
    """The name, followed by the host, the process ID and a random number. Equal names give equal results within one launch.

    The host is called `edulaunch`, and the number comes from the simulation's seed, so that results are the same in each run.
    """

    def __init__(self, name: SomeSubstitutionsType) -> None:
        self.__name = normalize_to_list_of_substitutions(name)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name to make unique, as substitutions.')

    def describe(self) -> str:
        """Return a description such as `AnonName('name')`."""
        return f'AnonName({describe_all(self.__name)})'

    def perform(self, context: LaunchContext) -> str:
        """Return the unique name."""
        name = perform_substitutions(context, self.__name)
        key = 'anon' + name
        if key not in context.launch_configurations:
            process = running_process()
            number = process.sim.random(key).randrange(2**63)
            unique = f'{name}_edulaunch_{process.pid}_{number}'
            context.launch_configurations[key] = unique.replace('.', '_').replace('-', '_').replace(':', '_')
        unique_name: str = context.launch_configurations[key]
        return unique_name

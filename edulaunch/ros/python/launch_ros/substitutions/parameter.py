"""The substitution `Parameter`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from launch._bases import ReadOnly
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.substitutions.substitution_failure import SubstitutionFailure
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class Parameter(Substitution):
    """The value that the most recent :class:`~launch_ros.actions.SetParameter` in scope has set for a parameter, as a string.

    :param default: the value if the parameter is not set.
    :raises SubstitutionFailure: on evaluation, when there is neither a value nor a default.
    """

    def __init__(self, name: SomeSubstitutionsType, *, default: SomeSubstitutionsType | None = None) -> None:
        super().__init__()
        self.__name = normalize_to_list_of_substitutions(name)
        self.__default = None if default is None else normalize_to_list_of_substitutions(default)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name of the parameter, as substitutions.')
    default: ReadOnly[list[Substitution] | None] = ReadOnly('The default, as substitutions, or None.')

    def describe(self) -> str:
        """Return the description that `ros2 launch -s` shows."""
        name = ' + '.join(sub.describe() for sub in self.name)
        return f'Parameter({name})'

    def perform(self, context: LaunchContext) -> str:
        """Return the value as a string."""
        name = perform_substitutions(context, self.name)
        for entry in reversed(context.launch_configurations.get('global_params', [])):
            if isinstance(entry, tuple) and entry[0] == name:
                return str(entry[1])
        if self.__default is not None:
            return perform_substitutions(context, self.__default)
        raise SubstitutionFailure(f"parameter '{name}' not found")

"""The action `SetParametersFromFile`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly
from launch.action import Action
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class SetParametersFromFile(Action):
    """Pass a parameter file to every node that starts later in this scope.

    :raises AssertionError: when such a node is executed and the path is not a file, as in upstream.
    """

    def __init__(self, filename: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__filename = normalize_to_list_of_substitutions(filename)

    filename: ReadOnly[list[Substitution]] = ReadOnly('The path, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Add the file to the launch configuration `global_params`."""
        path = perform_substitutions(context, self.__filename)
        context.launch_configurations.setdefault('global_params', []).append(path)

"""The condition `LaunchConfigurationEquals`."""

from __future__ import annotations

import warnings
from typing import TYPE_CHECKING

from ..condition import Condition
from ..substitution import SomeSubstitutionsType
from ..substitutions.text_substitution import describe_all
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class LaunchConfigurationEquals(Condition):
    """A condition that is true if the launch configuration equals the expected string. If None is expected, it is true if the
    configuration is not set.

    Upstream has deprecated this class in favour of `IfCondition(EqualsSubstitution(...))`. Creating an instance logs a warning.
    """

    def __init__(self, launch_configuration_name: str, expected_value: SomeSubstitutionsType | None) -> None:
        warnings.warn(
            "The 'LaunchConfigurationEquals' and 'LaunchConfigurationNotEquals' Conditions are deprecated. "
            "Use the 'EqualsSubstitution' and 'NotEqualsSubstitution' substitutions instead! E.g.:\n"
            f"  IfCondition(EqualsSubstitution(LaunchConfiguration('{launch_configuration_name}'), ...))",
            UserWarning,
            stacklevel=2,
        )
        self.__name = launch_configuration_name
        self.__expected = None if expected_value is None else normalize_to_list_of_substitutions(expected_value)
        super().__init__(predicate=self._predicate_func)

    _sign = 'is'

    @property
    def in_words(self) -> str:
        return f"if '{self.__name}' {self._sign} {'unset' if self.__expected is None else describe_all(self.__expected)}"

    def _predicate_func(self, context: LaunchContext) -> bool:
        expected = None if self.__expected is None else perform_substitutions(context, self.__expected)
        return bool(context.launch_configurations.get(self.__name) == expected)

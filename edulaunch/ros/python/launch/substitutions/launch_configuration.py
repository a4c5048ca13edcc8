"""The substitution `LaunchConfiguration`."""

from __future__ import annotations

import collections.abc
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.nearest import nearest_spelling

from .._bases import ReadOnly
from .._engine import running_process
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .substitution_failure import SubstitutionFailure
from .text_substitution import describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class LaunchConfiguration(Substitution):
    """The current value of a launch configuration, such as a launch argument.

    :param default: the value if the configuration is not set: a string, substitutions, or any scalar, which is converted with
        `str`.
    :raises SubstitutionFailure: on evaluation, when the configuration is not set and there is no default.
    """

    def __init__(self, variable_name: SomeSubstitutionsType, *, default: Any = None) -> None:
        self.__variable_name = normalize_to_list_of_substitutions(variable_name)
        self.__default: list[Substitution] | None = None if default is None else _normalize_default(default)

    variable_name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')

    def describe(self) -> str:
        """Return a description such as `LaunchConfig('name')`."""
        return f'LaunchConfig({describe_all(self.__variable_name)})'

    def perform(self, context: LaunchContext) -> str:
        """Return the value of the launch configuration, or the default."""
        name = perform_substitutions(context, self.__variable_name)
        names_read = getattr(context, '_names_read', None)  # missing in contexts that unit tests create
        if names_read is not None:
            names_read[name] = True
        configurations = context.launch_configurations
        if name in configurations:
            value: str = configurations[name]
            return value
        if self.__default is None:
            raise with_facts(SubstitutionFailure(f"launch configuration '{name}' does not exist"), **_facts(name, configurations))
        return perform_substitutions(context, self.__default)


def _facts(name: str, configurations: dict[str, str]) -> dict[str, Any]:
    near = nearest_spelling(name, configurations)
    declared = any(argument.name == name for argument in running_process().state.get('launch.declared', ()))
    scoped = name if near is None and declared else None
    return {'about': 'launch.no-configuration', 'configuration': name, 'near': near, 'scoped': scoped}


def _normalize_default(default: Any) -> list[Substitution]:
    single = isinstance(default, (str, Substitution)) or not isinstance(default, collections.abc.Iterable)
    items: Iterable[Any] = (default,) if single else default
    return normalize_to_list_of_substitutions([item if isinstance(item, (str, Substitution)) else str(item) for item in items])

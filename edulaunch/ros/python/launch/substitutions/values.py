"""Values that launch knows by name."""

from __future__ import annotations

import collections.abc
from collections.abc import Iterable
from functools import lru_cache
from types import CodeType
from typing import TYPE_CHECKING, Any

from edulaunch.engine.facts import with_facts
from edulaunch.engine.nearest import nearest

from .._bases import ReadOnly
from .._engine import running_process
from .._lazy import has_ros_paths
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .text_substitution import SubstitutionFailure, describe_all

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class AnonName(Substitution):
    """The name with host, process number and a random number added; the same one for the same name within one
    launch.

    The host is called `edulaunch` and the number comes from the simulation's seed, so that runs repeat.
    """

    def __init__(self, name: SomeSubstitutionsType) -> None:
        self.__name = normalize_to_list_of_substitutions(name)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name to make unique, as substitutions.')

    def describe(self) -> str:
        """`AnonName('name')`."""
        return f'AnonName({describe_all(self.__name)})'

    def perform(self, context: LaunchContext) -> str:
        """The unique name."""
        name = perform_substitutions(context, self.__name)
        key = 'anon' + name
        if key not in context.launch_configurations:
            process = running_process()
            number = process.sim.random(key).randrange(2**63)
            unique = f'{name}_edulaunch_{process.pid}_{number}'
            context.launch_configurations[key] = unique.replace('.', '_').replace('-', '_').replace(':', '_')
        unique_name: str = context.launch_configurations[key]
        return unique_name


class EnvironmentVariable(Substitution):
    """The value of an environment variable of launch's process at the moment of use.

    :raises SubstitutionFailure: on evaluation, when it is not set and has no default.
    """

    def __init__(self, name: SomeSubstitutionsType, *, default_value: SomeSubstitutionsType | None = None) -> None:
        self.__name = normalize_to_list_of_substitutions(name)
        self.__default_value = None if default_value is None else normalize_to_list_of_substitutions(default_value)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')
    default_value: ReadOnly[list[Substitution] | None] = ReadOnly('The default, as substitutions, or None.')

    def describe(self) -> str:
        """`EnvVar('NAME')`."""
        return f'EnvVar({describe_all(self.__name)})'

    def perform(self, context: LaunchContext) -> str:
        """The value of the variable, else the default."""
        name = perform_substitutions(context, self.__name)
        value = context.environment.get(name)
        if value is not None:
            return value
        if self.__default_value is None:
            error = SubstitutionFailure(f"environment variable '{name}' does not exist")
            raise with_facts(error, 'launch.no-variable', near=nearest(name, context.environment))
        return perform_substitutions(context, self.__default_value)


class LaunchConfiguration(Substitution):
    """The text of a launch configuration (a launch argument is one) at the moment of use.

    :param default: used when it is not set: a text, substitutions, or any scalar, which is converted with
        `str`.
    :raises SubstitutionFailure: on evaluation, when it is not set and has no default.
    """

    def __init__(self, variable_name: SomeSubstitutionsType, *, default: Any = None) -> None:
        self.__variable_name = normalize_to_list_of_substitutions(variable_name)
        self.__default: list[Substitution] | None = None if default is None else _normalize_default(default)

    variable_name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')

    def describe(self) -> str:
        """`LaunchConfig('name')`."""
        return f'LaunchConfig({describe_all(self.__variable_name)})'

    def perform(self, context: LaunchContext) -> str:
        """The value of the launch configuration, else the default."""
        name = perform_substitutions(context, self.__variable_name)
        names_read = getattr(context, '_names_read', None)  # not there in contexts that unit tests make for themselves
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
    near = nearest(name, configurations)
    declared = any(argument.name == name for argument in running_process().state.get('launch.declared', ()))
    scoped = name if near is None and declared else None
    return {'about': 'launch.no-configuration', 'configuration': name, 'near': near, 'scoped': scoped}


def _normalize_default(default: Any) -> list[Substitution]:
    single = isinstance(default, (str, Substitution)) or not isinstance(default, collections.abc.Iterable)
    items: Iterable[Any] = (default,) if single else default
    return normalize_to_list_of_substitutions([item if isinstance(item, (str, Substitution)) else str(item) for item in items])


class LocalSubstitution(Substitution):
    """`context.locals.<expression>`; mostly `event.<something>` inside an event handler.

    :param expression: a name, and what may follow it in Python: `.attribute`, `['key']`.
    :param description: for people, instead of the expression.
    :raises AttributeError: on evaluation, when there is no such local.
    """

    def __init__(self, expression: str, description: str | None = None) -> None:
        self.__expression = expression
        self.__description = description

    expression: ReadOnly[str] = ReadOnly('The Python expression behind `context.locals.`.')

    def describe(self) -> str:
        """`LocalVar('event.reason')`."""
        return f"LocalVar('{self.__expression if self.__description is None else self.__description}')"

    def perform(self, context: LaunchContext) -> str:
        """The value, which need not be a text."""
        value: str = eval(_compiled(self.__expression), {}, {'context': context})
        return value


@lru_cache(maxsize=256)
def _compiled(expression: str) -> CodeType:
    return compile('context.locals.' + expression, '<string>', 'eval')


has_ros_paths(__name__)

"""The class `ComposableNode`."""

from __future__ import annotations

from typing import Any

from launch._bases import ReadOnly
from launch.condition import Condition
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions

from ..parameters_type import Parameters, SomeParameters
from ..remap_rule_type import RemapRules, SomeRemapRules
from ..utilities.normalize_parameters import normalize_parameters
from ..utilities.normalize_remap_rule import normalize_remap_rules


class ComposableNode:
    """A node to load, with its plugin, name, parameters and remappings.

    :param package: the package with the plugin.
    :param plugin: the class name of the plugin, such as 'composition::Talker'.
    :param extra_arguments: arguments for the container, in the form of parameters (`use_intra_process_comms`).
    :param condition: the condition for loading the node. By default, the node is always loaded.
    """

    def __init__(
        self,
        *,
        package: SomeSubstitutionsType,
        plugin: SomeSubstitutionsType,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        parameters: SomeParameters | None = None,
        remappings: SomeRemapRules | None = None,
        extra_arguments: SomeParameters | None = None,
        condition: Condition | None = None,
    ) -> None:
        self.__package = normalize_to_list_of_substitutions(package)
        self.__node_plugin = normalize_to_list_of_substitutions(plugin)
        self.__node_name = None if name is None else normalize_to_list_of_substitutions(name)
        self.__node_namespace = None if namespace is None else normalize_to_list_of_substitutions(namespace)
        self.__parameters = None if not parameters else normalize_parameters(parameters)
        self.__remappings = None if not remappings else list(normalize_remap_rules(remappings))
        self.__extra_arguments = None if not extra_arguments else normalize_parameters(extra_arguments)
        self.__condition = condition

    package: ReadOnly[list[Substitution]] = ReadOnly('The package, as substitutions.')
    node_plugin: ReadOnly[list[Substitution]] = ReadOnly('The class name of the plugin, as substitutions.')
    node_name: ReadOnly[list[Substitution] | None] = ReadOnly("The node's name, or None for the plugin's own.")
    node_namespace: ReadOnly[list[Substitution] | None] = ReadOnly("The node's namespace, or None.")
    parameters: ReadOnly[Parameters | None] = ReadOnly('Normalized parameters, or None.')
    remappings: ReadOnly[RemapRules | None] = ReadOnly('Normalized remap rules, or None.')
    extra_arguments: ReadOnly[Any | None] = ReadOnly('Normalized arguments for the container, or None.')

    def condition(self) -> Condition | None:
        """Return the condition, or None without a condition. As in upstream, this is a method."""
        return self.__condition

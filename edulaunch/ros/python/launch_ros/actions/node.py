"""The action `Node`, which starts a node as an executable of a package."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

import launch.logging
from launch._bases import ReadOnly
from launch._engine import process_counter, process_state
from launch.actions.execute_process import ExecuteProcess
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions, plain_text
from launch.utilities.type_utils import ensure_argument_type

from .._node_words import NODE_NAME, NODE_NAMESPACE, validated_name, validated_namespace
from .._parameter_arguments import NO_NAMESPACE, ParameterArguments
from ..parameters_type import SomeParameters
from ..remap_rule_type import SomeRemapRules
from ..substitutions.executable_in_package import ExecutableInPackage
from ..utilities.namespace_utils import make_namespace_absolute, prefix_namespace
from ..utilities.normalize_parameters import normalize_parameters
from ..utilities.normalize_remap_rule import normalize_remap_rules
from ..utilities.track_node_names import add_node_name
from ._node_extensions import NodeActionExtension, get_extensions, instantiate_extension

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext
    from launch.launch_description_entity import LaunchDescriptionEntity

    from .._parameter_origins import Given

__all__ = ['Node', 'NodeActionExtension', 'get_extensions', 'instantiate_extension']

Words = list[str | Substitution]


class Node(ExecuteProcess):
    """Start a node.

    :param executable: the name of the executable in `package`. Without a package, it is a command.
    :param package: the package that contains the executable.
    :param name: the node's name. The default is the name in the program.
    :param namespace: the node's namespace, relative to the current pushed namespace.
    :param exec_name: the name of the process in the log.
    :param parameters: a list of parameter files, dicts, and :class:`~launch_ros.parameter_descriptions.Parameter`.
    :param remappings: (from, to) pairs for topics and services.
    :param ros_arguments: further arguments after `--ros-args`.
    :param arguments: the program's own arguments.
    :param kwargs: the arguments of :class:`launch.actions.ExecuteProcess`, except `cmd`.
    :raises TypeError: when `parameters` or `remappings` have the wrong type.

    Executing the action can raise PackageNotFoundError, SubstitutionFailure (no such executable), and rclpy's
    InvalidNodeNameException and InvalidNamespaceException.
    """

    UNSPECIFIED_NODE_NAME = '<node_name_unspecified>'
    UNSPECIFIED_NODE_NAMESPACE = NO_NAMESPACE

    def __init__(
        self,
        *,
        executable: SomeSubstitutionsType,
        package: SomeSubstitutionsType | None = None,
        name: SomeSubstitutionsType | None = None,
        namespace: SomeSubstitutionsType | None = None,
        exec_name: SomeSubstitutionsType | None = None,
        parameters: SomeParameters | None = None,
        remappings: SomeRemapRules | None = None,
        ros_arguments: Iterable[SomeSubstitutionsType] | None = None,
        arguments: Iterable[SomeSubstitutionsType] | None = None,
        **kwargs: Any,
    ) -> None:
        command: Any = executable if package is None else ExecutableInPackage(package=package, executable=executable)
        cmd = [command, *(arguments or ())]
        if ros_arguments is not None:
            cmd += ['--ros-args', *ros_arguments]
        cmd.append('--ros-args')
        if name is not None:
            cmd += ['-r', NODE_NAME]
        if parameters is not None and not isinstance(parameters, list):
            ensure_argument_type(parameters, (list,), 'parameters', 'Node')
        self.__parameters = None if parameters is None else normalize_parameters(parameters)
        self.__remappings = [] if remappings is None else list(normalize_remap_rules(remappings))
        super().__init__(cmd=cmd, name=exec_name, **kwargs)
        self.__package = package
        self.__node_executable = executable
        self.__node_name = name
        self.__node_namespace = namespace
        self.__arguments = arguments
        self.__expanded_remappings: list[tuple[str, str]] = []

    __expanded_node_name = UNSPECIFIED_NODE_NAME
    __expanded_node_namespace = UNSPECIFIED_NODE_NAMESPACE
    __final_node_name: str | None = None
    __substitutions_performed = False
    __parameter_arguments: ParameterArguments | None = None
    __package_and_executable: tuple[str | None, str | None] = None, None

    @property
    def __expanded_parameter_arguments(self) -> list[tuple[str, bool]] | None:
        """The parameter arguments after execution, in order: (path, True) and (`name:=value`, False). The files exist."""
        arguments = self.__parameter_arguments
        if arguments is None or not (arguments.items or self.__parameters is not None):
            return None
        arguments.write_files()
        return arguments.items

    node_package: ReadOnly[SomeSubstitutionsType | None] = ReadOnly('The package, as given.', '__package')

    node_executable: ReadOnly[SomeSubstitutionsType] = ReadOnly('The executable, as given.')

    @property
    def node_name(self) -> str:
        """The full name of the node. The UNSPECIFIED strings replace parts that the launch file does not set.

        :raises RuntimeError: before the action was executed.
        """
        if self.__final_node_name is None:
            raise RuntimeError("cannot access 'node_name' before executing action")
        return self.__final_node_name

    expanded_node_namespace: ReadOnly[str] = ReadOnly('The namespace, after execution.')

    @property
    def expanded_remapping_rules(self) -> list[tuple[str, str]]:
        """All (from, to) pairs after execution. Global rules come first."""
        return self.__expanded_remappings

    def is_node_name_fully_specified(self) -> bool:
        """Return whether the launch file sets both the name and the namespace."""
        name = self.node_name
        return self.UNSPECIFIED_NODE_NAME not in name and self.UNSPECIFIED_NODE_NAMESPACE not in name

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity] | None:
        """Resolve names, parameters and remappings, and schedule the process."""
        self._perform_substitutions(context)
        context.extend_locals({'ros_specific_arguments': self.__prepared_by_extensions(context)})
        self.__package_and_executable = _text(context, self.__package), _text(context, self.__node_executable)
        result = super().execute(context)
        if self.is_node_name_fully_specified():
            count = add_node_name(context, self.node_name)
            if count > 1:
                launch.logging.get_logger(self.process_description.final_name).warning(
                    f'there are now at least {count} nodes with the name {self.node_name} created within this launch context'
                )
        return result

    def __prepared_by_extensions(self, context: LaunchContext) -> dict[str, Any]:
        """Return the local variable for command lines, after the installed extensions have changed it."""
        arguments = {'name': f'__node:={self.__expanded_node_name}', 'ns': f'__ns:={self.__expanded_node_namespace}'}
        for extension in process_state('launch_ros.node_extensions', _load_extensions).values():
            words, arguments = extension.prepare_for_execute(context, arguments, self)
            self.process_description.add_words(words)
        return arguments

    def missing_parameter_files(self) -> list[str]:
        """Return the given parameter files that do not exist. Call this method after execution."""
        arguments = self.__parameter_arguments
        return [] if arguments is None else arguments.missing_files

    def given_parameters(self) -> list[Given]:
        """Return all values that are given for the node's parameters, in rcl's order. A later value replaces an earlier
        value.
        """
        arguments = self.__parameter_arguments
        return [] if arguments is None else arguments.in_force(self.origin)

    def process_spec_details(self) -> dict[str, Any]:
        """Return the facts that checks need: the package, the executable, and the places of the parameter values."""
        assert self.__parameter_arguments is not None
        package, executable = self.__package_and_executable
        return {
            'package': package,
            'executable': executable,
            'parameter_origins': self.__parameter_arguments.origins(self.origin),
        }

    def _perform_substitutions(self, context: LaunchContext) -> None:
        """Complete the command line. :meth:`execute` evaluates the parts that belong to the process."""
        if self.__substitutions_performed:
            return
        self.__substitutions_performed = True
        words: Words = []
        try:
            self.__expand_name(context, words)
        except Exception:
            launch.logging.get_logger('launch_ros.actions.node').error(
                'Error while expanding or validating node name or namespace for '
                f"'package={self.__package}, executable={self.__node_executable}, name={self.__node_name}, "
                f"namespace={self.__node_namespace}':"
            )
            raise
        namespace = '' if self.__expanded_node_namespace == '/' else self.__expanded_node_namespace
        self.__final_node_name = f'{namespace}/{self.__expanded_node_name}'
        self.__expand_parameters(context, words)
        self.__expand_remappings(context, words)
        self.process_description.add_words(words)

    def __expand_name(self, context: LaunchContext, words: Words) -> None:
        name = _text(context, self.__node_name)
        if name is not None:
            self.__expanded_node_name = validated_name(name)
        namespace = make_namespace_absolute(
            prefix_namespace(context.launch_configurations.get('ros_namespace'), _text(context, self.__node_namespace))
        )
        if namespace is not None:
            self.__expanded_node_namespace = namespace
            validated_namespace(namespace)
            words += ('-r', NODE_NAMESPACE)

    def __expand_parameters(self, context: LaunchContext, words: Words) -> None:
        """Return the evaluated parameters. Global parameters come first, so that the node's own parameters replace them."""
        name = self.node_name
        node_key = name if self.is_node_name_fully_specified() else '/**'
        arguments = self.__parameter_arguments = ParameterArguments(process_counter(context)[0], name, node_key)
        for_all = context.launch_configurations.get('global_params')
        if for_all:
            arguments.add_global(for_all)
        if self.__parameters:
            arguments.add_own(context, self.__parameters)
        if arguments.items:
            self.process_description.write_before_look(arguments.write_files)
            for text, is_file in arguments.items:
                words += ('--params-file' if is_file else '-p', text)

    def __expand_remappings(self, context: LaunchContext, words: Words) -> None:
        rules = self.__expanded_remappings = list(context.launch_configurations.get('ros_remaps', ()))
        for source, target in self.__remappings:
            rules.append((perform_substitutions(context, source), perform_substitutions(context, target)))
        for source_name, target_name in rules:
            words += ('-r', f'{source_name}:={target_name}')


def _load_extensions() -> dict[str, NodeActionExtension]:
    return get_extensions(launch.logging.get_logger('launch_ros.actions.node'))


def _text(context: LaunchContext, value: SomeSubstitutionsType | None) -> str | None:
    if value is None or type(value) is str:
        return value
    text = plain_text(value)
    if text is not None:
        return text
    return perform_substitutions(context, normalize_to_list_of_substitutions(value))

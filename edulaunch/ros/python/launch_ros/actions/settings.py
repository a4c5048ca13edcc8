"""Settings for the nodes that follow."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly
from launch._lazy import has_ros_paths
from launch.action import Action
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from launch.utilities.type_utils import normalize_typed_substitution, perform_typed_substitution

from edulaunch.engine.graph.names import namespace_problem

from .._parameter_origins import GlobalParameter
from ..ros_adapters import get_ros_node
from ..utilities.names import make_namespace_absolute, prefix_namespace
from ..utilities.parameters import evaluate_parameter_dict, normalize_parameter_dict

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class PushROSNamespace(Action):
    """Put the nodes that follow into a namespace, inside the one pushed before; a GroupAction ends it.

    :raises SubstitutionFailure: on execution, when the result is not a namespace.
    """

    def __init__(self, namespace: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__namespace = normalize_to_list_of_substitutions(namespace)

    namespace: ReadOnly[list[Substitution]] = ReadOnly('The namespace, to be evaluated.')

    def execute(self, context: LaunchContext) -> None:
        """Set the launch configuration `ros_namespace`."""
        pushed = perform_substitutions(context, self.namespace)
        previous = context.launch_configurations.get('ros_namespace')
        namespace = make_namespace_absolute(prefix_namespace(previous, pushed))
        if namespace is None or namespace_problem(namespace) is not None:
            from launch.substitutions.text_substitution import SubstitutionFailure

            raise SubstitutionFailure(
                f"The resulting namespace is invalid: [previous_namespace='{previous}', pushed_namespace='{pushed}']"
            )
        context.launch_configurations['ros_namespace'] = namespace


PushRosNamespace = PushROSNamespace


class SetParameter(Action):
    """Give a parameter to every node that is started later in this scope; a node's own parameters come after
    it.

    As in ROS, a list of values is passed on in a form that the node reads as a text.
    """

    def __init__(self, name: SomeSubstitutionsType, value: Any, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__param_dict = normalize_parameter_dict({name if isinstance(name, (str, Substitution)) else tuple(name): value})

    @property
    def name(self) -> list[Substitution]:
        """The parameter's name, to be evaluated."""
        return list(next(iter(self.__param_dict)))

    @property
    def value(self) -> Any:
        """The value, to be evaluated."""
        return next(iter(self.__param_dict.values()))

    def execute(self, context: LaunchContext) -> None:
        """Add it to the launch configuration `global_params`."""
        evaluated = evaluate_parameter_dict(context, self.__param_dict)
        for value in evaluated.values():
            added = GlobalParameter((perform_substitutions(context, self.name), value))
            added.origin = self.origin
            context.launch_configurations.setdefault('global_params', []).append(added)


class SetParametersFromFile(Action):
    """Give a parameter file to every node that is started later in this scope.

    :raises AssertionError: when such a node is executed and the path is not a file, as upstream.
    """

    def __init__(self, filename: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__filename = normalize_to_list_of_substitutions(filename)

    filename: ReadOnly[list[Substitution]] = ReadOnly('The path, to be evaluated.')

    def execute(self, context: LaunchContext) -> None:
        """Add it to the launch configuration `global_params`."""
        path = perform_substitutions(context, self.__filename)
        context.launch_configurations.setdefault('global_params', []).append(path)


class SetRemap(Action):
    """Remap `src` to `dst` in the nodes that are started later in this scope, before their own rules."""

    def __init__(self, src: SomeSubstitutionsType, dst: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__src = normalize_to_list_of_substitutions(src)
        self.__dst = normalize_to_list_of_substitutions(dst)

    src: ReadOnly[list[Substitution]] = ReadOnly('The name to replace, to be evaluated.')
    dst: ReadOnly[list[Substitution]] = ReadOnly('The new name, to be evaluated.')

    def execute(self, context: LaunchContext) -> None:
        """Add it to the launch configuration `ros_remaps`."""
        rule = (perform_substitutions(context, self.src), perform_substitutions(context, self.dst))
        context.launch_configurations.setdefault('ros_remaps', []).append(rule)


class SetROSLogDir(Action):
    """Set ROS_LOG_DIR for the nodes that follow in the same scope; a relative one goes below the current."""

    def __init__(self, new_log_dir: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__log_dir = normalize_to_list_of_substitutions(new_log_dir)

    log_dir: ReadOnly[list[Substitution]] = ReadOnly('The folder, to be evaluated.')

    def execute(self, context: LaunchContext) -> None:
        """Set the environment variable."""
        folder = perform_substitutions(context, self.__log_dir)
        if not os.path.isabs(folder):
            folder = os.path.join(context.environment.get('ROS_LOG_DIR') or _launch_log_dir(context), folder)
        context.environment['ROS_LOG_DIR'] = folder


def _launch_log_dir(context: LaunchContext) -> str:
    from launch.substitutions.paths import LaunchLogDir

    return LaunchLogDir().perform(context)


class SetUseSimTime(Action):
    """Set `use_sim_time` of launch's own node, on whose clock ROSTimer runs.

    :param value: a bool, or a text or substitutions for one.
    """

    def __init__(self, value: Any, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__value = normalize_typed_substitution(value, bool)

    value: ReadOnly[Any] = ReadOnly('The value, to be evaluated.')

    def execute(self, context: LaunchContext) -> None:
        """Set the parameter."""
        from rclpy.parameter import Parameter

        value = perform_typed_substitution(context, self.__value, bool)
        get_ros_node(context).set_parameters([Parameter('use_sim_time', Parameter.Type.BOOL, value)])


has_ros_paths(__name__)

"""`PushROSNamespace` and `PushRosNamespace`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly
from launch.action import Action
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

from edulaunch.engine.graph.names import namespace_problem

from ..utilities.namespace_utils import make_namespace_absolute, prefix_namespace

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class PushROSNamespace(Action):
    """Put later nodes into a namespace, inside the namespace that was pushed before. The end of a GroupAction restores the
    previous namespace.

    :raises SubstitutionFailure: on execution, when the result is not a valid namespace.
    """

    def __init__(self, namespace: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__namespace = normalize_to_list_of_substitutions(namespace)

    namespace: ReadOnly[list[Substitution]] = ReadOnly('The namespace, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Set the launch configuration `ros_namespace`."""
        pushed = perform_substitutions(context, self.namespace)
        previous = context.launch_configurations.get('ros_namespace')
        namespace = make_namespace_absolute(prefix_namespace(previous, pushed))
        if namespace is None or namespace_problem(namespace) is not None:
            from launch.substitutions.substitution_failure import SubstitutionFailure

            raise SubstitutionFailure(
                f"The resulting namespace is invalid: [previous_namespace='{previous}', pushed_namespace='{pushed}']"
            )
        context.launch_configurations['ros_namespace'] = namespace


PushRosNamespace = PushROSNamespace

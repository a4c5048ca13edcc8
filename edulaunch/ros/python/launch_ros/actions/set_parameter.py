"""The action `SetParameter`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch.action import Action
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.utilities.texts import perform_substitutions

from .._parameter_origins import GlobalParameter
from ..utilities.evaluate_parameters import evaluate_parameter_dict
from ..utilities.normalize_parameters import normalize_parameter_dict

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class SetParameter(Action):
    """Set a parameter for every node that starts later in this scope. The node's own parameters override this value.

    As in ROS, a list of values is passed on in a form that the node reads as a string.
    """

    def __init__(self, name: SomeSubstitutionsType, value: Any, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__param_dict = normalize_parameter_dict({name if isinstance(name, (str, Substitution)) else tuple(name): value})

    @property
    def name(self) -> list[Substitution]:
        """The name of the parameter before evaluation."""
        return list(next(iter(self.__param_dict)))

    @property
    def value(self) -> Any:
        """The value of the parameter; it may contain substitutions."""
        return next(iter(self.__param_dict.values()))

    def execute(self, context: LaunchContext) -> None:
        """Add the parameter to the launch configuration `global_params`."""
        evaluated = evaluate_parameter_dict(context, self.__param_dict)
        for value in evaluated.values():
            added = GlobalParameter((perform_substitutions(context, self.name), value))
            added.origin = self.origin
            context.launch_configurations.setdefault('global_params', []).append(added)

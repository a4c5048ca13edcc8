"""The action `SetRemap`."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any

from launch._bases import ReadOnly
from launch.action import Action
from launch.substitution import SomeSubstitutionsType, Substitution
from launch.utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from launch.launch_context import LaunchContext


class SetRemap(Action):
    """Remap `src` to `dst` in nodes that start later in this scope. This rule has priority over the nodes' own rules."""

    def __init__(self, src: SomeSubstitutionsType, dst: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__src = normalize_to_list_of_substitutions(src)
        self.__dst = normalize_to_list_of_substitutions(dst)

    src: ReadOnly[list[Substitution]] = ReadOnly('The name to replace, as substitutions.')
    dst: ReadOnly[list[Substitution]] = ReadOnly('The new name, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Add the rule to the launch configuration `ros_remaps`."""
        rule = (perform_substitutions(context, self.src), perform_substitutions(context, self.dst))
        context.launch_configurations.setdefault('ros_remaps', []).append(rule)

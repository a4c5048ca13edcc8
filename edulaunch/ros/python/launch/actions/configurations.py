"""Actions on launch configurations."""

from __future__ import annotations

from collections.abc import Mapping
from typing import TYPE_CHECKING, Any, ClassVar

from .._bases import ReadOnly
from .._lazy import has_ros_paths
from ..action import Action
from ..substitution import SomeSubstitutionsType, Substitution
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class SetLaunchConfiguration(Action):
    """Set a launch configuration, whether it is set already or not (so it also overrides `name:=value` of a
    user).

    :param name, value: texts or substitutions.
    """

    def __init__(self, name: SomeSubstitutionsType, value: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)
        self.__value = normalize_to_list_of_substitutions(value)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')
    value: ReadOnly[list[Substitution]] = ReadOnly('The value, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Set it."""
        name = perform_substitutions(context, self.__name)
        context.launch_configurations[name] = perform_substitutions(context, self.__value)


class UnsetLaunchConfiguration(Action):
    """Forget a launch configuration; nothing happens when there is none of that name."""

    def __init__(self, name: SomeSubstitutionsType, **kwargs: Any) -> None:
        super().__init__(**kwargs)
        self.__name = normalize_to_list_of_substitutions(name)

    name: ReadOnly[list[Substitution]] = ReadOnly('The name, as substitutions.')

    def execute(self, context: LaunchContext) -> None:
        """Forget it."""
        context.launch_configurations.pop(perform_substitutions(context, self.__name), None)


class PushLaunchConfigurations(Action):
    """Save all launch configurations until the matching `PopLaunchConfigurations`."""

    def execute(self, context: LaunchContext) -> None:
        """Keep what there is now, for a later PopLaunchConfigurations."""
        context._push_launch_configurations()


class PopLaunchConfigurations(Action):
    """Restore the launch configurations saved by the last `PushLaunchConfigurations`."""

    def execute(self, context: LaunchContext) -> None:
        """Set the configurations to what they were at the last push; RuntimeError when there was none."""
        context._pop_launch_configurations()


class ResetLaunchConfigurations(Action):
    """Forget all launch configurations, then set the given ones.

    :param launch_configurations: name -> value, both texts or substitutions; evaluated before anything is
        forgotten.
    """

    _search_role: ClassVar[str] = 'reset'

    def __init__(
        self, launch_configurations: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None, **kwargs: Any
    ) -> None:
        super().__init__(**kwargs)
        self.__launch_configurations = dict(launch_configurations) if launch_configurations is not None else {}

    launch_configurations: ReadOnly[dict[SomeSubstitutionsType, SomeSubstitutionsType]] = ReadOnly(
        'The ones that are set afterwards.'
    )

    def execute(self, context: LaunchContext) -> None:
        """Forget, then set."""
        kept = {
            perform_substitutions(context, normalize_to_list_of_substitutions(name)): perform_substitutions(
                context, normalize_to_list_of_substitutions(value)
            )
            for name, value in self.__launch_configurations.items()
        }
        context.launch_configurations.clear()
        context.launch_configurations.update(kept)


has_ros_paths(__name__)

"""The action `GroupAction`."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import TYPE_CHECKING, Any

from ..action import Action
from ..launch_description_entity import LaunchDescriptionEntity
from ..substitution import SomeSubstitutionsType
from .pop_environment import PopEnvironment
from .pop_launch_configurations import PopLaunchConfigurations
from .push_environment import PushEnvironment
from .push_launch_configurations import PushLaunchConfigurations
from .reset_environment import ResetEnvironment
from .reset_launch_configurations import ResetLaunchConfigurations
from .set_launch_configuration import SetLaunchConfiguration

if TYPE_CHECKING:
    from ..launch_context import LaunchContext


class GroupAction(Action):
    """Visit several actions together, with one condition for all.

    :param scoped: whether the end of the group restores the environment variables and the launch configurations, which include
        the pushed namespace.
    :param forwarding: whether the actions can read the configurations and variables set outside the group. Otherwise, the
        actions can read only `launch_configurations`.
    :param launch_configurations: the configurations to set at the beginning.
    """

    def __init__(
        self,
        actions: Iterable[LaunchDescriptionEntity],
        *,
        scoped: bool = True,
        forwarding: bool = True,
        launch_configurations: Mapping[SomeSubstitutionsType, SomeSubstitutionsType] | None = None,
        **left_over_kwargs: Any,
    ) -> None:
        super().__init__(**left_over_kwargs)
        self.__actions = actions
        self.__scoped = scoped
        self.__forwarding = forwarding
        self.__launch_configurations = dict(launch_configurations) if launch_configurations is not None else {}
        self.__actions_to_return: list[LaunchDescriptionEntity] | None = None

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the actions of the group. If the group is scoped, they are between the actions that create and end the scope."""
        if self.__actions_to_return is None:
            self.__actions_to_return = self.__with_scope(list(self.__actions))
        return self.__actions_to_return

    def __with_scope(self, actions: list[LaunchDescriptionEntity]) -> list[LaunchDescriptionEntity]:
        sets = [SetLaunchConfiguration(name, value) for name, value in self.__launch_configurations.items()]
        if not self.__scoped:
            return [*sets, *actions]
        if self.__forwarding:
            begin: list[LaunchDescriptionEntity] = [PushLaunchConfigurations(), PushEnvironment(), *sets]
        else:
            begin = [
                PushLaunchConfigurations(),
                PushEnvironment(),
                ResetEnvironment(),
                ResetLaunchConfigurations(self.__launch_configurations),
            ]
        return [*begin, *actions, PopEnvironment(), PopLaunchConfigurations()]

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Return the actions of the group."""
        return self.get_sub_entities()

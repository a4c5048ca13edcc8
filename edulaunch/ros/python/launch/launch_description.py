"""The list of entities that a launch file returns."""

from __future__ import annotations

from collections.abc import Iterable
from typing import TYPE_CHECKING, Any

from ._argument_search import FoundArguments, found_arguments
from ._bases import ReadOnly
from .launch_description_entity import LaunchDescriptionEntity

if TYPE_CHECKING:
    from .action import Action
    from .actions.declare_launch_argument import DeclareLaunchArgument
    from .launch_context import LaunchContext


def __getattr__(name: str) -> Any:
    """Return a class that upstream's module imports, because launch files also import the class from this module."""
    if name not in ('Action', 'DeclareLaunchArgument', 'LaunchContext'):
        raise AttributeError(f'module {__name__!r} has no attribute {name!r}')
    from .action import Action
    from .actions.declare_launch_argument import DeclareLaunchArgument
    from .launch_context import LaunchContext

    return {'Action': Action, 'DeclareLaunchArgument': DeclareLaunchArgument, 'LaunchContext': LaunchContext}[name]


class LaunchDescription(LaunchDescriptionEntity):
    """The content of a launch file. Visiting a description visits its entities in order.

    :param initial_entities: actions and other entities. More can be added later.
    :param deprecated_reason: the reason why the description is deprecated. If given, a visit logs a warning.
    """

    def __init__(
        self, initial_entities: Iterable[LaunchDescriptionEntity] | None = None, *, deprecated_reason: str | None = None
    ) -> None:
        self.__entities = list(initial_entities) if initial_entities is not None else []
        self.__deprecated_reason = deprecated_reason

    entities: ReadOnly[list[LaunchDescriptionEntity]] = ReadOnly('The list of entities, which can be changed.')

    @property
    def deprecated(self) -> bool:
        """Whether the description is deprecated."""
        return self.__deprecated_reason is not None

    deprecated_reason: ReadOnly[str | None] = ReadOnly('The reason why the description is deprecated, or None.')

    def add_entity(self, entity: LaunchDescriptionEntity) -> None:
        """Append an entity."""
        self.__entities.append(entity)

    def add_action(self, action: Action) -> None:
        """Append an action."""
        self.add_entity(action)

    def describe(self) -> str:
        """Return Python's `repr`, which plans and error messages show."""
        return repr(self)

    def describe_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the entities."""
        return self.__entities

    def visit(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Return the entities. A deprecated description logs a warning first."""
        if self.__deprecated_reason is not None:
            from .logging import get_logger

            here = context.get_locals_as_dict().get('current_launch_file_path')
            what = 'deprecated launch description' if here is None else f'launch file [{here}] is deprecated'
            get_logger().warning(f'{what}: {self.__deprecated_reason}')
        return self.__entities

    def get_launch_arguments(self, conditional_inclusion: bool = False) -> list[DeclareLaunchArgument]:
        """Return the launch arguments declared here and in included files, as far as they can be found without launching.

        :param conditional_inclusion: whether this description itself is included only under a condition.
        """
        found = self.get_launch_arguments_with_include_launch_description_actions(conditional_inclusion)
        return [argument for argument, _ in found]

    def get_launch_arguments_with_include_launch_description_actions(self, conditional_inclusion: bool = False) -> FoundArguments:
        """Return the arguments of :meth:`get_launch_arguments`, each with the include actions that lead to it (or None).

        If a name is declared more than once, the first declaration counts. Files are skipped if their path is not known before
        launching, or if they cannot be loaded. Arguments after a `ResetLaunchConfigurations` or inside an `OpaqueFunction` are
        not found.
        """
        return found_arguments(self.__entities, conditional_inclusion)

"""The action `IncludeLaunchDescription`."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING, Any, ClassVar

from edulaunch.engine.underlay_place import is_students

from .._absent_packages import is_left_out
from .._bases import ReadOnly
from .._engine import inside
from .._include_ring import Include, enter_include
from .._run_notes import note_declared, note_include, note_undeclared, tell_wrong_return
from ..action import Action
from ..launch_context import LaunchContext
from ..launch_description_entity import LaunchDescriptionEntity
from ..launch_description_source import LaunchDescriptionSource
from ..launch_description_sources.any_launch_description_source import AnyLaunchDescriptionSource
from ..substitution import SomeSubstitutionsType
from ..utilities.texts import normalize_to_list_of_substitutions, perform_substitutions
from .set_launch_configuration import SetLaunchConfiguration

if TYPE_CHECKING:
    from ..launch_context import LaunchContext
    from ..launch_description import LaunchDescription

LaunchArguments = Iterable[tuple[SomeSubstitutionsType, SomeSubstitutionsType]]


class IncludeLaunchDescription(Action):
    """Visit another launch description.

    An include has no scope of its own: later actions see its arguments and everything that it sets. Put the include into a
    `GroupAction` to prevent that.

    :param launch_description_source: a source, or the path of a launch file of any format.
    :param launch_arguments: (name, value) pairs, such as `{'name': 'value'}.items()`. They are set before the
        description is visited.
    """

    _search_role: ClassVar[str] = 'include'

    def __init__(
        self,
        launch_description_source: LaunchDescriptionSource | SomeSubstitutionsType,
        *,
        launch_arguments: LaunchArguments | None = None,
        **kwargs: Any,
    ) -> None:
        super().__init__(**kwargs)
        self.__source = (
            launch_description_source
            if isinstance(launch_description_source, LaunchDescriptionSource)
            else AnyLaunchDescriptionSource(launch_description_source)
        )
        self.__launch_arguments = () if launch_arguments is None else tuple(launch_arguments)

    launch_description_source: ReadOnly[LaunchDescriptionSource] = ReadOnly('The source of the description.', '__source')

    launch_arguments: ReadOnly[tuple[tuple[SomeSubstitutionsType, SomeSubstitutionsType], ...]] = ReadOnly(
        'The launch arguments as (name, value) pairs.'
    )

    def describe(self) -> str:
        """Return a description such as `IncludeLaunchDescription(/path/to/the.launch.py)`."""
        return f'IncludeLaunchDescription({self.__source.described_location})'

    def get_sub_entities(self) -> list[LaunchDescriptionEntity]:
        """Return the launch description, if its file can be found and loaded without a running launch."""
        description = self.__source.try_get_launch_description_without_context()
        return [description] if description is not None else []

    def _try_get_arguments_names_without_context(self) -> list[str]:
        """Return the names of the launch arguments, as far as they are known without a running launch."""
        try:
            return self.__argument_names(LaunchContext())
        except Exception:
            return []

    def __argument_names(self, context: LaunchContext) -> list[str]:
        return [perform_substitutions(context, normalize_to_list_of_substitutions(name)) for name, _ in self.__launch_arguments]

    def execute(self, context: LaunchContext) -> list[LaunchDescriptionEntity]:
        """Load the description, set its arguments, and visit it.

        If the file belongs to a missing well-known package, such as one of Gazebo, log an error and do not include it.

        :raises RuntimeError: when a launch argument has neither a value nor a default.
        """
        try:
            description = self.__source.get_launch_description(context)
        except Exception:
            if is_left_out(self.__source.described_location):
                return []
            raise
        location = os.path.abspath(inside(self.__source.location))
        note_include(location)
        # A description that a script creates has a location such as '<script>', which stays as it is.
        folder = os.path.dirname(location) if os.path.exists(location) else self.__source.location
        context.extend_locals({'current_launch_file_path': location, 'current_launch_file_directory': folder})
        try:
            self.__check_required_arguments(description, context)
        except AttributeError as error:
            if not hasattr(description, 'get_launch_arguments'):
                tell_wrong_return(error)
            raise
        sets = [SetLaunchConfiguration(name, value) for name, value in self.__launch_arguments]
        if type(self.__source) is not LaunchDescriptionSource:  # the base class has a description, but no file
            enter_include(context.open_includes, Include(location, self.origin, dict(context.launch_configurations)))
        return [*sets, description]

    def __check_required_arguments(self, description: LaunchDescription, context: LaunchContext) -> None:
        names = self.__argument_names(context)
        declared = description.get_launch_arguments_with_include_launch_description_actions()
        origin = self.origin if names else None
        if origin is not None and is_students(origin.file):
            note_undeclared(names, [argument.name for argument, _ in declared], self.__source.location, origin)
        for argument, includes in declared:
            note_declared(argument)
            if argument._conditionally_included or argument.default_value is not None:
                continue
            for include in includes or ():
                names.extend(include._try_get_arguments_names_without_context())
            if argument.name not in names:
                raise RuntimeError(
                    f"Included launch description missing required argument '{argument.name}' "
                    f"(description: '{argument.description}'), given: [{', '.join(names)}]"
                )

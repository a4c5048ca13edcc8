"""The base class for sources of launch descriptions."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ._argument_search import load_once
from ._bases import ReadOnly
from .launch_context import LaunchContext
from .substitution import SomeSubstitutionsType
from .substitutions.text_substitution import TextSubstitution
from .utilities.texts import normalize_to_list_of_substitutions, perform_substitutions

if TYPE_CHECKING:
    from .launch_description import LaunchDescription


class LaunchDescriptionSource:
    """A launch description, or a launch file from which to load it.

    :param launch_description: the description, if it is already known.
    :param location: path of the file, as strings or substitutions. A relative path starts at the working directory.
    :param method: a phrase that describes how the file is loaded.
    """

    def __init__(
        self,
        launch_description: LaunchDescription | None = None,
        location: SomeSubstitutionsType = '<string>',
        method: str = 'unspecified mechanism from a script',
    ) -> None:
        self.__launch_description = launch_description
        self.__location = normalize_to_list_of_substitutions(location)
        self.__method = method
        self.__expanded_location: str | None = None

    @property
    def location(self) -> str:
        """The path, or the `str` of its substitutions before the path is known."""
        if self.__expanded_location is None:
            return ' + '.join(str(part) for part in self.__location)
        return self.__expanded_location

    @property
    def described_location(self) -> str:
        """The path, or a readable form of its substitutions before the path is known. (edulaunch only.)"""
        if self.__expanded_location is None:
            return ' + '.join(part.describe() for part in self.__location)
        return self.__expanded_location

    method: ReadOnly[str] = ReadOnly('A phrase that describes how the file is loaded.')

    def get_launch_description(self, context: LaunchContext) -> LaunchDescription:
        """Return the description. The first call loads the file.

        :raises RuntimeError: when there is neither a description nor a way to load one.
        :raises Exception: any exception that is raised while the file is loaded.
        """
        if self.__expanded_location is None:
            self.__expanded_location = perform_substitutions(context, self.__location)
        if self.__launch_description is None:
            self.__launch_description = self._get_launch_description(self.__expanded_location)
        return self.__launch_description

    def try_get_launch_description_without_context(self) -> LaunchDescription | None:
        """Return the description if its path is known without a running launch and the file can be loaded. Otherwise, return
        None.

        As in upstream, this executes the file, but only once within one visit.
        """
        if self.__launch_description is not None:
            return self.__launch_description
        location = self.__static_location()
        return None if location is None else load_once(self, location, lambda: self._get_launch_description(location))

    def __static_location(self) -> str | None:
        """Return the path if it is known without a running launch."""
        parts = self.__location
        if len(parts) == 1 and type(parts[0]) is TextSubstitution:
            return parts[0].text
        try:
            return perform_substitutions(LaunchContext(), parts)
        except Exception:
            return None

    def _get_launch_description(self, location: str) -> LaunchDescription:
        """Load the file. Subclasses override this method.

        :raises RuntimeError: always in this base class.
        """
        raise RuntimeError(f"LaunchDescriptionSource: no launch description, and no way to load one from '{location}'")

"""The class `FrontendLaunchDescriptionSource`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..frontend.invalid_frontend_launch_file_error import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
from ..launch_description_source import LaunchDescriptionSource
from ..substitution import SomeSubstitutionsType
from .frontend_launch_file_utilities import get_launch_description_from_frontend_launch_file

if TYPE_CHECKING:
    from ..frontend.parser import Parser
    from ..launch_description import LaunchDescription


class FrontendLaunchDescriptionSource(LaunchDescriptionSource):
    """A launch file written in XML, YAML or another format.

    :param parser: the parser for the format. By default, all parsers are tried.
    """

    def __init__(
        self,
        launch_file_path: SomeSubstitutionsType,
        *,
        method: str = 'interpreted frontend launch file',
        parser: type[Parser] | None = None,
    ) -> None:
        super().__init__(None, launch_file_path, method)
        self.__parser = parser

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_frontend_launch_file(location, parser=self.__parser)

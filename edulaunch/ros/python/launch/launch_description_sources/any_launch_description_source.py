"""The class `AnyLaunchDescriptionSource`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..frontend.invalid_frontend_launch_file_error import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
from ..launch_description_source import LaunchDescriptionSource
from ..substitution import SomeSubstitutionsType
from .any_launch_file_utilities import get_launch_description_from_any_launch_file

if TYPE_CHECKING:
    from ..launch_description import LaunchDescription


class AnyLaunchDescriptionSource(LaunchDescriptionSource):
    """A launch file in any format. All loaders are tried, the most likely one first."""

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, 'interpreted launch file')

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_any_launch_file(location)

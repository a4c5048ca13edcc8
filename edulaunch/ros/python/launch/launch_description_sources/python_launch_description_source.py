"""The class `PythonLaunchDescriptionSource`."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..frontend.invalid_frontend_launch_file_error import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
from ..launch_description_source import LaunchDescriptionSource
from ..substitution import SomeSubstitutionsType
from .python_launch_file_utilities import get_launch_description_from_python_launch_file

if TYPE_CHECKING:
    from ..launch_description import LaunchDescription


class PythonLaunchDescriptionSource(LaunchDescriptionSource):
    """A launch file written in Python, with any file name. Errors in it are raised unchanged."""

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, 'interpreted python launch file')

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_python_launch_file(location)

"""Launch descriptions from XML files."""

from __future__ import annotations

from launch.launch_description_sources.frontend_launch_description_source import FrontendLaunchDescriptionSource
from launch.substitution import SomeSubstitutionsType

from .parser import Parser

__all__ = ['XMLLaunchDescriptionSource']


class XMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """The launch description in an XML file.

    :param launch_file_path: the path of the file. A relative path starts at the current directory.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(launch_file_path, method='interpreted XML launch file', parser=Parser)

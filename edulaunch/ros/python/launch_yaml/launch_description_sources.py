"""Launch descriptions from YAML files."""

from __future__ import annotations

from launch.launch_description_sources.frontend_launch_description_source import FrontendLaunchDescriptionSource
from launch.substitution import SomeSubstitutionsType

from .parser import Parser

__all__ = ['YAMLLaunchDescriptionSource']


class YAMLLaunchDescriptionSource(FrontendLaunchDescriptionSource):
    """The launch description in a YAML file.

    :param launch_file_path: the path of the file. A relative path starts at the current directory.
    """

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(launch_file_path, method='interpreted YAML launch file', parser=Parser)

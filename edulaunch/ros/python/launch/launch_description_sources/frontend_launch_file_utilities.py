"""A function that loads launch files of any frontend."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..frontend.invalid_frontend_launch_file_error import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError

if TYPE_CHECKING:
    from ..frontend.parser import Parser
    from ..launch_description import LaunchDescription


def get_launch_description_from_frontend_launch_file(
    frontend_launch_file_path: str, *, parser: type[Parser] | None = None
) -> LaunchDescription:
    """Return the launch description in the file.

    :param parser: the parser for the format of the file. By default, all parsers are tried, and those for the file's extension
        come first.
    :raises InvalidFrontendLaunchFileError: when no parser can read the file.
    """
    from ..frontend.parser import Parser

    root, found = (parser or Parser).load(frontend_launch_file_path)
    description: LaunchDescription = found.parse_description(root)
    return description

"""Loading launch files written in XML, YAML or any other format with a parser."""

from __future__ import annotations

from typing import TYPE_CHECKING

from ..frontend.invalid_frontend_launch_file_error import InvalidFrontendLaunchFileError
from ..frontend.parser import Parser

if TYPE_CHECKING:
    from ..launch_description import LaunchDescription

__all__ = ['InvalidFrontendLaunchFileError', 'get_launch_description_from_frontend_launch_file']


def get_launch_description_from_frontend_launch_file(
    frontend_launch_file_path: str, *, parser: type[Parser] | None = None
) -> LaunchDescription:
    """The description in the file.

    :param parser: of its format; without one all are tried, those first that know the file's extension.
    :raises InvalidFrontendLaunchFileError: when no parser can read it.
    """
    root, found = (Parser if parser is None else parser).load(frontend_launch_file_path)
    description: LaunchDescription = found.parse_description(root)
    return description

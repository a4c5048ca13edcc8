"""A function that loads launch files of any format."""

from __future__ import annotations

import os
from collections.abc import Callable
from typing import TYPE_CHECKING

from ..invalid_launch_file_error import InvalidLaunchFileError as InvalidLaunchFileError
from .frontend_launch_file_utilities import get_launch_description_from_frontend_launch_file
from .python_launch_file_utilities import get_launch_description_from_python_launch_file

if TYPE_CHECKING:
    from ..launch_description import LaunchDescription


def get_launch_description_from_any_launch_file(launch_file_path: str) -> LaunchDescription:
    """Return the launch description in the file. Python is tried first for `.py` files, and last for all other files.

    :raises InvalidLaunchFileError: when no loader can read the file. The message contains the message of each loader.
    """
    extension = os.path.splitext(launch_file_path)[1].lower().lstrip('.')
    loaders: list[Callable[[str], LaunchDescription]] = [
        get_launch_description_from_frontend_launch_file,
        get_launch_description_from_python_launch_file,
    ]
    if extension == 'py':
        loaders.reverse()
    errors: list[Exception] = []
    for load in loaders:
        try:
            return load(launch_file_path)
        except Exception as error:
            errors.append(error)
    raise InvalidLaunchFileError(extension, likely_errors=errors)

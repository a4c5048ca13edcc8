"""Loading launch files written in Python."""
from __future__ import annotations

from types import ModuleType
from typing import TYPE_CHECKING

from .._engine import load_module

if TYPE_CHECKING:
    from ..launch_description import LaunchDescription


class InvalidPythonLaunchFileError(Exception):
    """A Python launch file lacks `generate_launch_description()`."""


def load_python_launch_file_as_module(python_launch_file_path: str) -> ModuleType:
    """Execute the file as the module `python_launch_file`.

    The file's folder is not put on `sys.path`. `print`, `time`, `random` and the like are those of the
    running simulation.
    """
    return load_module(python_launch_file_path, 'python_launch_file')


def get_launch_description_from_python_launch_file(python_launch_file_path: str) -> LaunchDescription:
    """What the file's `generate_launch_description()` returns.

    :raises InvalidPythonLaunchFileError: when it has no such function.
    :raises Exception: whatever the file raises.
    """
    module = load_python_launch_file_as_module(python_launch_file_path)
    if not hasattr(module, 'generate_launch_description'):
        raise InvalidPythonLaunchFileError(
            f"launch file at '{python_launch_file_path}' does not contain the required function "
            "'generate_launch_description()'")
    description: LaunchDescription = module.generate_launch_description()
    return description

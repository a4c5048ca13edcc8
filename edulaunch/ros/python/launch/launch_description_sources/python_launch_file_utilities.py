"""Functions that load Python launch files."""

from __future__ import annotations

from types import FunctionType, ModuleType
from typing import TYPE_CHECKING, Any

from .._engine import load_module
from .._run_notes import note_wrong_return
from ..frontend.invalid_frontend_launch_file_error import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError

if TYPE_CHECKING:
    from ..launch_description import LaunchDescription


GENERATE = 'generate_launch_description'
TEST = 'generate_test_description'


class InvalidPythonLaunchFileError(Exception):
    """A Python launch file does not define `generate_launch_description()`."""


def load_python_launch_file_as_module(python_launch_file_path: str) -> ModuleType:
    """Execute the file as the module `python_launch_file`.

    The file's folder is not added to `sys.path`. The file uses the `print`, `time`, `random` and similar modules of the
    running simulation.
    """
    return load_module(python_launch_file_path, 'python_launch_file')


def get_launch_description_from_python_launch_file(python_launch_file_path: str) -> LaunchDescription:
    """Return the result of the file's `generate_launch_description()`.

    :raises InvalidPythonLaunchFileError: when the file does not define this function.
    :raises Exception: any exception that the file raises.
    """
    module = load_python_launch_file_as_module(python_launch_file_path)
    if not hasattr(module, GENERATE):
        raise _no_function(python_launch_file_path, module)
    description: LaunchDescription = module.generate_launch_description()
    if not hasattr(description, 'get_launch_arguments'):
        note_wrong_return(module.generate_launch_description)
    return description


def _no_function(path: str, module: ModuleType) -> InvalidPythonLaunchFileError:
    """Return the error for a missing function, with the line of a function with a similar name."""
    from edulaunch.engine.facts import with_facts
    from edulaunch.engine.nearest import nearest

    error: Any = InvalidPythonLaunchFileError(f"launch file at '{path}' does not contain the required function '{GENERATE}()'")
    functions = {name: value for name, value in vars(module).items() if isinstance(value, FunctionType)}
    near = TEST if TEST in functions else nearest(GENERATE, functions)
    if near is not None:
        code = functions[near].__code__
        error.edulaunch_file, error.edulaunch_line = code.co_filename, code.co_firstlineno
        with_facts(error, 'launch.test-description' if near == TEST else 'launch.no-generate', near=near)
    return error  # type: ignore[no-any-return]

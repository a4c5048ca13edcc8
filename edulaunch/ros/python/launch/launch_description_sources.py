"""Launch files as sources of launch descriptions."""

from __future__ import annotations

import os
from collections.abc import Callable
from types import FunctionType, ModuleType
from typing import TYPE_CHECKING, Any

from ._engine import load_module
from ._lazy import has_ros_paths
from ._run_notes import note_wrong_return
from .frontend.invalid_frontend_launch_file_error import InvalidFrontendLaunchFileError as InvalidFrontendLaunchFileError
from .launch_description_source import InvalidLaunchFileError, LaunchDescriptionSource
from .substitution import SomeSubstitutionsType

if TYPE_CHECKING:
    from .frontend.parser import Parser
    from .launch_description import LaunchDescription

GENERATE = 'generate_launch_description'


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
    if not hasattr(module, GENERATE):
        raise _no_function(python_launch_file_path, module)
    description: LaunchDescription = module.generate_launch_description()
    if not hasattr(description, 'get_launch_arguments'):
        note_wrong_return(module.generate_launch_description)
    return description


def _no_function(path: str, module: ModuleType) -> InvalidPythonLaunchFileError:
    """The error, with the line of a function whose name is nearly right."""
    from edulaunch.engine.facts import with_facts
    from edulaunch.engine.nearest import nearest

    error: Any = InvalidPythonLaunchFileError(f"launch file at '{path}' does not contain the required function '{GENERATE}()'")
    functions = {name: value for name, value in vars(module).items() if isinstance(value, FunctionType)}
    near = nearest(GENERATE, functions)
    if near is not None:
        code = functions[near].__code__
        error.edulaunch_file, error.edulaunch_line = code.co_filename, code.co_firstlineno
        with_facts(error, 'launch.no-generate', near=near)
    return error  # type: ignore[no-any-return]


def get_launch_description_from_frontend_launch_file(
    frontend_launch_file_path: str, *, parser: type[Parser] | None = None
) -> LaunchDescription:
    """The description in the file.

    :param parser: of its format; without one all are tried, those first that know the file's extension.
    :raises InvalidFrontendLaunchFileError: when no parser can read it.
    """
    from .frontend.parser import Parser

    root, found = (parser or Parser).load(frontend_launch_file_path)
    description: LaunchDescription = found.parse_description(root)
    return description


def get_launch_description_from_any_launch_file(launch_file_path: str) -> LaunchDescription:
    """The description in the file: `.py` files are tried as Python first, others last.

    :raises InvalidLaunchFileError: when nobody can read it, with what each loader said.
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


class PythonLaunchDescriptionSource(LaunchDescriptionSource):
    """A launch file written in Python, whatever its name ends with. Errors in it are raised as they are."""

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, 'interpreted python launch file')

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_python_launch_file(location)


class FrontendLaunchDescriptionSource(LaunchDescriptionSource):
    """A launch file written in XML, YAML or another format.

    :param parser: of the format; without one all are tried.
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


class AnyLaunchDescriptionSource(LaunchDescriptionSource):
    """A launch file of any format; all loaders are tried, the likely one first."""

    def __init__(self, launch_file_path: SomeSubstitutionsType) -> None:
        super().__init__(None, launch_file_path, 'interpreted launch file')

    def _get_launch_description(self, location: str) -> LaunchDescription:
        return get_launch_description_from_any_launch_file(location)


has_ros_paths(
    __name__,
    'AnyLaunchDescriptionSource FrontendLaunchDescriptionSource InvalidFrontendLaunchFileError=frontend_launch_file_utilities '
    'InvalidLaunchFileError=any_launch_file_utilities InvalidPythonLaunchFileError=python_launch_file_utilities '
    'PythonLaunchDescriptionSource get_launch_description_from_any_launch_file=any_launch_file_utilities '
    'get_launch_description_from_frontend_launch_file=frontend_launch_file_utilities '
    'get_launch_description_from_python_launch_file=python_launch_file_utilities '
    'load_python_launch_file_as_module=python_launch_file_utilities',
)

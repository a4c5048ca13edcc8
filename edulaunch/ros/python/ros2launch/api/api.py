"""Functions that find a launch file, and show or launch its content."""

from __future__ import annotations

import os
from collections.abc import Iterable
from typing import TYPE_CHECKING

from ament_index_python.packages import PackageNotFoundError, get_package_share_directory

from edulaunch.engine.processes import current_process

if TYPE_CHECKING:
    from launch.launch_description import LaunchDescription

Arguments = Iterable[str]
HEADING = "Arguments (pass arguments as '<name>:=<value>'):"


class MultipleLaunchFilesError(Exception):
    """Several files of a package have the requested name.

    :ivar paths: the paths of these files.
    """

    def __init__(self, msg: str, paths: list[str]) -> None:
        super().__init__(msg)
        self.paths = paths


def get_share_file_path_from_package(*, package_name: str, file_name: str | None) -> str:
    """Return the path of the only file with the given name below the package's share folder.

    :raises PackageNotFoundError: when there is no such package.
    :raises FileNotFoundError: when there is no such file.
    :raises MultipleLaunchFilesError: when there are several such files.
    """
    try:
        share = get_package_share_directory(package_name)
    except PackageNotFoundError as error:
        raise PackageNotFoundError(f"Package '{package_name}' not found: {error}") from error
    found = [
        os.path.join(folder, name)
        for folder, _, names in sorted(os.walk(share, followlinks=True))
        for name in sorted(names)
        if name == file_name
    ]
    if not found:
        raise FileNotFoundError(
            f"file '{file_name}' was not found in the share directory of package '{package_name}' which is at '{share}'"
        )
    if len(found) > 1:
        raise MultipleLaunchFilesError(
            f"file '{file_name}' was found more than once in the share directory of package '{package_name}': {found}", found
        )
    return found[0]


def is_launch_file(path: str) -> bool:
    """Return whether a path is a file with the name of a launch file."""
    from launch.frontend.parser import Parser

    extensions = ['py', *Parser.get_file_extensions_from_parsers()]
    return os.path.isfile(path) and any(path.endswith('.' + extension) for extension in extensions)


def parse_launch_arguments(launch_arguments: Arguments) -> list[tuple[str, str]]:
    """Return (name, value) for each argument `name:=value`. If several arguments have the same name, the last value counts.

    :raises RuntimeError: for a string of another form.
    """
    parsed: dict[str, str] = {}
    for argument in launch_arguments:
        name, sign, value = argument.partition(':=')
        if not (name and sign and value):
            raise RuntimeError(f"malformed launch argument '{argument}', expected format '<name>:=<value>'")
        parsed[name] = value
    return list(parsed.items())


def load_launch_file(path: str) -> LaunchDescription:
    """Return the launch description of the file, without launching it.

    :raises InvalidLaunchFileError: when the file cannot be loaded.
    """
    from launch.launch_description_sources.any_launch_file_utilities import get_launch_description_from_any_launch_file

    return get_launch_description_from_any_launch_file(path)


def print_a_launch_file(*, launch_file_path: str) -> None:
    """Print the launch description of the file as a tree."""
    from launch.launch_introspector import LaunchIntrospector

    _print(LaunchIntrospector().format_launch_description(load_launch_file(launch_file_path)))


def print_arguments_of_launch_file(*, launch_file_path: str) -> None:
    """Print the launch arguments of the file, as `ros2 launch -s` does."""
    description = load_launch_file(launch_file_path)
    _print(HEADING)  # printed first, because an error in an included file appears below it
    _print(arguments_text(description).removeprefix(HEADING + '\n'))


def arguments_text(launch_description: LaunchDescription) -> str:
    """Return the launch arguments of a description as `ros2 launch -s` shows them."""
    lines = [HEADING]
    arguments = launch_description.get_launch_arguments()
    for argument in arguments:
        star = '*' if argument._conditionally_included else ''
        lines += ['', f"    '{argument.name}':{star}", *(f'        {line}' for line in argument.description.splitlines())]
        if argument.default_value is not None:
            lines.append(f'        (default: {" + ".join(part.describe() for part in argument.default_value)})')
    if any(argument._conditionally_included for argument in arguments):
        lines += ['', '* argument(s) which are only used if specific conditions occur']
    if not arguments:
        lines += ['', '  No arguments.']
    return '\n'.join(lines)


def launch_a_launch_file(
    *,
    launch_file_path: str,
    launch_file_arguments: Arguments,
    noninteractive: bool = False,
    args: object = None,
    option_extensions: object = None,
    debug: bool = False,
) -> int:
    """Launch the file, and wait until the launch has ended. Return the exit code.

    :param launch_file_arguments: strings `name:=value`.
    :param noninteractive: whether no terminal is attached.
    :raises RuntimeError: for a malformed argument.
    """
    from launch.actions.include_launch_description import IncludeLaunchDescription
    from launch.launch_description import LaunchDescription
    from launch.launch_description_sources.any_launch_description_source import AnyLaunchDescriptionSource
    from launch.launch_service import LaunchService

    texts = list(launch_file_arguments)
    service = LaunchService(argv=texts, noninteractive=noninteractive, debug=debug)
    service.include_launch_description(
        LaunchDescription(
            [
                IncludeLaunchDescription(
                    AnyLaunchDescriptionSource(launch_file_path), launch_arguments=parse_launch_arguments(texts)
                )
            ]
        )
    )
    return service.run()


def _print(text: str) -> None:
    current_process().streams.stdout.write(text + '\n')

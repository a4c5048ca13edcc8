"""What runs inside the process of `ros2 launch`, and how its end is told. Loaded when the first launch runs."""

from __future__ import annotations

from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.packages import Index
from edulaunch.processes.current import current_process
from edulaunch.processes.origin import Origin

if TYPE_CHECKING:
    from edulaunch.launching import LaunchRun
    from edulaunch.session import Session


class Explanation(NamedTuple):
    """An error in words: ROS 2's text with the place in the student's file, and what to try."""

    text: str
    help: str | None
    file: str | None
    line: int | None


def run_launch_service(launch: LaunchRun) -> int:
    """The main program of `ros2 launch FILE name:=value ...`; returns launch's own return code."""
    from launch import LaunchDescription, LaunchService
    from launch.actions import IncludeLaunchDescription
    from launch.launch_description_sources import AnyLaunchDescriptionSource

    include = IncludeLaunchDescription(AnyLaunchDescriptionSource(launch.path), launch_arguments=list(launch.arguments.items()))
    service = LaunchService(argv=list(launch.process.argv), noninteractive=not launch.interactive, debug=launch.debug)
    service.include_launch_description(LaunchDescription([include]))
    return int(service.run())


def first_error(launch: LaunchRun) -> BaseException | None:
    """The first exception that launch caught, if any."""
    errors = launch.process.state.get('launch.exceptions')
    return errors[0] if errors else None


def explain(error: BaseException, index: Index) -> Explanation:
    """An exception from a launch file as a message for people; places are in the student's own files."""
    from launch._help import launch_help, launch_origin

    place = launch_origin(error)
    if place is not None:
        place = Origin(index.source_path(place.file), place.line)
    text = str(error) or type(error).__name__
    return Explanation(text if place is None else f'{text}\n  at {place}', launch_help(error), *(place or (None, None)))


def describe(launch: LaunchRun) -> dict[str, Any]:
    """What a recording keeps of a launch."""
    state = launch.process.state
    declared = [_declared(argument) for argument in state.get('launch.declared', ())]
    told = None if (error := first_error(launch)) is None else explain(error, launch.process.index)
    unread = [*_unknown_arguments(launch, [row[0] for row in declared]), *_undeclared_there(launch)]
    return {
        'file': launch.path,
        'arguments': launch.arguments,
        'declared': declared,
        'includes': list(state.get('launch.includes', ())),
        'returncode': launch.process.returncode,
        'error': told.text if told else None,
        'error_file': told.file if told else None,
        'error_line': told.line if told else None,
        'help': told.help if told else None,
        **({'unread': unread} if unread else {}),
    }


def _declared(argument: Any) -> list[Any]:
    default = None if argument.default_value is None else ' + '.join(part.describe() for part in argument.default_value)
    place = argument.origin or (None, None)
    return [argument.name, default, argument.description, argument.choices, place[0], place[1]]


def _unknown_arguments(launch: LaunchRun, declared: list[str]) -> list[list[Any]]:
    """Launch arguments that no launch file declares or reads; ROS 2 accepts them in silence."""
    known = {*declared, *launch.process.state.get('launch.read', ())}
    return [[name, declared, None, None, None] for name in launch.arguments if name not in known]


def _undeclared_there(launch: LaunchRun) -> list[list[Any]]:
    """Arguments that were given to an included file which does not declare them, and that nothing has read."""
    state, source = launch.process.state, launch.process.index.source_path
    found = []
    for name, declared, file, origin in state.get('launch.undeclared', ()):
        if name not in state.get('launch.read', ()):
            place = [None, None] if origin is None else [source(origin.file), origin.line]
            row = [name, list(declared), source(file), *place]
            found += [row] if row not in found else []
    return found


def show_arguments(session: Session, package_or_path: str, file: str | None) -> int:
    """`ros2 launch ... -s`: print the arguments that may be given."""
    from ros2launch.api import print_arguments_of_launch_file

    from edulaunch.launching import find_launch_file

    path = find_launch_file(session.index, package_or_path, file)
    process = current_process()
    process.index, process.host.index = session.index, session.index
    process.env.update(session.host.env)
    print_arguments_of_launch_file(launch_file_path=path)
    return 0

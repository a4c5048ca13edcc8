"""What runs inside the process of `ros2 launch`, and how its end is told. Loaded when the first launch runs."""

from __future__ import annotations

import os
from typing import TYPE_CHECKING, Any, NamedTuple

from edulaunch.nearest import nearest
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
    from launch._run_notes import undeclared_warnings

    state = launch.process.state
    declared = [_declared(argument) for argument in state.get('launch.declared', ())]
    told = None if (error := first_error(launch)) is None else explain(error, launch.process.index)
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
        'warnings': [
            *_unknown_arguments(launch, [row[0] for row in declared]),
            *undeclared_warnings(state),
            *_dead_programs(launch),
        ],
    }


def _declared(argument: Any) -> list[Any]:
    default = None if argument.default_value is None else ' + '.join(part.describe() for part in argument.default_value)
    place = argument.origin or (None, None)
    return [argument.name, default, argument.description, argument.choices, place[0], place[1]]


def _unknown_arguments(launch: LaunchRun, declared: list[str]) -> list[str]:
    """ROS 2 accepts a misspelt launch argument in silence; we say so."""
    known = {*declared, *launch.process.state.get('launch.read', ())}
    lines = []
    for name in launch.arguments:
        if name not in known and declared:
            near = nearest(name, declared)
            lines.append(
                f"launch argument '{name}' is not declared by any of the launch files; "
                + (f"did you mean '{near}'?" if near else f'declared are: {", ".join(declared)}')
            )
        elif name not in known:
            lines.append(f"launch argument '{name}' is not declared: these launch files declare no arguments")
    return lines


def _dead_programs(launch: LaunchRun) -> list[str]:
    """A node that died leaves launch's exit code at 0; we say which and why."""
    lines = []
    for row in launch.recorder.processes:
        if row['returncode'] in (None, 0, -2, -15) or row['name'] == launch.process.name:
            continue
        if not _is_child(launch, row) and not _is_interrupted_command(launch, row):
            error = row['exception']
            place = error if error and error['file'] else row
            where = f' at {launch.process.index.source_path(place["file"])}:{place["line"]}' if place['file'] else ''
            said = _said(launch, row['name'])
            why = f'{error["type"]}: {error["message"]}' if error else next((line for line in said if not _is_help(line)), '')
            help = f'; {said[0]}' if said and _is_help(said[0]) else ''
            lines.append(f'{row["name"]} died with exit code {row["returncode"]}{f" ({why})" if why else ""}{where}{help}')
    return list(dict.fromkeys(lines))  # one that was started again may have died again


def _is_child(launch: LaunchRun, row: dict[str, Any]) -> bool:
    """Whether a program of the launch started it (`subprocess`), goes under that one's name, and hears of its end itself."""
    return any(
        other['name'] == row['name']
        and other['started'] <= row['started']
        and (other['ended'] is None or row['started'] < other['ended'] or row['ended'] == other['ended'])
        for other in launch.recorder.processes[: launch.recorder.processes.index(row)]
    )


def _is_interrupted_command(launch: LaunchRun, row: dict[str, Any]) -> bool:
    """Whether this is a `ros2` command after Ctrl-C: it returns 2 then, and after wrong words, which it complains of."""
    is_command = os.path.basename(row['argv'][0]) == 'ros2'
    return is_command and row['returncode'] == 2 and not any(': error: ' in line for line in _said(launch, row['name']))


def _said(launch: LaunchRun, name: str) -> list[str]:
    """The lines that a program wrote to its error stream, the last one first."""
    text = ''.join(row[3] for row in launch.recorder.output_lines if row[1] == name and row[2] == 'stderr')
    return [line.strip() for line in reversed(text.splitlines()) if line.strip()]


def _is_help(line: str) -> bool:
    return line.startswith('help: ')


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

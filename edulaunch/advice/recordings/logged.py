"""Rules about problems that ROS 2 only logs: a missing parameter file or component, and a goal whose callback failed."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import launch_files
from edulaunch.advice.runs import fact_place
from edulaunch.engine.nearest import nearest, nearest_file
from edulaunch.engine.packages.reading import read_manifest

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

_NO_FILE = 'Parameter file path is not a file: '
_NOT_LOADED = re.compile(r"Failed to load node '.*' of type '(.*)' in container '(.*)': Failed to find class")
_COMPONENTS = re.compile(r'Failed to find class.*\n  help: components of \S+: (.*)')


@rule(
    'launch.parameter-file-absent',
    what=(
        'the build does not install the parameter file {source}, so a node starts without its values',
        'the parameter file {path} does not exist, so a node starts without its values',
    ),
    why='launch only prints a warning, and continues',
    do=(
        "remove the first / of '{joined}', because os.path.join() ignores everything before a part that begins with /",
        "add (os.path.join('share', package_name, '{folder}'), glob('{pattern}')) to data_files of setup.py",
        'add install(DIRECTORY {folder} DESTINATION share/${{PROJECT_NAME}}) to CMakeLists.txt',
        'write {near}',
        'write the path of {relative} with os.path.join(get_package_share_directory(...), ...), not relative to the terminal',
        'create that file, or write the path of the file that you mean',
    ),
    lesson='03_parameters',
    level='error',
)
def parameter_file_absent(recording: Recording) -> Iterator[Finding]:
    """Report a missing parameter file that launch_ros has logged."""
    logs = [message for _, process, _, _, message in recording.rows('logs') if message.startswith(_NO_FILE)]
    for path in dict.fromkeys(message.removeprefix(_NO_FILE) for message in logs):
        file, line, joined = _written(recording, path)
        if os.path.isabs(path):
            folder, name = os.path.split(path)
            near = nearest_file(name, os.listdir(folder)) if os.path.isdir(folder) else None
            head, _, tail = path.rpartition(f'{os.sep}share{os.sep}')
            is_shared = os.path.isfile(os.path.join(head, 'share', tail.partition(os.sep)[0], 'package.xml'))
            shown = os.path.join('share', tail) if is_shared else path
            source = _not_installed(file, *tail.split(os.sep, 1)) if is_shared and joined is None else {}
            yield found('file', name, file=file, line=line, path=shown, joined=joined, near=near, **source)
        else:
            yield found('file', os.path.basename(path), file=file, line=line, path=path, relative=path)


def _not_installed(launch_file: str | None, package: str, *inside: str) -> dict[str, Any]:
    """Return facts about a file that exists in the package of the launch file but is not installed.

    :param launch_file: the path of the launch file.
    :param package: the name of the package.
    :param inside: the parts of the file's path in the package.
    """
    folder = os.path.dirname(os.path.realpath(launch_file or ''))
    while not os.path.isfile(os.path.join(folder, 'package.xml')) and folder != os.path.dirname(folder):
        folder = os.path.dirname(folder)
    source = os.path.join(folder, *inside)
    manifest = read_manifest(folder, []) if os.path.isfile(source) and inside else None
    if manifest is None or manifest.name != package:
        return {}
    top, is_python = os.path.dirname(inside[0]), os.path.isfile(os.path.join(folder, 'setup.py'))
    return {'source': source, 'folder': top, 'pattern': f'{top}/*' if is_python else None}


def _written(recording: Recording, path: str) -> tuple[str | None, int | None, str | None]:
    """Return the place in a launch file that contains the name of a parameter file.

    The third value is the argument of os.path.join() there that begins with a slash, or None.
    """
    for file in filter(os.path.isfile, dict.fromkeys(launch_files(recording))):
        with open(file, encoding='utf-8', errors='replace') as text:
            for number, line in enumerate(text, 1):
                if os.path.basename(path) in line:
                    parts = re.findall(r"""join\(.*,\s*['"](/[^'"]*)['"]""", line)
                    return file, number, next((part for part in parts if path.startswith(part)), None)
    return recording.launch.file, None, None


@rule(
    'launch.component-not-loaded',
    what='the container {container} cannot load {plugin}, because the package has no component with this name',
    why='launch logs an error, and the other programs continue without this node',
    do=('write {near}', 'use one of its components: {known}'),
    level='error',
    hides=('messages.nobody-publishes', 'messages.nobody-listens'),
)
def component_not_loaded(recording: Recording) -> Iterator[Finding]:
    """Report a component that launch_ros could not load. The finding lists the components that are available."""
    messages = [message for _, _, _, _, message in recording.rows('logs') if 'Failed to ' in message]
    lists = [match[1] for message in messages if (match := _COMPONENTS.match(message))]
    for message in messages:
        match = _NOT_LOADED.match(message)
        if match is not None and lists:
            known = lists[-1].split(', ')
            line = _written(recording, match[1])
            yield found(
                'container', match[2], file=line[0], line=line[1], plugin=match[1], near=nearest(match[1], known), known=known
            )


@rule(
    'programs.native-component',
    what='the component {plugin} of {package} is built from C++, but edulaunch runs only Python programs',
    why='the container does not load this component, and the other programs continue',
    do='run it where ROS 2 is installed, or write the node in Python',
    level='info',
)
def native_component(recording: Recording) -> Iterator[Finding]:
    """Report a component in C++ that a launch or a user tried to load into a container."""
    for time_ns, _, _, _, message in recording.rows('logs'):
        match = re.search(r'\n  help: (\S+) of (\S+) is built from C\+\+', message)
        if match is not None:
            file, line, _ = _written(recording, match[1])
            yield found('component', match[1], file=file, line=line, time_s=time_ns / 1e9, plugin=match[1], package=match[2])


@rule(
    'programs.no-goal-response',
    what='the goal callback {callback}() of {node} returned {returned} instead of a GoalResponse, so the goal is rejected',
    why='an action server accepts a goal only if the callback returns GoalResponse.ACCEPT',
    do='return GoalResponse.ACCEPT or GoalResponse.REJECT, and write: from rclpy.action import GoalResponse',
    lesson='14_services',
    level='error',
)
def no_goal_response(recording: Recording) -> Iterator[Finding]:
    """Report a goal callback that returned a boolean, None or another wrong value."""
    for fact in recording.facts:
        if fact.kind == 'no goal response':
            file, line = fact_place(recording, fact)
            facts = {'callback': fact.data['callback'], 'returned': fact.data['returned']}
            yield found('node', fact.data['node'], file=file, line=line, time_s=fact.time_s, **facts)


@rule(
    'programs.goal-failed',
    what='the execute callback of {node} ended with an exception: {said}',
    why='rclpy logs the exception, ends the goal as aborted, and the node continues',
    do=(
        'read the goal from its request: write .request.{field} in place of .{field}',
        'correct this line, or catch the exception and call goal_handle.abort()',
    ),
    lesson='14_services',
    level='error',
    hides=('programs.goal-unfinished',),
)
def goal_failed(recording: Recording) -> Iterator[Finding]:
    """Report an exception in an execute callback. rclpy catches the exception, and the node continues to run."""
    for fact in recording.facts:
        if fact.kind == 'goal failed':
            file, line = fact_place(recording, fact)
            of_handle = re.search(r"'ServerGoalHandle' object has no attribute '(\w+)'", fact.data['said'])
            facts = {'said': fact.data['said'], 'field': of_handle and of_handle[1]}
            yield found('node', fact.data['node'], file=file, line=line, time_s=fact.time_s, **facts)

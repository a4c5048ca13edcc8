"""Explain commands that set up a real ROS 2 computer or open a window, and that are not needed here.

The explanations name the command that shows the same information.
"""

from __future__ import annotations

import os
import re
from collections.abc import Sequence

WINDOWS = {
    'rqt': 'graph',
    'rqt_console': 'log',
    'rqt_graph': 'graph',
    'rqt_plot': 'plot',
    'rqt_publisher': 'terminal',
    'rqt_reconfigure': 'parameters',
    'rqt_service_caller': 'terminal',
    'rqt_tf_tree': 'tree',
    'rviz2': 'frames',
}
"""Commands and packages with a window, and the tab of the live view that replaces it."""


def shown_by(name: str) -> str:
    """Return the sentence that names the tab of the live view which shows the content of a program's window."""
    return f'{name} opens a window, but there is no screen: `edulaunch view --tab {WINDOWS[name]}` shows the same in a browser'


ABSENT = {
    **dict.fromkeys(
        ('gazebo', 'gz', 'gzclient', 'gzserver', 'ign'),
        'is not part of edulaunch. Launch files for Gazebo start a simulated robot, and `edulaunch view` shows it in a browser',
    ),
    'check_urdf': 'is not part of edulaunch. '
    'To check a URDF file, run `ros2 run robot_state_publisher robot_state_publisher FILE`',
}
"""Commands of other programs that tutorials use, and what replaces them."""
_DEBIAN = re.compile(r'(~n|\?name\()?ros-[a-z]+-(?P<package>[a-z0-9-]+?)[-*)]*')
_DISTRIBUTION = re.compile(r'/opt/ros/(?P<name>[a-z]+)/(local_)?setup\.\w+')
_BUILDING = ('build', 'build-and-test')
_SHOWN = 5


def answer(words: Sequence[str], folder: str = os.curdir) -> str | None:
    """Return the explanation of a command that is not needed here, or None for any other command.

    These commands have an explanation:

    - `colcon`, `rosdep` and `vcs`
    - `apt` with packages of ROS
    - `source` of setup files
    - `ls` of folders that only a build creates
    - programs that open a window

    :param words: the command line, including `sudo`.
    :param folder: the current folder of the command.
    """
    rest = [word for word in words if word != 'sudo']
    command, arguments = (rest or [''])[0], rest[1:]
    if command == 'colcon':
        return _colcon(arguments, folder)
    if command == 'rosdep' and arguments[:1] != ['check']:
        return 'rosdep: you do not need to install anything; `rosdep check` lists the dependencies that edulaunch does not have.'
    if command in ('apt', 'apt-get') and (
        names := [found['package'] for word in arguments if (found := _DEBIAN.fullmatch(word))]
    ):
        return _apt([name.replace('-', '_') for name in names])
    if command in WINDOWS:
        return shown_by(command)
    if command in ABSENT:
        return f'{command} {ABSENT[command]}.'
    if command in ('source', '.') and arguments:
        return _source(arguments[0])
    if command == 'ls':
        return _absent_folder([word for word in arguments if word[:1] != '-' and not os.path.exists(os.path.join(folder, word))])
    return None


def _absent_folder(paths: Sequence[str]) -> str | None:
    for path in paths:
        if '/.ros/log' in path:
            return 'ls: `ros2 launch` in a terminal writes log files to ~/.ros/log. The folder appears at the first launch.'
        if (made := next((part for part in path.split('/') if part in ('build', 'install')), None)) is not None:
            return f'ls: there is no folder `{made}`, because edulaunch needs no build and reads packages from their sources.'
    return None


def _colcon(words: Sequence[str], folder: str) -> str:
    from edulaunch.engine.packages import Index
    from edulaunch.engine.packages.discovery import find_workspaces, install_folders
    from edulaunch.ros.sources import read_source

    if words[:1] == ['test']:
        return 'colcon test: run the tests with pytest in the folder of the package: python3 -m pytest'
    if words[:1] and words[0] not in _BUILDING:
        return f'colcon {words[0]}: not needed here; `edulaunch pkg check` finds mistakes in packages.'
    sources = install_folders(find_workspaces(folder, {}))[1]
    names = list(Index((), sources, read_source=read_source, underlay=None).packages())
    if not names:
        return (
            'colcon build: edulaunch needs no build, and there is no package in this folder. Change to the folder of your '
            'workspace, or create a package with `ros2 pkg create`.'
        )
    return (
        f'colcon build: edulaunch needs no build. It reads {_listed(names)} from the sources at each launch, without an '
        '`install` folder. `edulaunch pkg check` reports what a build would reject.'
    )


def _apt(names: Sequence[str]) -> str:
    from edulaunch.engine.packages import Index

    here = {*Index().packages(), *WINDOWS}
    missing = [name for name in names if name not in here]
    if not missing:
        return f'apt: {_listed(names)} {"is" if len(names) == 1 else "are"} already part of edulaunch.'
    return (
        f'apt: edulaunch does not install packages of ROS 2, and {_listed(missing)} '
        f'{"is" if len(missing) == 1 else "are"} not part of edulaunch.'
    )


def _source(path: str) -> str | None:
    distribution = _DISTRIBUTION.fullmatch(path)
    if distribution is not None:
        name = distribution['name'].capitalize()
        return f'source: you do not need to source ROS 2 {name}, because edulaunch has the packages of ROS 2 Jazzy.'
    if os.path.basename(path).startswith(('setup.', 'local_setup.')):
        return (
            'source: not needed; edulaunch finds packages in this folder, in the folders above it, and in EDULAUNCH_WORKSPACES.'
        )
    return None


def _listed(names: Sequence[str]) -> str:
    more = len(names) - _SHOWN
    return ', '.join(names[:_SHOWN]) + (f' and {more} more' if more > 0 else '')

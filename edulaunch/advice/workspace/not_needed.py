"""What to say to commands that set up a real ROS 2 machine, or open a window: what of it is not needed here, what is, and what
shows the same.
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
"""Command or package, and the tab of the live page."""


def shown_by(name: str) -> str:
    """The sentence that says where to look."""
    return f'{name} opens a window, and there is none here: `edulaunch view --tab {WINDOWS[name]}` shows it in a browser'


ABSENT = {
    **dict.fromkeys(
        ('gazebo', 'gz', 'gzclient', 'gzserver', 'ign'),
        'is not here: launch files that start Gazebo get a robot of edulaunch instead; `edulaunch view` shows it in a browser',
    ),
    'check_urdf': 'is not here: `ros2 run robot_state_publisher robot_state_publisher FILE` reads a URDF file and says '
    'what is wrong in it',
}
"""Commands of other programs that tutorials use, and what does their work."""
_DEBIAN = re.compile(r'(~n|\?name\()?ros-[a-z]+-(?P<package>[a-z0-9-]+?)[-*)]*')
_DISTRIBUTION = re.compile(r'/opt/ros/(?P<name>[a-z]+)/(local_)?setup\.\w+')
_BUILDING = ('build', 'build-and-test')
_SHOWN = 5


def answer(words: Sequence[str], folder: str = os.curdir) -> str | None:
    """A friendly sentence for `colcon`, `rosdep`, `vcs`, `apt` with packages of ROS, `source` of setup files, and windows.

    :param words: the command line, `sudo` and all.
    :param folder: the current folder of the command.
    :return: None for any other command, which is none of ours.
    """
    rest = [word for word in words if word != 'sudo']
    command, given = (rest or [''])[0], rest[1:]
    if command == 'colcon':
        return _colcon(given, folder)
    if command == 'rosdep' and given[:1] != ['check']:
        return 'rosdep: nothing has to be installed; `rosdep check` names what a package needs and what is not here.'
    if command in ('apt', 'apt-get') and (names := [found['package'] for word in given if (found := _DEBIAN.fullmatch(word))]):
        return _apt([name.replace('-', '_') for name in names])
    if command in WINDOWS:
        return shown_by(command)
    if command in ABSENT:
        return f'{command} {ABSENT[command]}.'
    if command in ('source', '.') and given:
        return _source(given[0])
    return None


def _colcon(words: Sequence[str], folder: str) -> str:
    from edulaunch.engine.packages import Index
    from edulaunch.engine.packages.discovery import find_workspaces, install_folders
    from edulaunch.ros.sources import read_source

    if words[:1] == ['test']:
        return 'colcon test: the tests of packages run with pytest here, in the folder of the package: python3 -m pytest'
    if words[:1] and words[0] not in _BUILDING:
        return f'colcon {words[0]}: not needed here; `edulaunch pkg check` looks for mistakes in packages.'
    sources = install_folders(find_workspaces(folder, {}))[1]
    names = list(Index((), sources, read_source=read_source, underlay=None).packages())
    if not names:
        return (
            'colcon build: nothing has to be built here, and no package is here either: go to the folder of your workspace, '
            'or make one with `ros2 pkg create`.'
        )
    return (
        f'colcon build: nothing has to be built here. {_listed(names)} {"is" if len(names) == 1 else "are"} read from the '
        'sources each time, without an `install` folder, so what you write now runs at the next launch; `edulaunch pkg check` '
        'says what a build would reject.'
    )


def _apt(names: Sequence[str]) -> str:
    from edulaunch.engine.packages import Index

    here = {*Index().packages(), *WINDOWS}
    missing = [name for name in names if name not in here]
    if not missing:
        return f'apt: {_listed(names)} {"is" if len(names) == 1 else "are"} here already; edulaunch brings its own.'
    return (
        f'apt: nothing of ROS 2 is installed here; edulaunch brings what it has, and {_listed(missing)} '
        f'{"is" if len(missing) == 1 else "are"} not among it.'
    )


def _source(path: str) -> str | None:
    distribution = _DISTRIBUTION.fullmatch(path)
    if distribution is not None:
        name = distribution['name'].capitalize()
        return f'source: ROS 2 {name} has not to be sourced here; edulaunch brings what there is, and that is as in Jazzy.'
    if os.path.basename(path).startswith(('setup.', 'local_setup.')):
        return 'source: not needed; packages are found from the folder you are in upwards, and EDULAUNCH_WORKSPACES adds others.'
    return None


def _listed(names: Sequence[str]) -> str:
    more = len(names) - _SHOWN
    return ', '.join(names[:_SHOWN]) + (f' and {more} more' if more > 0 else '')

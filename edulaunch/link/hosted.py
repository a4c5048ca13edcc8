"""Which programs the trusted half hosts: those that came with edulaunch, but for a few that read a student's files or keys."""

from __future__ import annotations

import os
from functools import cache

from edulaunch.packages import Program
from edulaunch.packages.underlay import Underlay
from edulaunch.underlay_place import underlay_prefix

OF_THE_STUDENT = {
    'joint_state_publisher': None,
    'joint_state_publisher_gui': None,
    'launch_testing': None,
    'robot_state_publisher': None,
    'rviz2': None,
    'teleop_twist_keyboard': None,
    'tf2_tools': None,
    'turtlesim': ('turtle_teleop_key',),
    'xacro': None,
}
"""They read files or keys, and run beside the student's own programs: by package, all (None) or these executables."""


@cache
def _underlay() -> Underlay:
    return Underlay(underlay_prefix())


def hosted_program(package: str, executable: str) -> Program | None:
    """The program of that name, if the trusted half hosts it."""
    own = OF_THE_STUDENT.get(package, ())
    return None if own is None or executable in own else _underlay().program(package, executable)


def is_hosted(program: Program | None) -> bool:
    """Whether the trusted half has this very program."""
    if program is None or program.kind != 'entry_point':
        return False
    ours = hosted_program(program.package, program.executable)
    return ours is not None and (ours.module, ours.function) == (program.module, program.function)


def shipped_path(package: str | None, executable: str | None) -> str:
    """The word that starts a stock program in a command line."""
    return os.path.join(underlay_prefix(), 'lib', package or '', executable or '')

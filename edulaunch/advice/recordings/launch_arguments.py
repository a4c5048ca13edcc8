"""Launch arguments that were given and that no launch file declares."""

from __future__ import annotations

import os
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.rule import rule
from edulaunch.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.recording import Recording


@rule(
    'launch.unknown-argument',
    what="no launch file declares the argument '{argument}', so giving it changed nothing",
    why='ROS 2 takes any name:=value, and says nothing of a name that no launch file reads',
    do=(
        "write '{near}:=' instead of '{argument}:='",
        'give one of the declared arguments: {declared}',
        "leave it out, or declare it in the launch file: DeclareLaunchArgument('{argument}')",
    ),
    lesson='01_first_launch',
)
def unknown_argument(recording: Recording) -> Iterator[Finding]:
    """Not when a file reads a configuration of that name without declaring it: then it has changed something."""
    for argument in recording.launch.unread:
        if argument.included is None:
            yield found('argument', argument.name, declared=argument.declared, near=nearest(argument.name, argument.declared))


@rule(
    'launch.undeclared-in-include',
    what="{included} is given the argument '{argument}', which it does not declare, so nothing changed",
    why='an include sets what it is given in silence, also when no one there reads it',
    do=(
        "write '{near}' instead of '{argument}'",
        'give one of the arguments that {included} declares: {declared}',
        "leave it out, or declare it in {included}: DeclareLaunchArgument('{argument}')",
    ),
    lesson='13_large_project',
)
def undeclared_in_include(recording: Recording) -> Iterator[Finding]:
    """The same for `launch_arguments` of an IncludeLaunchDescription."""
    for argument in recording.launch.unread:
        if argument.included is not None:
            yield found(
                'argument',
                argument.name,
                file=argument.file,
                line=argument.line,
                included=os.path.basename(argument.included),
                declared=argument.declared,
                near=nearest(argument.name, argument.declared),
            )

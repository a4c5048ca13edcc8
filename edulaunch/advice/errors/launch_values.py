"""Values that are only known when a launch file runs: arguments, configurations, conditions, includes."""

from __future__ import annotations

import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import about, speak
from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding
from edulaunch.advice.rule import rule
from edulaunch.nearest import nearest

NO_CONFIGURATION = about(
    'launch.no-configuration',
    what=(
        "the launch configuration '{scoped}' was set inside a GroupAction that is over by now",
        "there is no launch configuration '{configuration}'",
    ),
    why='events and timers come later than the group around them',
    do=(
        "write '{near}', if that is the one you mean",
        'give the group scoped=False, or take the value of {scoped} in an OpaqueFunction inside it',
        "put DeclareLaunchArgument('{configuration}', default_value='...') before its use",
    ),
    lesson='01_first_launch',
)


@rule(
    'launch.no-argument',
    what=("the launch argument '{needed}' is needed, and '{near}' was given", "the launch argument '{needed}' is needed"),
    do=('write {needed}:=... where you wrote {near}:=', 'pass {needed}:=..., or give its DeclareLaunchArgument a default_value'),
    level='error',
    lesson='01_first_launch',
)
def no_argument(failure: Failure) -> Iterator[Finding]:
    """An argument without a default that nobody passes."""
    said = re.search(r"missing required argument '(.*?)' .*given: \[(.*)\]", failure.message, re.DOTALL)
    if said is not None:
        given = [name for name in said[2].split(', ') if name]
        yield speak(failure, needed=said[1], near=nearest(said[1], given))


@rule(
    'launch.no-variable',
    what="the environment variable '{variable}' is not set",
    do=(
        "write '{near}', if that is the one you mean",
        "give it a default: EnvironmentVariable('{variable}', default_value='...')",
    ),
    level='error',
)
def no_variable(failure: Failure) -> Iterator[Finding]:
    """An environment variable without a default."""
    said = re.search(r"environment variable '(.*)' does not exist", failure.message)
    if said is not None:
        yield speak(failure, variable=said[1])


@rule(
    'launch.condition-value',
    what='this condition is neither true nor false',
    do='give it true, 1, false or 0; compare texts with EqualsSubstitution(left, right)',
    level='error',
    lesson='01_first_launch',
)
def condition_value(failure: Failure) -> Iterator[Finding]:
    """`IfCondition('maybe')`."""
    if failure.message.startswith('invalid condition expression'):
        yield speak(failure)


@rule(
    'launch.namespace',
    what='this namespace cannot be one',
    do="use letters, digits, '_' and '/' only, and begin no part of it with a digit",
    level='error',
)
def namespace(failure: Failure) -> Iterator[Finding]:
    """A namespace that ROS 2 refuses."""
    if failure.message.startswith('The resulting namespace is invalid'):
        yield speak(failure)


@rule(
    'launch.executed-twice',
    what='one action object stands twice in the launch description, and it starts one process only',
    do='make a new one for each use',
    level='error',
)
def executed_twice(failure: Failure) -> Iterator[Finding]:
    """The same `ExecuteProcess` object in two places."""
    if 'executed more than once' in failure.message:
        yield speak(failure)


@rule(
    'launch.too-deep',
    what='actions, includes or calls are nested without end',
    do='look for one that leads to itself',
    level='error',
)
def too_deep(failure: Failure) -> Iterator[Finding]:
    """Endless recursion in a launch file."""
    if failure.process is None and failure.message.startswith('maximum recursion depth'):
        yield speak(failure)


INCLUDE_RING = about(
    'launch.include-ring',
    what='launch files include each other in a ring: {ring}',
    do='take one of these includes out, or give it a condition that is false in the end',
)
EMPTY_PARAMETER_FILE = about(
    'launch.empty-parameter-file',
    what='the parameter file {parameter_file} has nothing in it',
    do='write the name of the node, below it ros__parameters, and below that the parameters',
)

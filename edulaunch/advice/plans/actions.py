"""Actions that do nothing."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.outlines import branches, name_of, nodes, place_of
from edulaunch.advice.rule import rule

if TYPE_CHECKING:
    from edulaunch.plan import Rehearsal

IDLE = frozenset(
    ('argument', 'include', 'set_configuration', 'push_namespace', 'set_env', 'unset_env', 'set_parameter', 'set_remap')
)


@rule(
    'launch.remapping-to-itself',
    what='{node} remaps {topic} to {topic}, which changes nothing',
    do="write the new name as the second one: remappings=[('{topic}', 'other_name')], or take the remapping out",
    lesson='01_first_launch',
)
def remapping_to_itself(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Where both names are written out; a name from an argument may well be the same for once."""
    from launch.utilities.texts import plain_text

    for branch, item in nodes(rehearsal):
        written = branch.action._Node__remappings
        for (source, target), _ in zip(written, item['remappings'][-len(written) :], strict=False):
            old, new = plain_text(source), plain_text(target)
            if old is not None and old == new:
                yield found('topic', old, **place_of(branch), node=name_of(item))


@rule(
    'launch.starts-nothing',
    what='this launch file starts nothing: no action in it starts a node or another program',
    do="write a Node into the list: LaunchDescription([Node(package='turtlesim', executable='turtlesim_node')])",
    lesson='01_first_launch',
)
def starts_nothing(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Not where a condition has left something out, or something is done besides."""
    plan = rehearsal.plan
    kinds = {item['kind'] for item in plan['items']}
    is_left_out = any(not branch.is_taken for branch in branches(rehearsal))
    if plan['error'] is None and kinds <= IDLE and not is_left_out and not rehearsal.missing[1]:
        yield found('file', plan['file'], file=plan['file'])

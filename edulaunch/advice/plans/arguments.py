"""Launch arguments that decide nothing."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING

from edulaunch.advice.finding import Finding, found
from edulaunch.advice.outlines import branches, launch_files, place_of
from edulaunch.advice.rule import rule

if TYPE_CHECKING:
    from edulaunch.plan import Rehearsal

LESSON = '02_substitutions_and_events'
OF_LAUNCH = frozenset(
    ('sigterm_timeout', 'sigkill_timeout', 'emulate_tty', 'launch-prefix', 'launch-prefix-filter', 'log_level', 'ros_namespace')
)
"""Launch itself reads these."""
_COMMENTS = re.compile(r'^[ \t]*#[^\n]*|<!--.*?-->', re.MULTILINE | re.DOTALL)


@rule(
    'launch.argument-unused',
    what="the launch argument '{argument}' is declared, and nothing reads it",
    why='whoever gives it a value changes nothing',
    do="write LaunchConfiguration('{argument}') (in XML and YAML: $(var {argument})) where its value belongs, or take it out",
    lesson=LESSON,
)
def argument_unused(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Nothing asked for it, and its name stands nowhere else in the launch files, not even under a condition that was not
    met; silent when a file could not be read."""
    declared = [branch for branch in branches(rehearsal) if branch.item is not None and branch.item['kind'] == 'argument']
    if not declared or rehearsal.plan['error'] is not None or any(word.startswith('file ') for word in rehearsal.missing[1]):
        return
    text = '\n'.join(map(_code, launch_files(rehearsal)))
    for branch in declared:
        name = branch.action.name
        if name in OF_LAUNCH or name in rehearsal.read:
            continue
        times = len({other.origin for other in declared if other.action.name == name})
        if len(re.findall(rf'(?<![\w-]){re.escape(name)}(?![\w-])', text)) <= times:
            yield found('argument', name, **place_of(branch))


def _code(file: str) -> str:
    from edulaunch.workspace.sources import read_text

    return _COMMENTS.sub('', read_text(file))


_COMPARED = re.compile(
    r"""LaunchConfig\('(?P<name>[\w-]+)'\)[^\w]*(?:==)?[^\w]*'(?P<value>[\w.-]+)'|'(?P<old>[\w-]+)' is '(?P<to>[\w.-]+)'"""
)


@rule(
    'launch.condition-never',
    what="the condition compares '{argument}' with '{value}', which is none of its choices: {choices}",
    why='it comes out the same whatever is given',
    do=("write '{near}'", "add '{value}' to choices= of the argument"),
    lesson=LESSON,
)
def condition_never(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Of an argument with choices, compared by EqualsSubstitution, a Python expression or LaunchConfigurationEquals."""
    from edulaunch.nearest import nearest

    choices = {one['name']: one['choices'] for one in rehearsal.plan['arguments'] if one['choices']}
    for branch in branches(rehearsal) if choices else ():
        said = _COMPARED.search(branch.condition or '')
        if said is None:
            continue
        name, value = said['name'] or said['old'], said['value'] or said['to']
        if name in choices and value not in choices[name]:
            facts = {'value': value, 'choices': choices[name], 'near': nearest(value, choices[name])}
            yield found('argument', name, **place_of(branch), **facts)

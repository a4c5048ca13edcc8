"""Rules about actions without an effect, unused launch arguments, and command lines that name no program."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.outlines import branches, launch_files, nodes, place_of
from edulaunch.advice.rule import Finding, found, rule

if TYPE_CHECKING:
    from edulaunch.advice.plan import Rehearsal
    from edulaunch.advice.plan.titles import Branch

IDLE = frozenset(
    ('argument', 'include', 'set_configuration', 'push_namespace', 'set_env', 'unset_env', 'set_parameter', 'set_remap')
)


@rule(
    'launch.starts-nothing',
    what='this launch file starts nothing, because it contains no action that starts a node or another program',
    do="add a Node to the list: LaunchDescription([Node(package='turtlesim', executable='turtlesim_node')])",
    lesson='01_first_launch',
)
def starts_nothing(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a launch file that starts nothing.

    Do not report the launch file if a condition skipped an action, or if an action with another effect ran.
    """
    plan = rehearsal.plan
    kinds = {item['kind'] for item in plan['items']}
    is_left_out = any(not branch.is_taken for branch in branches(rehearsal))
    is_ended = _STARTS.search(_COMMENTS.sub('', _code(plan['file']))) is not None
    if plan['error'] is None and kinds <= IDLE and not (is_left_out or is_ended or rehearsal.missing[1]):
        yield found('file', plan['file'], file=plan['file'])


LESSON = '04_conditions'
OF_LAUNCH = frozenset(
    ('sigterm_timeout', 'sigkill_timeout', 'emulate_tty', 'launch-prefix', 'launch-prefix-filter', 'log_level', 'ros_namespace')
)
"""Configurations that launch itself reads."""
_COMMENTS = re.compile(r'^[ \t]*#[^\n]*|<!--.*?-->', re.MULTILINE | re.DOTALL)


_STARTS = re.compile(r'\bsys\.exit\(|\bexit\(|\breturn LaunchDescription\(\[?\]?\)(?=.*\breturn\b)', re.DOTALL)
"""Signs of a file that ends early, because it would start something on another computer or with other arguments."""


@rule(
    'launch.argument-unused',
    what="the launch argument '{argument}' is declared but never used",
    why='a value that a user passes for this argument has no effect',
    do="use its value with LaunchConfiguration('{argument}') (in XML and YAML: $(var {argument})), or remove the declaration",
    lesson=LESSON,
)
def argument_unused(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a launch argument that no launch file uses, not even for an action that was skipped.

    Report nothing if a launch file could not be read.
    """
    declared = [branch for branch in branches(rehearsal) if branch.item is not None and branch.item['kind'] == 'argument']
    if not declared or rehearsal.plan['error'] is not None or any(word.startswith('file ') for word in rehearsal.missing[1]):
        return
    text = '\n'.join(map(_code, launch_files(rehearsal)))
    for branch in declared:
        name = branch.action.name
        if name in OF_LAUNCH or name in rehearsal.read:
            continue
        times = len({other.origin for other in declared if other.action.name == name})
        holders = re.findall(rf"""(\w+)\s*=\s*['"]{re.escape(name)}['"]""", text)
        is_read = any(re.search(rf'LaunchConfiguration\(\s*{holder}\b', text) for holder in holders)
        if not is_read and len(re.findall(rf'(?<![\w-]){re.escape(name)}(?![\w-])', text)) <= times:
            yield found('argument', name, **place_of(branch))


def _code(file: str) -> str:
    from edulaunch.ros.sources.source_package import read_text

    return _COMMENTS.sub('', read_text(file))


_COMPARED = re.compile(
    r"""LaunchConfig\('(?P<name>[\w-]+)'\)[^\w]*(?:==)?[^\w]*'(?P<value>[\w.-]+)'|'(?P<old>[\w-]+)' is '(?P<to>[\w.-]+)'"""
)


@rule(
    'launch.condition-never',
    what="the condition compares '{argument}' with '{value}', which is not one of the choices of this argument: {choices}",
    why='the condition has the same result for every value of the argument',
    do=("write '{near}'", "add '{value}' to choices= of the argument"),
    lesson=LESSON,
)
def condition_never(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a condition that is false for each of an argument's choices.

    The condition is an EqualsSubstitution, a Python expression or a LaunchConfigurationEquals.
    """
    from edulaunch.engine.nearest import nearest

    choices = {one['name']: one['choices'] for one in rehearsal.plan['arguments'] if one['choices']}
    for branch in branches(rehearsal) if choices else ():
        match = _COMPARED.search(branch.condition or '')
        if match is None:
            continue
        name, value = match['name'] or match['old'], match['value'] or match['to']
        if name in choices and value not in choices[name]:
            facts = {'value': value, 'choices': choices[name], 'near': nearest(value, choices[name])}
            yield found('argument', name, **place_of(branch), **facts)


FIRST_LAUNCH = '01_first_launch'


@rule(
    'launch.command-in-one-word',
    what="launch uses the whole string '{command}' as the name of one program",
    why='without a shell, launch does not split the string at spaces, so it cannot find the program',
    do='write each word as a separate string, as in cmd=[{words}], or add shell=True',
    lesson=FIRST_LAUNCH,
    level='error',
)
def command_in_one_word(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report an ExecuteProcess without a shell whose first word contains spaces."""
    for branch, item in _commands(rehearsal):
        first = item['cmd'][0]
        if len(first.split()) > 1 and not os.path.exists(first):
            words = ', '.join(repr(part) for word in item['cmd'] for part in word.split())
            yield found('command', first, **place_of(branch), words=words)


@rule(
    'launch.command-of-letters',
    what="cmd is the string '{command}', and launch uses each letter of it as a separate word",
    why='cmd= needs a list, and Python reads a string as a list of letters',
    do='write a list: cmd=[{words}]',
    lesson=FIRST_LAUNCH,
    level='error',
)
def command_of_letters(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report an ExecuteProcess whose command is a string, which Python reads as a list of letters."""
    for branch, item in _commands(rehearsal):
        if len(item['cmd']) > 2 and all(len(word) == 1 for word in item['cmd']):
            text = ''.join(item['cmd'])
            yield found('command', text, **place_of(branch), words=', '.join(map(repr, text.split())))


def _commands(rehearsal: Rehearsal) -> Iterator[tuple[Branch, dict[str, Any]]]:
    for branch in branches(rehearsal):
        if branch.item is not None and branch.item['kind'] == 'process' and not branch.item['shell']:
            yield branch, branch.item


@rule(
    'launch.no-package',
    what="this Node has executable='{executable}' but no package, so launch looks for a command on the PATH",
    why='the executables of ROS 2 packages are not on the PATH',
    do="add package='{package}'",
    lesson=FIRST_LAUNCH,
    level='error',
)
def no_package(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report an executable that is not on PATH, if a package of edulaunch contains it."""
    from shutil import which

    for branch, item in nodes(rehearsal):
        name = item['executable']
        if item['package'] is None and os.sep not in name and which(name) is None:
            package = _package_with(name)
            if package is not None:
                yield found('executable', name, **place_of(branch), package=package)


def _package_with(executable: str) -> str | None:
    from edulaunch.engine.packages import Index

    index = Index()
    return next((package for package in sorted(index.packages()) if executable in index.executables(package)), None)

"""Launch files with which nothing is wrong: they need an argument, or a package or module that is not here, and launch tests."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule

if TYPE_CHECKING:
    from edulaunch.advice.plan import Rehearsal

_PACKAGE = re.compile(r"package '([\w-]+)' not found")
_MODULE = re.compile(r"No module named '([\w.]+)'")
_ARGUMENT = re.compile(r"missing required argument '(.*?)' .*given: \[\]", re.DOTALL)
_ABOUT = (
    None,
    'packages.unknown',
    'packages.absent-package',
    'packages.absent-file',
    'packages.absent-module',
    'packages.made-by-build',
)
"""What an error is about when the thing belongs to others."""


@rule(
    'launch.needs-elsewhere',
    what=(
        'this launch file needs the package {package} ({belongs_to}), which edulaunch does not have',
        'this launch file needs the package {package}, which is not in this workspace',
        'this launch file needs the module {module} ({belongs_to}), which edulaunch does not have',
        'this launch file needs the module {module}, which is not in this workspace',
        'this launch file needs {made}, which a build makes from {template}',
    ),
    why='a file that cannot be read to its end cannot be checked either',
    do='name the workspace that has it with --workspace DIR, or try the file on a machine where it is installed',
    level='info',
    hides=('launch.fails',),
)
def needs_elsewhere(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Of a package or module whose name is not nearly that of one that is here."""
    error = rehearsal.plan['error']
    facts: dict[str, Any] = (error or {}).get('facts') or {}
    if error is None or facts.get('about') not in _ABOUT or facts.get('near') or facts.get('file_beside'):
        return
    if facts.get('about') == 'packages.made-by-build':
        yield found('file', rehearsal.plan['file'], **_place(error), made=facts['made'], template=facts['template'])
        return
    package = facts.get('package') or _first(_PACKAGE, error['text'])
    module = None if package else facts.get('module') or _first(_MODULE, error['text'])
    if package or module and _is_of_others(module):
        kind = facts.get('belongs_to') or _kind(package, module)
        yield found('file', rehearsal.plan['file'], **_place(error), package=package, module=module, belongs_to=kind)


@rule(
    'launch.needs-argument',
    what="this launch file needs the argument '{argument}'",
    why='it has no default, so whoever starts the file gives it a value',
    do='give it a value: {argument}:=...',
    level='info',
    hides=('launch.fails',),
)
def needs_argument(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Of an argument of the file itself, when none was given that could mean it."""
    error = rehearsal.plan['error']
    needed = None if error is None or rehearsal.plan['given'] else _first(_ARGUMENT, error['text'])
    if needed is not None and any(one['name'] == needed for one in rehearsal.plan['arguments']):
        yield found('file', rehearsal.plan['file'], file=rehearsal.plan['file'], argument=needed)


@rule(
    'launch.is-test',
    what='this file describes a launch test: it has generate_test_description(), and no generate_launch_description()',
    why='`ros2 launch` starts launch files only',
    do='run it with: launch_test {file}',
    level='info',
    hides=('launch.fails',),
)
def is_test(rehearsal: Rehearsal) -> Iterator[Finding]:
    """By the error of launch."""
    error = rehearsal.plan['error']
    if error is not None and (error.get('facts') or {}).get('about') == 'launch.test-description':
        yield found('file', os.path.basename(rehearsal.plan['file']), **_place(error))


def _first(pattern: re.Pattern[str], text: str) -> str | None:
    said = pattern.search(text)
    return None if said is None else said[1]


def _is_of_others(module: str) -> bool:
    """Whether a module is neither one of launch, nor nearly one."""
    from edulaunch.advice.errors.launch_files import misspelt

    return misspelt(module) is None


def _kind(package: str | None, module: str | None) -> str | None:
    from edulaunch.engine.packages.absent import absent_kind, absent_module_kind

    return absent_kind(package) if package else absent_module_kind((module or '').partition('.')[0])


def _place(error: dict[str, Any]) -> dict[str, Any]:
    file, _, line = (error.get('origin') or '').rpartition(':')
    return {'file': file or None, 'line': int(line) if line.isdigit() else None}

"""Rules about correct launch files that cannot run here, because an argument, a package or a module is missing, or because they
are launch tests.
"""

from __future__ import annotations

import linecache
import os
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.errors.launch_files import IS_TEST, NOT_STARTED, RUN_TEST, misspelt
from edulaunch.advice.errors.missing_values import MODELS
from edulaunch.advice.rule import Finding, found, rule
from edulaunch.engine.packages.absent import absent_kind, absent_module_kind

if TYPE_CHECKING:
    from edulaunch.advice.plan import Rehearsal

_PACKAGE = re.compile(r"package '([\w-]+)' not found")
_MODULE = re.compile(r"No module named '([\w.]+)'")
_ARGUMENT = re.compile(r"missing required argument '(.*?)' .*given: \[\]", re.DOTALL)
_ELEMENT = re.compile(r'Unrecognized entity of the type: (\w+)')
_ELEMENTS = {'gz_server': 'ros_gz_sim', 'gz_spawn_model': 'ros_gz_sim', 'ros_gz_bridge': 'ros_gz_bridge'}
"""Elements of XML and YAML that a package adds to launch, with the package."""
_VARIABLE = re.compile(r"environment variable '(\w+)' does not exist")
_LEGACY = re.compile(r"cannot import name '(\w+)' from 'launch_testing.legacy'")
_REFUSED = re.compile(r"not done in a dry run: '(.+?)'")
_KEY = re.compile(r"KeyError: '(\w+)'")
_ABOUT = (
    None,
    'packages.unknown',
    'packages.absent-package',
    'packages.absent-file',
    'packages.absent-module',
    'packages.made-by-build',
    'packages.no-executable',
)
"""Rules about errors whose subject belongs to other packages."""


@rule(
    'launch.needs-elsewhere',
    what=(
        'this launch file needs the package {package} ({belongs_to}), which is not part of edulaunch',
        'this launch file needs the package {package}, which is not in this workspace',
        'this launch file needs the module {module} ({belongs_to}), which is not part of edulaunch',
        'this launch file needs the module {module}, which is not in this workspace',
        'this launch file needs {made}, which a build creates from {template}',
        'this launch file needs the program {executable}, which a build creates with {unread} in CMakeLists.txt',
    ),
    why='edulaunch cannot check the rest of a launch file that stops at this line',
    do='use --workspace DIR to name the workspace that contains it, or run the file on a computer where it is installed',
    level='info',
    hides=('launch.fails', 'launch.unknown-element'),
)
def needs_elsewhere(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a package or module that does not exist here, unless its name resembles the name of an existing package or
    module.
    """
    error = rehearsal.plan['error']
    facts: dict[str, Any] = (error or {}).get('facts') or {}
    brought = None if error is None else _ELEMENTS.get(_first(_ELEMENT, error['text']) or '')
    if error is not None and brought is not None:
        yield found('file', rehearsal.plan['file'], **_place(error), package=brought, belongs_to=_kind(brought, None))
        return
    if error is None or facts.get('about') not in _ABOUT or facts.get('near') or facts.get('file_beside'):
        return
    if facts.get('about') == 'packages.made-by-build':
        yield found('file', rehearsal.plan['file'], **_place(error), made=facts['made'], template=facts['template'])
        return
    if facts.get('about') == 'packages.no-executable':
        if facts.get('unread'):
            program = {'executable': facts['executable'], 'unread': facts['unread']}
            yield found('file', rehearsal.plan['file'], **_place(error), **program)
        return
    package = facts.get('package') or _first(_PACKAGE, error['text'])
    module = None if package else facts.get('module') or _first(_MODULE, error['text'])
    if package or module and _is_of_others(module):
        kind = facts.get('belongs_to') or _kind(package, module)
        yield found('file', rehearsal.plan['file'], **_place(error), package=package, module=module, belongs_to=kind)


@rule(
    'launch.needs-argument',
    what="this launch file requires the argument '{argument}'",
    why='the argument has no default, so you must pass a value when you launch the file',
    do='pass a value: {argument}:=...',
    level='info',
    hides=('launch.fails',),
)
def needs_argument(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a required argument of the launch file itself, if the user has given no argument."""
    error = rehearsal.plan['error']
    needed = None if error is None or rehearsal.plan['given'] else _first(_ARGUMENT, error['text'])
    if needed is not None and any(one['name'] == needed for one in rehearsal.plan['arguments']):
        yield found('file', rehearsal.plan['file'], file=rehearsal.plan['file'], argument=needed)


@rule(
    'launch.needs-keyboard',
    what='this launch file waits for keyboard input, but this check has no keyboard',
    why='input() raises EOFError when there is no keyboard',
    do='run the file in a terminal, or replace the question with a launch argument',
    level='info',
    hides=('launch.fails',),
)
def needs_keyboard(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a launch file that calls input()."""
    error = rehearsal.plan['error']
    if error is not None and 'EOF when reading a line' in error['text']:
        yield found('file', rehearsal.plan['file'], **_place(error))


@rule(
    'launch.needs-variable',
    what="this launch file needs the environment variable '{variable}', which is not set in this terminal",
    why='a launch file cannot read a variable that is not set, unless it has a default value',
    do=(
        'run `export {variable}={example}`, and launch the file again',
        'run `export {variable}=...` with the value that the file expects, and launch the file again',
    ),
    level='info',
    hides=('launch.fails',),
)
def needs_variable(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a missing environment variable that a launch file needs.

    The launch file reads it with EnvironmentVariable without a default, or with os.environ['NAME'].
    """
    error = rehearsal.plan['error']
    if error is None or (error.get('facts') or {}).get('near'):
        return
    place = _place(error)
    line = linecache.getline(str(place['file'] or ''), place['line'] or 0)
    by_key = _first(_KEY, error['text']) if 'environ' in line else None
    variable = by_key or _first(_VARIABLE, error['text'])
    if variable is not None:
        yield found('file', rehearsal.plan['file'], **place, variable=variable, example=MODELS.get(variable))


@rule(
    'launch.is-test',
    what=('this file is a launch test that starts itself, with {legacy} of launch_testing.legacy', IS_TEST),
    why=NOT_STARTED,
    do=('run it where launch_testing is installed: python3 {script}', RUN_TEST),
    level='info',
    hides=('launch.fails',),
)
def is_test(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a launch test that was run as a launch file. The error message of launch shows that."""
    error = rehearsal.plan['error']
    legacy = None if error is None else _first(_LEGACY, error['text'])
    if error is not None and (legacy or (error.get('facts') or {}).get('about') == 'launch.test-description'):
        name = os.path.basename(rehearsal.plan['file'])
        yield found('file', name, **_place(error), legacy=legacy, script=name if legacy else None)


@rule(
    'launch.not-in-dry-run',
    what='the dry run stops at this line, which would {undone}',
    why='a dry run changes no files and starts no programs, so edulaunch cannot check the lines that follow',
    do='launch the file to see the rest: ros2 launch {file}',
    level='info',
    hides=('launch.fails',),
)
def not_in_dry_run(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a change that a library tried to make, and that the dry run refused. Changes by the launch file itself are not
    reported.

    The library may have raised another exception with the same message.
    """
    error = rehearsal.plan['error']
    facts: dict[str, Any] = (error or {}).get('facts') or {}
    path = _first(_REFUSED, error['text']) if error is not None else None
    undone = facts['undone'] if facts.get('about') == 'launch.not-in-dry-run' else path and f'write {os.path.basename(path)}'
    if error is not None and undone:
        yield found('file', os.path.basename(rehearsal.plan['file']), **_place(error), undone=undone)


def _first(pattern: re.Pattern[str], text: str) -> str | None:
    match = pattern.search(text)
    return None if match is None else match[1]


def _is_of_others(module: str) -> bool:
    """Return whether a module does not belong to launch, and its name is not a misspelling of a module of launch."""
    return misspelt(module) is None


def _kind(package: str | None, module: str | None) -> str | None:
    return absent_kind(package) if package else absent_module_kind((module or '').partition('.')[0])


def _place(error: dict[str, Any]) -> dict[str, Any]:
    file, _, line = (error.get('origin') or '').rpartition(':')
    return {'file': file or None, 'line': int(line) if line.isdigit() else None}

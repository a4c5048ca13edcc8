"""Names and modules in Python launch files."""

from __future__ import annotations

import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import speak
from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding
from edulaunch.advice.launch_names import MODULES, home_of, import_line, names_in, nearest_anywhere
from edulaunch.advice.rule import rule
from edulaunch.nearest import nearest
from edulaunch.packages.absent import absent_module_kind

_NOT_IN = re.compile(r"cannot import name '(?P<name>\w+)' from '(?P<module>[\w.]+)'")
_NO_ATTRIBUTE = re.compile(r"(?:partially initialized )?module '(?P<module>[\w.]+)' has no attribute '(?P<name>\w+)'")


@rule(
    'launch.import-name',
    what='{module} has no {missing}',
    do=('write: {line}', 'look into the documentation of {module} for the name that you mean'),
    level='error',
    lesson='01_first_launch',
)
def import_name(failure: Failure) -> Iterator[Finding]:
    """A name that lives in another module of launch, or is misspelt."""
    said = _NOT_IN.match(failure.message) or _NO_ATTRIBUTE.match(failure.message)
    if said is None or failure.process is not None or said['module'].partition('.')[0] not in ('launch', 'launch_ros'):
        return
    name, module = said['name'], said['module']
    near = name if home_of(name) else nearest(name, names_in(module)) or nearest_anywhere(name)
    yield speak(failure, module=module, missing=name, line=import_line(near))


@rule(
    'launch.relative-import',
    what='a launch file belongs to no package, so an import with a leading dot finds nothing',
    do='put the shared code into your Python package, and write: from my_package.module import ...',
    level='error',
)
def relative_import(failure: Failure) -> Iterator[Finding]:
    """`from .other import x`."""
    if failure.process is None and failure.message.startswith('attempted relative import'):
        yield speak(failure)


@rule(
    'launch.no-module',
    what=(
        'the module {absent} ({belongs_to}) is not part of edulaunch',
        "{file_beside} lies beside the launch file, and a launch file's own folder is not searched",
        'there is no module {wanted_module}',
    ),
    do=(
        'write: from {near} import ...',
        'move {file_beside} into your Python package, and import it from there',
        'try this launch file on a machine that has {absent}',
        'go to its workspace, or name that with --workspace DIR; if it is not yours, try: pip install {module}',
    ),
    level='error',
)
def no_module(failure: Failure) -> Iterator[Finding]:
    """A module that the launch file imports."""
    said = re.match(r"No module named '([\w.]+)'", failure.message)
    if said is None or failure.process is not None:
        return
    top = said[1].partition('.')[0]
    kind, beside = absent_module_kind(top), failure.facts.get('file_beside')
    near = None if kind or beside else nearest(said[1], MODULES)
    yield speak(failure, wanted_module=said[1], module=top, absent=top if kind else None, belongs_to=kind, near=near)


@rule(
    'launch.unknown-name',
    what=(
        'the text {bare} stands bare in a PythonExpression, so Python takes it for a name',
        'the name {missing} is not known here',
    ),
    do=(
        "put quotes around the substitution, as in [\"'\", LaunchConfiguration('x'), \"' == '{bare}'\"]",
        'write {python}',
        'add the line: {line}',
        'write {near}, and add the line: {near_line}',
        'look whether it is spelled as where it is made',
    ),
    level='error',
)
def unknown_name(failure: Failure) -> Iterator[Finding]:
    """A name without an import, misspelt, or from another language."""
    said = re.match(r"name '(\w+)' is not defined", failure.message)
    if said is None or failure.process is not None:
        return
    name = said[1]
    bare = name if failure.facts.get('expression') else None
    python = {'true': 'True', 'false': 'False', 'null': 'None', 'none': 'None'}.get(name)
    line = import_line(name)
    near = None if bare or python or line else nearest_anywhere(name)
    yield speak(failure, missing=name, bare=bare, python=python, line=line, near=near, near_line=import_line(near))


@rule(
    'launch.expression',
    what='Python cannot work out this PythonExpression: {expression}',
    do='look at the quotes and spaces where its parts meet',
    level='error',
)
def expression(failure: Failure) -> Iterator[Finding]:
    """A PythonExpression that is no Python once its parts are put together."""
    if failure.facts.get('expression') and failure.type in ('SyntaxError', 'TypeError'):
        yield speak(failure)

"""Rules about strings that programs do not receive as intended, and about launch files that fail in the dry run."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.outlines import branches, place_of
from edulaunch.advice.rule import Finding, found, rule

if TYPE_CHECKING:
    from edulaunch.advice.plan import Rehearsal

LESSON = '01_first_launch'
_OBJECT = re.compile(r'<launch(?:_ros)?\.substitutions\.[\w.]*?(\w+) object at')
_DOLLAR = re.compile(r'\$\((?:var|arg|env|find-pkg-share|dirname|eval)\b[^)]*\)?')


@rule(
    'launch.substitution-as-text',
    what='this value contains a {substitution} that Python converted to a string: it starts with "{shown}"',
    why='a substitution has no value until launch runs, so an f-string or str() returns only a description of the object',
    do="write a list such as ['robot_', LaunchConfiguration('name')]; launch joins its parts",
    lesson=LESSON,
    level='error',
)
def substitution_as_text(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report a string that contains the `repr` of a substitution."""
    for branch in branches(rehearsal):
        match = next(filter(None, map(_OBJECT.search, _texts(branch.item))), None)
        if match is not None and branch.origin is not None:
            yield found('substitution', match[1], **place_of(branch), shown=match.string[:40])


@rule(
    'launch.dollar-in-python',
    what='{text} is not replaced, because this launch file is written in Python',
    why='$(...) is syntax of XML and YAML launch files, and an ordinary string in Python',
    do=(
        "write LaunchConfiguration('{argument}')",
        'write a substitution such as EnvironmentVariable(...) or FindPackageShare(...)',
    ),
    lesson=LESSON,
    level='error',
)
def dollar_in_python(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report `$(...)` that a Python launch file passes to a node or a program. Parameter files may contain it."""
    for branch in branches(rehearsal):
        if branch.origin is None or not branch.origin.file.endswith('.py'):
            continue
        item = dict(branch.item or {})
        if item.get('shell'):
            continue
        if item.get('kind') == 'node':
            parameters = {one.name: one.value for one in branch.action.given_parameters() if not one.is_of_a_file}
            item = {'arguments': item['arguments'], 'remappings': item['remappings'], 'parameters': parameters}
        words = [text for text in _texts(item) if '\n' not in text]  # the text of a file is not written here
        match = next(filter(None, map(_DOLLAR.search, words)), None)
        if match is not None:
            word = match[0].strip('$()').split()
            argument = word[1] if word[0] in ('var', 'arg') and len(word) > 1 else None
            yield found('text', match[0], **place_of(branch), argument=argument)


def _texts(value: Any) -> Iterator[str]:
    """Yield all strings in nested plain data."""
    if isinstance(value, str):
        yield value
    elif isinstance(value, dict):
        for item in value.values():
            yield from _texts(item)
    elif isinstance(value, (list, tuple)):
        for item in value:
            yield from _texts(item)


@rule(
    'launch.fails',
    what='launch cannot run this file: {text}',
    do=('{help}', 'create the file {missing}, or correct its path', 'check this line and the line before it'),
    level='error',
)
def fails(rehearsal: Rehearsal) -> Iterator[Finding]:
    """Report the error of a dry run with the message of ROS 2. The judge prefers other findings that explain the error."""
    error = rehearsal.plan['error']
    if error is not None:
        file, _, line = (error.get('origin') or '').rpartition(':')
        missing = re.search(r"No such file or directory: '([^']+)'", error['text'])
        yield found(
            'file',
            rehearsal.plan['file'],
            file=file or rehearsal.plan['file'],
            line=int(line) if line.isdigit() else None,
            text=_telling_line(error['text']),
            help=error.get('help'),
            missing=missing and missing[1],
        )


def _telling_line(text: str) -> str:
    """Return the line of an error message that names the cause. ROS 2 prints this line below a heading."""
    lines = [line.strip(' -') for line in text.splitlines() if line.strip()]
    return next((line for line in lines if not line.endswith(':')), text)

"""Rules about small mistakes in programs that are valid Python: a missing f, swapped arguments, and a call that blocks."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import name_of_call, program_scripts, walked
from edulaunch.advice.runs import own_nodes

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LOGGING = ('debug', 'info', 'warn', 'warning', 'error', 'fatal', 'print')
_FORMAT = r'(?:.?[<>=^])?[-+ ]?#?0?\d*[_,]?(?:\.\d+)?[bcdeEfFgGnosxX%]?'
_FIELD = re.compile(r'\{([A-Za-z_][\w.]*(?:\[\w\'"]+\]|\(\))?)(?:![rsa])?(?::' + _FORMAT + r')?\}')
_X, _Y = re.compile(r'(?:^|[._]|d|delta|diff)x(?:_?\w*)?$'), re.compile(r'(?:^|[._]|d|delta|diff)y(?:_?\w*)?$')


@rule(
    'programs.f-forgotten',
    what="this line prints '{field}' as it is written, because the string has no f before it",
    why='Python replaces {field} with a value only in an f-string',
    do='write f before the string: f{written}',
    lesson='00_python',
    level='error',
)
def f_forgotten(recording: Recording) -> Iterator[Finding]:
    """Report a string with a name in braces that a program prints or logs, if the output contains the braces."""
    shown: str | None = None
    for file, tree in program_scripts(recording):
        for call in walked(tree):
            first = call.args[0] if isinstance(call, ast.Call) and name_of_call(call) in LOGGING and call.args else None
            if isinstance(first, ast.Constant) and isinstance(first.value, str):
                match = _FIELD.search(first.value)
                if match is not None and _is_known(tree, match[1]):
                    shown = ''.join(row.text for row in recording.output) if shown is None else shown
                    if first.value.partition('\n')[0] in shown:
                        facts: dict[str, Any] = {'field': match[0], 'written': ast.unparse(first)}
                        yield found('text', match[0], file=file, line=first.lineno, **facts)


def _is_known(tree: ast.Module, written: str) -> bool:
    """Return whether a program has a variable, a parameter or an attribute of `self` with the name in the braces."""
    top, _, rest = written.partition('.')
    name = re.match(r'\w+', rest if top == 'self' else top)
    return name is not None and any(
        (isinstance(node, ast.Name) and node.id == name[0])
        or (isinstance(node, ast.arg) and node.arg == name[0])
        or (isinstance(node, ast.Attribute) and node.attr == name[0])
        for node in walked(tree)
    )


@rule(
    'programs.atan2-swapped',
    what='{written} has the difference in x as its first argument',
    why='the first argument of atan2 is the difference in y, and the second one is the difference in x',
    do='write math.atan2({second}, {first})',
    lesson='10_carrots',
    confidence='asked',
    hides=('turtlesim.wall',),
)
def atan2_swapped(recording: Recording) -> Iterator[Finding]:
    """Report a call of atan2 if the names in its first argument contain x, and the names in its second argument contain y."""
    for file, tree in program_scripts(recording):
        for call in walked(tree):
            if isinstance(call, ast.Call) and name_of_call(call) == 'atan2' and len(call.args) == 2:
                first, second = map(ast.unparse, call.args)
                if _axis(call.args[0]) == 'x' and _axis(call.args[1]) == 'y':
                    facts: dict[str, Any] = {'written': ast.unparse(call), 'first': first, 'second': second}
                    yield found('function', 'atan2', file=file, line=call.lineno, **facts)


def _axis(node: ast.expr) -> str | None:
    """Return 'x' or 'y' if all names in an expression stand for this axis, otherwise None."""
    names = [
        one.attr if isinstance(one, ast.Attribute) else one.id
        for one in ast.walk(node)
        if isinstance(one, (ast.Attribute, ast.Name))
    ]
    named = [name.lower() for name in names if name != 'self']
    axes = {'x' if _X.search(name) else 'y' if _Y.search(name) else '' for name in named}
    return axes.pop() if len(axes - {''}) == 1 and '' not in axes else next(iter(axes - {''}), None) if len(axes) == 2 else None


@rule(
    'programs.call-in-constructor',
    what='{node} waits forever in {written}, because its constructor runs before the node spins',
    why='call() returns when the reply has arrived, and a node receives replies only while it spins',
    do='write self.future = {client}.call_async(...) here, and then self.future.add_done_callback(self.on_answer)',
    lesson='14_services',
    level='error',
    hides=('messages.reply-not-taken', 'programs.never-spun'),
)
def call_in_constructor(recording: Recording) -> Iterator[Finding]:
    """Report call() in the constructor of a node, if the reply arrived but the client never read it."""
    waiting = {fact.data['node'] for fact in recording.facts if fact.kind == 'reply waits'} & own_nodes(recording)
    for file, tree in program_scripts(recording) if waiting else ():
        for method in walked(tree):
            for call in ast.walk(method) if isinstance(method, ast.FunctionDef) and method.name == '__init__' else ():
                if isinstance(call, ast.Call) and isinstance(call.func, ast.Attribute) and call.func.attr == 'call':
                    node = sorted(waiting)[0]
                    facts: dict[str, Any] = {'written': f'{ast.unparse(call.func)}()', 'client': ast.unparse(call.func.value)}
                    yield found('node', node, file=file, line=call.lineno, **facts)

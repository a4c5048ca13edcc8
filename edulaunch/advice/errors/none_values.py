"""Rules about missing values: data of a callback that has not run yet, and functions without a return value."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import NamedTuple

from edulaunch.advice.errors.about import report
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.advice.run_sources import name_of_call, script_of

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef)
_IS_NONE = re.compile(
    r"'NoneType' object (?:has no attribute '(\w+)'|is not subscriptable|is not iterable)|"
    r"unsupported operand type\(s\) for .*'NoneType'|"
    r"'[<>]=?' not supported between instances of .*'NoneType'|"
    r'must be real number, not NoneType|object of type .NoneType. has no len'
)
"""Messages of Python about None where a value is needed. The group is the attribute that was read."""


class _Failed(NamedTuple):
    """The syntax tree of the failed program, the function with the failing line, and the expressions there that may be None."""

    tree: ast.Module
    function: ast.AST
    candidates: list[ast.expr]


def _failed(failure: Failure) -> _Failed | None:
    match = _IS_NONE.match(failure.message)
    tree = script_of(failure.file) if match is not None and failure.process is not None else None
    if match is None or tree is None:
        return None
    line = failure.line or 0
    inside = [node for node in ast.walk(tree) if isinstance(node, FUNCTIONS) and node.lineno <= line <= (node.end_lineno or 0)]
    nodes = [node for node in ast.walk(tree) if isinstance(node, ast.expr) and node.lineno <= line <= (node.end_lineno or 0)]
    if match[1]:
        candidates = [node.value for node in nodes if isinstance(node, ast.Attribute) and node.attr == match[1]]
    elif 'subscriptable' in match[0]:
        candidates = [node.value for node in nodes if isinstance(node, ast.Subscript)]
    else:
        candidates = nodes
    return _Failed(tree, inside[-1] if inside else tree, candidates)


def _stores(tree: ast.AST, written: str) -> list[ast.Assign | ast.AnnAssign]:
    """Return the assignments to a variable or attribute, which is given as source code."""
    return [
        node
        for node in ast.walk(tree)
        if isinstance(node, (ast.Assign, ast.AnnAssign))
        for target in (node.targets if isinstance(node, ast.Assign) else [node.target])
        if ast.unparse(target) == written
    ]


@rule(
    'programs.not-yet-stored',
    what='{value} has no value in this line yet, only None, because {method}() has not stored one',
    why='this line runs before the first call of {method}(), for example before the first message arrives',
    do='write `if {value} is None: return` before this line',
    lesson='09_broadcaster_and_listener',
    level='error',
)
def not_yet_stored(failure: Failure) -> Iterator[Finding]:
    """Report a variable or attribute that begins with the value None, and to which only another function assigns a value."""
    failed = _failed(failure)
    for node in [] if failed is None else failed.candidates:
        written = ast.unparse(node)
        if failed is None or not isinstance(node, (ast.Name, ast.Attribute)):
            continue
        stores = _stores(failed.tree, written)
        begins = any(isinstance(one.value, ast.Constant) and one.value.value is None for one in stores)
        setters = [
            function.name
            for function in ast.walk(failed.tree)
            if isinstance(function, FUNCTIONS) and function is not failed.function
            for one in _stores(function, written)
            if one.value is not None and not isinstance(one.value, ast.Constant)
        ]
        if begins and setters:
            yield report(failure, value=written, method=setters[0])
            return


@rule(
    'programs.no-return-value',
    what='{function}() on line {made} returns no value, so this line gets None from it',
    why='without a return statement, a function in Python returns None',
    do='end {function}() with a line such as `return {value}`',
    lesson='00_python',
    level='error',
)
def no_return_value(failure: Failure) -> Iterator[Finding]:
    """Report the use of a function's result if the function is in the same file and has no `return` with a value."""
    failed = _failed(failure)
    for node in [] if failed is None else failed.candidates:
        if failed is None:
            return
        called = node
        if isinstance(node, (ast.Name, ast.Attribute)):
            stores = _stores(failed.function if isinstance(node, ast.Name) else failed.tree, ast.unparse(node))
            called = stores[-1].value if stores and stores[-1].value is not None else node
        name = name_of_call(called)
        for function in ast.walk(failed.tree) if name else ():
            if isinstance(function, FUNCTIONS) and function.name == name and not _returns(function):
                yield report(failure, function=name, made=function.lineno, value=_last_value(function))
                return


@rule(
    'programs.loop-in-callback',
    what='this loop in {callback}() never ends, because no other callback runs before {callback}() returns',
    why='the node runs one callback at a time, so nothing changes the values that the loop checks',
    do='write `if` in place of `while`, so that each call of {callback}() does one step; rclpy calls it again',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('programs.runaway', 'programs.callback-goes-on'),
)
def loop_in_callback(failure: Failure) -> Iterator[Finding]:
    """Report a `while` loop without a wait in a method that the program passes as a callback."""
    tree = script_of(failure.file) if failure.type == 'RunawayProgramError' and failure.process is not None else None
    line = failure.line or 0
    nodes = [] if tree is None else list(ast.walk(tree))
    loops = [one for one in nodes if isinstance(one, ast.While) and one.lineno <= line <= (one.end_lineno or 0)]
    methods = [one for one in nodes if isinstance(one, FUNCTIONS) and loops and one.lineno < line <= (one.end_lineno or 0)]
    passed = {
        word.attr
        for call in nodes
        if isinstance(call, ast.Call) and name_of_call(call).startswith('create_')
        for word in [*call.args, *(keyword.value for keyword in call.keywords)]
        if isinstance(word, ast.Attribute)
    }
    for method in methods[-1:]:
        if method.name in passed:
            yield report(failure._replace(line=loops[-1].lineno), callback=method.name)


def _returns(function: ast.FunctionDef | ast.AsyncFunctionDef) -> bool:
    return any(
        isinstance(node, (ast.Yield, ast.YieldFrom)) or (isinstance(node, ast.Return) and node.value is not None)
        for node in ast.walk(function)
    )


def _last_value(function: ast.FunctionDef | ast.AsyncFunctionDef) -> str:
    """Return the variable that a function assigns last, which is probably meant to be its result."""
    targets = [target for node in ast.walk(function) if isinstance(node, ast.Assign) for target in node.targets]
    targets.sort(key=lambda target: target.lineno)
    return ast.unparse(targets[-1]) if targets else 'value'

"""Rules about Python code that runs when launch loads the file, although it should run later.

The rules do not execute the code.
"""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import Script, name_of_call, walked

LESSON = '04_conditions'
ACTIONS = frozenset(
    (
        'ComposableNodeContainer',
        'DeclareLaunchArgument',
        'ExecuteProcess',
        'GroupAction',
        'IncludeLaunchDescription',
        'LifecycleNode',
        'LogInfo',
        'Node',
        'OpaqueFunction',
        'RegisterEventHandler',
        'SetEnvironmentVariable',
        'SetParameter',
        'TimerAction',
    )
)
Function = ast.FunctionDef | ast.AsyncFunctionDef | ast.Module


@rule(
    'launch.python-if',
    what='"{text}" tests the substitution object instead of its value, so the result is always {outcome}',
    why='Python runs this line before launch knows the arguments',
    do=(
        'get the value with {asked}.perform({context})',
        "add a condition to the action: condition=IfCondition(EqualsSubstitution(LaunchConfiguration('{argument}'), {value}))",
        "add a condition to the action: condition=IfCondition(LaunchConfiguration('{argument}'))",
        'add a condition to the action: condition=IfCondition(...)',
    ),
    lesson=LESSON,
    level='error',
)
def python_if(scripts: list[Script]) -> Iterator[Finding]:
    """Report an `if` that tests a LaunchConfiguration, or a variable that contains one.

    `.perform(context)` returns a string, so a script may compare its result.
    """
    for file, tree in scripts:
        for function in _functions(tree):
            known = _configurations(function)
            for test in _tests(function):
                yield from (_in_function(finding, function) for finding in _asked(test, known, file))


@rule(
    'launch.condition-compared',
    what='{condition} gets {outcome}, because "{text}" compares the substitution object itself, and not its value',
    why='Python runs this line before launch knows the arguments',
    do='write {condition}({comparison}({asked}, {value})), and import {comparison} from launch.substitutions',
    lesson=LESSON,
    level='error',
    hides=('launch.not-a-text', 'launch.fails', 'launch.condition-value', 'launch.condition-object', 'launch.python-if'),
)
def condition_compared(scripts: list[Script]) -> Iterator[Finding]:
    """Report a condition such as `IfCondition(LaunchConfiguration('mode') == 'sim')`."""
    for file, tree in scripts:
        for function in _functions(tree):
            known = _configurations(function)
            for call in _own(function):
                if isinstance(call, ast.Call) and name_of_call(call) in ('IfCondition', 'UnlessCondition') and call.args:
                    for finding in _asked(call.args[0], known, file) if isinstance(call.args[0], ast.Compare) else ():
                        is_equal = finding.facts['outcome'] == 'False'
                        comparison = 'EqualsSubstitution' if is_equal else 'NotEqualsSubstitution'
                        facts = {**finding.facts, 'condition': name_of_call(call), 'comparison': comparison}
                        yield finding._replace(facts=facts)


def _in_function(finding: Finding, function: Function) -> Finding:
    """Return a finding.

    If launch calls the function with its context, add the fact `context`, so that the advice names `perform`.
    """
    arguments = [] if isinstance(function, ast.Module) else function.args.args
    if not arguments or arguments[0].arg != 'context':
        return finding
    return finding._replace(facts={**finding.facts, 'context': arguments[0].arg})


def _asked(test: ast.expr, known: dict[str, str | None], file: str) -> Iterator[Finding]:
    if isinstance(test, ast.Compare) and len(test.ops) == 1:
        operator, other = test.ops[0], test.comparators[0]
        if (
            isinstance(operator, (ast.Eq, ast.NotEq))
            and _is_configuration(test.left, known)
            and not _is_configuration(other, known)
        ):
            outcome = isinstance(operator, ast.NotEq)
            name = _argument(test.left, known)
            value = ast.unparse(other)
            text = ast.unparse(test)
            facts: dict[str, Any] = {'argument': name, 'value': value, 'asked': ast.unparse(test.left)}
            yield found('text', text, file=file, line=test.lineno, outcome=str(outcome), **facts)
        return
    is_not = isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not)
    inner = test.operand if isinstance(test, ast.UnaryOp) and is_not else test
    if _is_configuration(inner, known):
        name = _argument(inner, known)
        yield found(
            'text',
            ast.unparse(test),
            file=file,
            line=test.lineno,
            outcome=str(not is_not),
            argument=name,
            asked=ast.unparse(inner),
        )


def _functions(tree: ast.Module) -> Iterator[Function]:
    yield from (node for node in walked(tree) if isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.Module)))


def _own(function: Function) -> Iterator[ast.AST]:
    """Yield all syntax nodes of a function, without the nodes of nested functions and classes."""
    todo: list[ast.AST] = list(function.body)
    while todo:
        node = todo.pop()
        yield node
        if not isinstance(node, (ast.FunctionDef, ast.AsyncFunctionDef, ast.ClassDef, ast.Lambda)):
            todo += ast.iter_child_nodes(node)


def _tests(function: Function) -> Iterator[ast.expr]:
    """Yield the parts of the condition of each `if` statement and each conditional expression."""
    for node in _own(function):
        if isinstance(node, (ast.If, ast.IfExp)):
            yield from node.test.values if isinstance(node.test, ast.BoolOp) else (node.test,)


def _configurations(function: Function) -> dict[str, str | None]:
    """Return the variables that always contain a LaunchConfiguration. The value is the name of the argument, if it is literal."""
    found: dict[str, str | None] = {}
    others: set[str] = set()
    for node in _own(function):
        if isinstance(node, ast.Assign):
            for target in node.targets:
                if isinstance(target, ast.Name) and _is_call(node.value):
                    found[target.id] = _first_text(node.value)
                else:
                    others |= {name.id for name in ast.walk(target) if isinstance(name, ast.Name)}
    return {name: argument for name, argument in found.items() if name not in others}


def _is_call(node: ast.AST) -> bool:
    return isinstance(node, ast.Call) and isinstance(node.func, ast.Name) and node.func.id == 'LaunchConfiguration'


def _first_text(call: ast.AST) -> str | None:
    words = call.args[:1] if isinstance(call, ast.Call) else []
    return words[0].value if words and isinstance(words[0], ast.Constant) and isinstance(words[0].value, str) else None


def _is_configuration(node: ast.AST, known: dict[str, str | None]) -> bool:
    return _is_call(node) or (isinstance(node, ast.Name) and node.id in known)


def _argument(node: ast.AST, known: dict[str, str | None]) -> str | None:
    return known[node.id] if isinstance(node, ast.Name) else _first_text(node)


EXECUTES = ('add_action', 'emit_event_sync', 'execute', 'visit')
"""Methods with which a function runs an action that it does not return. Launch also runs an action that is added to the list of a
launch description while it goes through that list.
"""


@rule(
    'launch.opaque-returns-nothing',
    what='{function}() creates a {action} but returns nothing, so launch does not execute this {action}',
    why='launch runs only the actions that the function of an OpaqueFunction returns',
    do='return a list of the actions at the end of {function}()',
    lesson='13_large_project',
    level='error',
)
def opaque_returns_nothing(scripts: list[Script]) -> Iterator[Finding]:
    """Report a function for OpaqueFunction that creates an action and returns no value."""
    for file, tree in scripts:
        named = {
            node.value.id
            for node in walked(tree)
            if isinstance(node, ast.keyword) and node.arg == 'function' and isinstance(node.value, ast.Name)
        }
        for function in _functions(tree):
            if isinstance(function, ast.Module) or function.name not in named:
                continue
            own = list(_own(function))
            made = [node.func.id for node in own if isinstance(node, ast.Call) and isinstance(node.func, ast.Name)]
            has_value = any(isinstance(node, ast.Return) and node.value is not None for node in own)
            is_executed = any(isinstance(node, ast.Attribute) and node.attr in EXECUTES for node in own)
            actions = [name for name in made if name in ('Node', 'ExecuteProcess', 'IncludeLaunchDescription', 'GroupAction')]
            if (
                actions
                and not has_value
                and not is_executed
                and not any(isinstance(node, (ast.Yield, ast.YieldFrom)) for node in own)
            ):
                yield found('function', function.name, file=file, line=function.lineno, action=actions[0])


@rule(
    'launch.not-added',
    what='the {action} {variable} is never added to the launch description, so launch does not run it',
    why='launch runs only the actions in the list of LaunchDescription([...]), or that add_action() adds',
    do=(
        'write {description}.add_action({variable}), or remove {variable} if it should not run',
        'add {variable} to the list of LaunchDescription([...]), or remove {variable} if it should not run',
    ),
    lesson='01_first_launch',
    level='error',
)
def not_added(scripts: list[Script]) -> Iterator[Finding]:
    """Report a variable of generate_launch_description() that contains an action, but that no line reads."""
    for file, tree in scripts:
        for function in _functions(tree):
            if isinstance(function, ast.Module) or function.name != 'generate_launch_description':
                continue
            names = [node for node in ast.walk(function) if isinstance(node, ast.Name)]
            read = {node.id for node in names if isinstance(node.ctx, ast.Load)}
            if not read & {'locals', 'globals', 'vars', 'eval', 'exec'}:
                yield from _unread(function, read, file)


def _unread(function: ast.FunctionDef | ast.AsyncFunctionDef, read: set[str], file: str) -> Iterator[Finding]:
    for node in function.body:
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call) and isinstance(node.value.func, ast.Name):
            made, name = node.value.func.id, ast.unparse(node.targets[0])
            is_left = made in ACTIONS and isinstance(node.targets[0], ast.Name) and name not in read
            if is_left and len(node.targets) == 1 and not _is_on_purpose(name, file, function.body):
                yield found('variable', name, file=file, line=node.lineno, action=made, description=_adds(function))


def _adds(function: ast.FunctionDef | ast.AsyncFunctionDef) -> str | None:
    """Return the variable on which a function calls add_action(), or None."""
    called = [node.func for node in ast.walk(function) if isinstance(node, ast.Call)]
    adding = [one.value for one in called if isinstance(one, ast.Attribute) and one.attr == 'add_action']
    return next((one.id for one in adding if isinstance(one, ast.Name)), None)


def _is_on_purpose(name: str, file: str, body: list[ast.stmt]) -> bool:
    """Return whether a comment adds the variable, or a string between the lines names it: the student left it out on purpose."""
    from edulaunch.ros.sources.source_package import read_text

    added, listed = rf'(?:\w+\.add_action\()?{name}\)?,?\s*(?:#.*)?$', rf'.*\bLaunchDescription\(\[.*\b{name}\b'
    strings = [one.value for one in body[1:] if isinstance(one, ast.Expr) and isinstance(one.value, ast.Constant)]
    is_named = any(re.search(rf'\b{name}\b', str(one.value), re.IGNORECASE) for one in strings)
    return is_named or re.search(rf'^\s*#\s*(?:{added}|{listed})', read_text(file), re.MULTILINE) is not None

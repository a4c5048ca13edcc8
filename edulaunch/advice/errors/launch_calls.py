"""Rules about the arguments of actions and substitutions in Python launch files."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from typing import Any

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.launch_names import class_named, keywords_of
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.advice.run_sources import script_of
from edulaunch.engine.nearest import nearest

OLD_KEYWORDS = {
    'node_name': 'name',
    'node_executable': 'executable',
    'node_namespace': 'namespace',
    'pkg': 'package',
    'exec': 'executable',
    'args': 'arguments',
    'params': 'parameters',
    'remap': 'remappings',
    'ns': 'namespace',
    'default': 'default_value',
    'message': 'msg',
    'text': 'msg',
    'delay': 'period',
    'launch_args': 'launch_arguments',
    'command': 'cmd',
    'func': 'function',
}
"""Keyword arguments of ROS 1, of older ROS 2, and of XML, with their current names."""


@rule(
    'launch.keyword',
    what=('{action} has no argument {keyword}=', '{action} has no argument {keyword}=; it accepts {known}'),
    do=('write {near}=', 'use one of these arguments: {known}'),
    level='error',
    lesson='01_first_launch',
    edits=(('{keyword}=', '{near}='),),
)
def keyword(failure: Failure) -> Iterator[Finding]:
    """Report an unknown keyword argument of a constructor."""
    match = re.match(r"(\w+)\.__init__\(\) got an unexpected keyword argument '(\w+)'", failure.message)
    cls = class_named(match[1]) if match is not None else None
    known = failure.facts.get('keywords') or (keywords_of(cls) if cls is not None else [])
    if match is not None and known and failure.process is None:
        action = failure.facts.get('class') or match[1]
        if match[2] in known and cls is not None:  # this action is inside an argument of another action
            action, known = match[1], keywords_of(cls)
        old = OLD_KEYWORDS.get(match[2])
        near = old if old in known else nearest(match[2], known)
        yield report(failure, action=action, keyword=match[2], near=near, known=[f'{name}=' for name in known])


@rule(
    'launch.positional',
    what='{action} does not accept these arguments without names',
    do=('write the name of the argument: {action}({first}=...)', 'put the arguments into one list: {action}([..., ...])'),
    level='error',
)
def positional(failure: Failure) -> Iterator[Finding]:
    """Report positional arguments that a constructor does not accept, as in `LogInfo('hello')`."""
    match = re.match(r'(\w+)\.__init__\(\) takes .*positional arguments? but \d+ .*were given', failure.message)
    cls = class_named(match[1]) if match is not None and failure.process is None else None
    if match is None or cls is None:
        return
    code, lists = cls.__init__.__code__, {'actions', 'initial_entities', 'substitutions'}
    names = code.co_varnames[: code.co_argcount + code.co_kwonlyargcount]
    first = None if lists & set(names) else next(iter(names[code.co_argcount :] or names[1:]), None)
    yield report(failure, action=match[1], first=first)


@rule(
    'launch.function-called',
    what='{function}() is called here, but OpaqueFunction needs the function itself',
    why='launch calls the function later, and passes the context',
    do='write function={function} without parentheses',
    level='error',
    edits=(('function={function}()', 'function={function}'),),
)
def function_called(failure: Failure) -> Iterator[Finding]:
    """Report a function that is called where launch expects the function itself: `OpaqueFunction(function=setup())`."""
    tree = script_of(failure.file) if failure.process is None and 'missing 1 required positional' in failure.message else None
    for node in [] if tree is None else ast.walk(tree):
        value = node.value if isinstance(node, ast.keyword) and node.arg == 'function' else None
        if isinstance(value, ast.Call) and failure.message.startswith(f'{ast.unparse(value.func)}() missing'):
            yield report(failure, function=ast.unparse(value.func))
            return


@rule(
    'launch.component-is-node',
    what='composable_node_descriptions contains a Node, but a container loads only components',
    why='a Node is a program of its own; a component is a class that the container loads from a library',
    do="write ComposableNode(package='...', plugin='package::Class'), and import it from launch_ros.descriptions",
    level='error',
    hides=('launch.fails',),
)
def component_is_node(failure: Failure) -> Iterator[Finding]:
    """Report a Node where a container expects a ComposableNode. The rule reads the file that failed."""
    is_call = failure.process is None and re.match("'NoneType' object is not callable|'Node' object has no", failure.message)
    tree = script_of(failure.file) if is_call else None
    for node in [] if tree is None else ast.walk(tree):
        value = node.value if isinstance(node, ast.keyword) and node.arg == 'composable_node_descriptions' else None
        for item in value.elts if isinstance(value, ast.List) else ():
            if isinstance(item, ast.Call) and ast.unparse(item.func).rpartition('.')[2] == 'Node':
                yield report(failure._replace(line=item.lineno))
                return


@rule(
    'launch.missing-keyword',
    what='{action} needs the argument {needed}=',
    do=('replace {near}= with {needed}=', 'add {needed}=...'),
    level='error',
    lesson='01_first_launch',
    edits=(('{near}=', '{needed}='),),
)
def missing_keyword(failure: Failure) -> Iterator[Finding]:
    """Report a missing argument. Actions pass unknown arguments on to their base class, so Python reports a misspelt argument
    only as a missing argument.
    """
    match = re.match(r"(\w+)\.__init__\(\) missing \d+ required (?:keyword-only|positional) arguments?: '(\w+)'", failure.message)
    cls = class_named(match[1]) if match is not None else None
    if match is not None and cls is not None and failure.process is None:
        known = keywords_of(cls)
        given = [name for name in failure.facts.get('given_names') or () if name not in known]
        yield report(failure, action=match[1], needed=match[2], near=nearest(match[2], given))


@rule(
    'launch.not-a-text',
    what=(
        '{set_of} has a comma between the name and the value of a parameter, so it is not a dictionary',
        '"{compared}" compares the substitution object itself in Python, and not its value',
        '{keyword}={value} is of type {given}, but launch expects strings and substitutions here',
        'launch expects a string here, and this value is of type {given}',
    ),
    do=(
        'write a dictionary, with a colon between name and value: {as_dict}',
        'write {comparison}({asked}, {other}), and import {comparison} from launch.substitutions',
        "write {keyword}='{as_text}'",
        "write '{as_text}'",
        'write {keyword}=str(...) to convert the path to a string',
        'write {as_path} to convert the path to a string',
        "pass each part to {joiner} as one string, and write a file name ending after it: [{joiner}([...]), '.yaml']",
        'remove the inner brackets: {nested}',
        'write a string, or a substitution such as LaunchConfiguration(...)',
    ),
    level='error',
    edits=(('{set_of}', '{as_dict}'), ('{keyword}={value}', "{keyword}='{as_text}'")),
)
def not_a_text(failure: Failure) -> Iterator[Finding]:
    """Report a number, a boolean or a path where launch expects a string.

    In `parameters=`, the mistake is often a set or a pair instead of a dictionary, as in `{'speed', 2.0}`.
    """
    if failure.facts.get('about') != 'launch.not-a-text':
        return
    for node in ast.walk(script_of(failure.file) or ast.Module([], [])):
        items = node.value.elts if isinstance(node, ast.keyword) and isinstance(node.value, ast.List) else []
        for item in items if isinstance(node, ast.keyword) and node.arg == 'parameters' else []:
            if isinstance(item, (ast.Set, ast.Tuple)) and len(item.elts) == 2:
                name, value = map(ast.unparse, item.elts)
                yield report(failure._replace(line=item.lineno), set_of=ast.unparse(item), as_dict=f'{{{name}: {value}}}')
                return
    yield report(failure, **_compared(failure))


def _compared(failure: Failure) -> dict[str, Any]:
    """Return facts about a comparison with == or != in the failing line.

    Its result is a boolean of Python, not a substitution.
    """
    tree = script_of(failure.file) if failure.facts.get('given') == 'bool' else None
    for node in [] if tree is None else ast.walk(tree):
        is_there = isinstance(node, ast.Compare) and node.lineno == failure.line
        if is_there and isinstance(node, ast.Compare) and isinstance(node.ops[0], (ast.Eq, ast.NotEq)):
            name = 'EqualsSubstitution' if isinstance(node.ops[0], ast.Eq) else 'NotEqualsSubstitution'
            asked, other = ast.unparse(node.left), ast.unparse(node.comparators[0])
            return {'compared': ast.unparse(node), 'comparison': name, 'asked': asked, 'other': other}
    return {}


@rule(
    'launch.wrong-type',
    what='the value of {argument}= cannot be of type {given}',
    do=(
        'put the value into a list: {as_list}=[...]',
        'write the number with a decimal point: {argument}={as_float}',
        'put the pair into a list: remappings=[{one_pair}]',
        "write each remapping as a pair in parentheses: ('{pair}', 'to')",
        'pass one of these: {expected}',
    ),
    level='error',
    lesson='01_first_launch',
    edits=(('{argument}={value}', '{argument}={as_float}'),),
)
def wrong_type(failure: Failure) -> Iterator[Finding]:
    """Report an argument that the type check of launch rejects."""
    match = re.search(
        r"xpected '(\w+)' to be one of \[(.*)\], but got '(.*)' of type '<class '(.*)'>'", failure.message, re.DOTALL
    )
    if match is None or failure.process is not None:
        return
    argument, expected, value, given = match.groups()
    is_list = expected in ("<class 'list'>", "<class 'collections.abc.Iterable'>")
    yield report(
        failure,
        argument=argument,
        given=given,
        as_list=argument if is_list else None,
        as_float=f'{value}.0' if given == 'int' and 'float' in expected else None,
        one_pair=_one_pair(failure) if argument == 'remap_rule' else None,
        pair='from' if argument == 'remap_rule' else None,
        expected=re.findall(r"<class '(?:[\w.]+\.)?(\w+)'>", expected),
    )


def _one_pair(failure: Failure) -> str | None:
    """Return the source of the only pair in `remappings=('from', 'to')`, or None."""
    for node in ast.walk(script_of(failure.file) or ast.Module([], [])):
        if isinstance(node, ast.keyword) and node.arg == 'remappings' and isinstance(node.value, ast.Tuple):
            is_pair = [type(word) for word in node.value.elts[:1]] == [ast.Constant]
            return ast.unparse(node.value) if is_pair else None
    return None


NO_PAIRS = about(
    'launch.no-pairs',
    what='launch_arguments needs (name, value) pairs, and this value has a different form',
    do="write {'name': 'value'}.items()".replace('{', '{{').replace('}', '}}'),
)


@rule(
    'launch.not-a-list',
    what='launch expects a list here, not a single {action}',
    do='put it into square brackets: [{action}(...)]',
    level='error',
)
def not_a_list(failure: Failure) -> Iterator[Finding]:
    """Report a single action where launch expects a list."""
    match = re.match(r"'(\w+)' object is not iterable", failure.message)
    cls = class_named(match[1]) if match is not None and failure.process is None else None
    if match is not None and hasattr(cls, 'visit'):
        yield report(failure, action=match[1])


@rule(
    'launch.missing-comma',
    what=(
        '{variable} is a {cls}, not a function, so it cannot be called',
        'a comma is missing after {item}, so Python reads the next brackets as a part of it',
    ),
    do=('remove the parentheses after {variable}', 'put a comma after {item}'),
    level='error',
    confidence='asked',
)
def missing_comma(failure: Failure) -> Iterator[Finding]:
    """Report two items of a list without a comma between them, and a variable that contains an action and is called."""
    match = re.match(r"'(\w+)' object is not (callable|subscriptable)", failure.message)
    if match is None or failure.process is not None:
        return
    cls = class_named(match[1])
    if cls is not None or match[1] in ('dict', 'tuple', 'list', 'str'):
        item = 'the item of the list' if cls is None else f'{match[1]}(...)'
        yield report(failure, item=item, variable=_called_variable(failure, match[1]), cls=match[1])


def _called_variable(failure: Failure, cls: str) -> str | None:
    """Return the variable that contains an object of a class and that the failing line calls, or None."""
    tree = script_of(failure.file) or ast.Module([], [])
    made = {
        target.id
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and isinstance(node.value, ast.Call)
        for target in node.targets
        if isinstance(target, ast.Name) and ast.unparse(node.value.func).rpartition('.')[2] == cls
    }
    calls = (node for node in ast.walk(tree) if isinstance(node, ast.Call) and node.lineno == failure.line)
    return next((node.func.id for node in calls if isinstance(node.func, ast.Name) and node.func.id in made), None)


@rule(
    'launch.not-an-action',
    what='the list of actions contains {given}',
    do=(
        'write RegisterEventHandler({handler}(...)), which is an action',
        'list only actions and launch descriptions: Node(...), LogInfo(...), IncludeLaunchDescription(...)',
    ),
    level='error',
)
def not_an_action(failure: Failure) -> Iterator[Finding]:
    """Report a string, a list or None in the list of a launch description."""
    match = re.match(r"'(\w+)' object has no attribute '(visit|describe_sub_entities)'", failure.message)
    if match is not None and failure.process is None:
        handler = match[1] if match[1].startswith('On') and hasattr(class_named(match[1]), 'handle') else None
        given = 'None' if match[1] == 'NoneType' else f'the event handler {handler}' if handler else f'a {match[1]}'
        yield report(failure, given=given, handler=handler)


@rule(
    'launch.condition-object',
    what='condition= needs a condition, and its value is a {given}',
    do='write IfCondition(...) or UnlessCondition(...) around the value',
    level='error',
    lesson='01_first_launch',
)
def condition_object(failure: Failure) -> Iterator[Finding]:
    """Report an object that is not a condition, as in `condition=LaunchConfiguration('x')`."""
    match = re.match(r"'(\w+)' object has no attribute 'evaluate'", failure.message)
    if match is not None and failure.process is None:
        yield report(failure, given=match[1])


@rule(
    'launch.no-event-actions',
    what='this event handler received something that is not an action',
    do='pass an action or a list of actions, such as on_exit=[Shutdown()]',
    level='error',
)
def no_event_actions(failure: Failure) -> Iterator[Finding]:
    """Report a string in place of actions, as in `on_exit='shutdown'` in Python."""
    if failure.message.startswith("expected all items in 'on_event' iterable"):
        yield report(failure)


@rule(
    'launch.target-no-action',
    what='the target of this event handler is not an action',
    do='store the action in a variable, sim = Node(...), and write the variable without quotes: target_action=sim',
    level='error',
)
def target_no_action(failure: Failure) -> Iterator[Finding]:
    """Report a string in place of an action, as in `target_action='sim'`."""
    if failure.message.startswith("action_matcher must be an '"):
        yield report(failure)

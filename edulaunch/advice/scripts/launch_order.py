"""Rules about the order of actions in a launch file, events that never happen, and delays in the wrong unit.

No code of the file is executed.
"""

from __future__ import annotations

import ast
from collections.abc import Iterator
from typing import Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import Script, keyword_of, name_of_call, walked

SETTINGS = {
    'PushRosNamespace': 'the namespace',
    'PushROSNamespace': 'the namespace',
    'SetEnvironmentVariable': 'the variable',
    'AppendEnvironmentVariable': 'the variable',
    'SetParameter': 'the parameter',
    'SetParametersFromFile': 'the parameters',
    'SetRemap': 'the remapping',
    'SetUseSimTime': 'the parameter',
}
STARTING = frozenset(
    (
        'ComposableNodeContainer',
        'ExecuteLocal',
        'ExecuteProcess',
        'GroupAction',
        'IncludeLaunchDescription',
        'LifecycleNode',
        'Node',
        'OpaqueFunction',
        'TimerAction',
    )
)
PROCESSES = {'ExecuteLocal', 'ExecuteProcess'}
"""Actions that only environment variables affect."""
LESSON = '02_names'
LESSON_CONDITIONS = '04_conditions'


@rule(
    'launch.setting-after-nodes',
    what='{written} comes after all nodes of its list, so {setting} applies to none of them',
    why='launch executes the actions of a list in order, and a setting applies to the actions after it',
    do='move {action} before the nodes that should use it',
    lesson=LESSON,
    level='error',
    hides=('messages.other-topic', 'messages.nobody-listens', 'messages.nobody-publishes', 'programs.parameter-not-declared'),
)
def setting_after_nodes(scripts: list[Script]) -> Iterator[Finding]:
    """Report an action that changes later programs, if it is in a literal list and all programs of the list come before it."""
    for file, tree in scripts:
        for items in (node for node in walked(tree) if isinstance(node, ast.List)):
            variables = _variables(tree)
            names = [name_of_call(variables.get(item.id, item) if isinstance(item, ast.Name) else item) for item in items.elts]
            for number, name in enumerate(names):
                later, before = names[number + 1 :], names[:number]
                reached = STARTING if 'Variable' in name else STARTING - PROCESSES
                if name in SETTINGS and not any(one in reached or not one for one in later) and set(before) & reached:
                    call = items.elts[number]
                    yield found(
                        'action', name, file=file, line=call.lineno, setting=SETTINGS[name], written=ast.unparse(call)[:60]
                    )


def _variables(tree: ast.Module) -> dict[str, ast.expr]:
    """Return the value of each variable to which the file assigns exactly once."""
    values: dict[str, list[ast.expr]] = {}
    for node in walked(tree):
        if isinstance(node, ast.Assign) and len(node.targets) == 1 and isinstance(node.targets[0], ast.Name):
            values.setdefault(node.targets[0].id, []).append(node.value)
    return {name: each[0] for name, each in values.items() if len(each) == 1}


@rule(
    'launch.waits-for-unstarted',
    what='{event} waits for {variable}, which launch never starts',
    why='the variable contains an action that is not in any list of the launch description, so the event never occurs',
    do='add {variable} to the list of LaunchDescription([...]) as well',
    lesson='05_events',
    level='error',
    hides=('launch.not-added',),
)
def waits_for_unstarted(scripts: list[Script]) -> Iterator[Finding]:
    """Report an action that is used as target_action, but is missing in the launch description."""
    for file, tree in scripts:
        variables = _variables(tree)
        reads: dict[str, int] = {}
        for node in walked(tree):
            if isinstance(node, ast.Name) and isinstance(node.ctx, ast.Load):
                reads[node.id] = reads.get(node.id, 0) + 1
        targets = [
            (name_of_call(call), target.id, call.lineno)
            for call in walked(tree)
            if isinstance(call, ast.Call) and isinstance(target := keyword_of(call, 'target_action'), ast.Name)
        ]
        for event, variable, line in targets:
            is_action = name_of_call(variables.get(variable, tree)) in STARTING
            if is_action and reads[variable] == sum(one == variable for _, one, _ in targets):
                yield found('variable', variable, file=file, line=line, event=event)


LONG_S = 300.0


@rule(
    'launch.timer-in-milliseconds',
    what='this TimerAction waits {period} s, which is {minutes} minutes',
    why='the period of a TimerAction is in seconds',
    do='write the period in seconds: TimerAction(period={seconds}, ...)',
    lesson='05_events',
    confidence='asked',
)
def timer_in_milliseconds(scripts: list[Script]) -> Iterator[Finding]:
    """Report a literal timer period of 300 s or more. The student probably meant milliseconds."""
    for file, tree in scripts:
        for call in walked(tree):
            if isinstance(call, ast.Call) and name_of_call(call) == 'TimerAction':
                period = keyword_of(call, 'period')
                if isinstance(period, ast.Constant) and isinstance(period.value, (int, float)) and period.value >= LONG_S:
                    value = float(period.value)
                    facts: dict[str, Any] = {'period': f'{value:g}', 'minutes': f'{value / 60:.0f}', 'seconds': value / 1000}
                    yield found('action', 'TimerAction', file=file, line=call.lineno, **facts)


@rule(
    'launch.ends-at-once',
    what='{written} is in the list of the launch description, so launch ends everything as soon as it starts',
    why='launch executes the actions of its list in order, and does not wait for the programs',
    do='move it to its place: OnProcessExit(target_action=..., on_exit=[{written}]), or the actions of a TimerAction',
    lesson='05_events',
    level='error',
    hides=('messages.nobody-publishes', 'messages.nobody-listens', 'programs.interrupted', 'launch.waits-for-endless'),
)
def ends_at_once(scripts: list[Script]) -> Iterator[Finding]:
    """Report a Shutdown without a condition in the list of a launch description that also starts programs."""
    for file, tree in scripts:
        variables = _variables(tree)
        for call in walked(tree):
            if name_of_call(call) == 'LaunchDescription' and isinstance(call, ast.Call):
                given = call.args[0] if call.args else keyword_of(call, 'initial_entities')
                items = given.elts if isinstance(given, ast.List) else []
                actions = [variables.get(item.id, item) if isinstance(item, ast.Name) else item for item in items]
                starts = any(name_of_call(action) in STARTING for action in actions)
                for action in actions if starts else ():
                    if _ends_launch(action):
                        yield found('action', 'Shutdown', file=file, line=action.lineno, written=ast.unparse(action))


@rule(
    'launch.ends-on-start',
    what='launch ends everything as soon as {target} starts, because {written} is in on_start',
    why='OnProcessStart reacts to the start of a program, and OnProcessExit to its end',
    do='write OnProcessExit(target_action={target}, on_exit=[{written}])',
    lesson='05_events',
    level='error',
    hides=('messages.nobody-publishes', 'messages.nobody-listens', 'programs.interrupted', 'programs.ended-at-once'),
)
def ends_on_start(scripts: list[Script]) -> Iterator[Finding]:
    """Report a Shutdown in the actions of OnProcessStart."""
    for file, tree in scripts:
        variables = _variables(tree)
        for call in walked(tree):
            if isinstance(call, ast.Call) and name_of_call(call) == 'OnProcessStart':
                given, target = keyword_of(call, 'on_start'), keyword_of(call, 'target_action')
                for item in given.elts if isinstance(given, ast.List) else [] if given is None else [given]:
                    action = variables.get(item.id, item) if isinstance(item, ast.Name) else item
                    if _ends_launch(action):
                        name = ast.unparse(target)[:60] if target is not None else 'a program'
                        yield found('action', 'Shutdown', file=file, line=call.lineno, written=ast.unparse(action), target=name)


@rule(
    'launch.namespace-twice',
    what="{second} adds to the namespace '{first}' of line {at}, so the nodes after it are in '{joined}'",
    why='PushRosNamespace applies to all following actions of its list, and a second one is added to the first one',
    do='put each namespace and its nodes into a group of their own: GroupAction([PushRosNamespace(...), Node(...)])',
    lesson=LESSON,
    hides=('messages.other-topic', 'messages.nobody-listens', 'messages.nobody-publishes'),
)
def namespace_twice(scripts: list[Script]) -> Iterator[Finding]:
    """Report a second PushRosNamespace in one list, if nodes follow each of the two actions."""
    for file, tree in scripts:
        variables = _variables(tree)
        for items in _action_lists(tree):
            actions = [variables.get(item.id, item) if isinstance(item, ast.Name) else item for item in items]
            names = [name_of_call(action) for action in actions]
            pushes = [number for number, name in enumerate(names) if name in ('PushRosNamespace', 'PushROSNamespace')]
            for one, other in zip(pushes, pushes[1:], strict=False):
                before, after = set(names[one + 1 : other]), set(names[other + 1 :])
                first, second = actions[one], actions[other]
                if before & STARTING and after & STARTING and isinstance(first, ast.Call) and isinstance(second, ast.Call):
                    spaces = [_text(call, 0, 'namespace') for call in (first, second)]
                    if all(spaces) and not str(spaces[1]).startswith('/') and keyword_of(second, 'condition') is None:
                        joined = '/' + '/'.join(str(space).strip('/') for space in spaces)
                        facts: dict[str, Any] = {'first': spaces[0], 'at': first.lineno, 'joined': joined}
                        yield found('action', joined, file=file, line=second.lineno, second=ast.unparse(second), **facts)


def _action_lists(tree: ast.Module) -> Iterator[list[ast.expr]]:
    """Yield the literal lists of a launch file.

    For each function, also yield the actions that it adds with add_action(), in order.
    """
    for node in walked(tree):
        if isinstance(node, ast.List):
            yield node.elts
        elif isinstance(node, ast.FunctionDef):
            calls = [line.value for line in node.body if isinstance(line, ast.Expr) and isinstance(line.value, ast.Call)]
            yield [call.args[0] for call in calls if name_of_call(call) == 'add_action' and call.args]


def _ends_launch(action: ast.expr) -> bool:
    """Return whether an action is Shutdown() or EmitEvent(event=Shutdown()), without a condition."""
    if not isinstance(action, ast.Call) or keyword_of(action, 'condition') is not None:
        return False
    is_event = name_of_call(action) == 'EmitEvent' and name_of_call(keyword_of(action, 'event') or action) == 'Shutdown'
    return is_event or name_of_call(action) == 'Shutdown'


@rule(
    'launch.event-class',
    what='EmitEvent gets the class {event}, not an event, so no handler reacts to it',
    why='without parentheses, {event} is a class, and launch compares events by their class',
    do='write EmitEvent(event={event}(...)), with parentheses',
    lesson='05_events',
    level='error',
    edits=(('event={event}', 'event={event}()'),),
)
def event_class(scripts: list[Script]) -> Iterator[Finding]:
    """Report the class of an event in place of an event object, as in `EmitEvent(event=Shutdown)`."""
    for file, tree in scripts:
        imported = {
            (name.asname or name.name): name.name
            for node in walked(tree)
            if isinstance(node, ast.ImportFrom) and 'events' in (node.module or '').split('.')
            for name in node.names
        }
        for call in walked(tree):
            event = keyword_of(call, 'event') if isinstance(call, ast.Call) and name_of_call(call) == 'EmitEvent' else None
            if isinstance(event, ast.Name) and imported.get(event.id, '')[:1].isupper():
                yield found('event', event.id, file=file, line=event.lineno, event=event.id)


@rule(
    'launch.event-for-action',
    what='{event} of {module} is an event, but {place} needs an action',
    why='launch executes actions; an event only reports what has happened or what should happen',
    do=('write: from launch.actions import {action}', 'write EmitEvent(event={event}(...))'),
    lesson='05_events',
    level='error',
    hides=('launch.fails', 'launch.output-hidden', 'launch.not-an-action'),
)
def event_for_action(scripts: list[Script]) -> Iterator[Finding]:
    """Report an event where launch expects an action, as in `on_exit=Shutdown()` with the Shutdown of launch.events."""
    for file, tree in scripts:
        events = {
            (name.asname or name.name): (node.module or '', node.lineno)
            for node in walked(tree)
            if isinstance(node, ast.ImportFrom) and (node.module or '').startswith('launch.events')
            for name in node.names
        }
        for place, values in _action_places(tree) if events else ():
            for value in values:
                name = name_of_call(value)
                if name in events:
                    module, line = events[name]
                    action = name if name == 'Shutdown' else None
                    line = line if action else value.lineno
                    yield found('event', name, file=file, line=line, event=name, module=module, place=place, action=action)


HANDLING = ('on_exit', 'on_start', 'on_completion', 'on_shutdown', 'entities', 'actions')


def _action_places(tree: ast.Module) -> Iterator[tuple[str, list[ast.expr]]]:
    """Yield each place in a launch file where actions are expected, as a description and the expressions there."""
    for node in walked(tree):
        value = node.value if isinstance(node, ast.keyword) and node.arg in HANDLING else None
        if isinstance(node, ast.keyword) and value is not None:
            yield f'{node.arg}=', value.elts if isinstance(value, ast.List) else [value]
        elif isinstance(node, ast.Call) and name_of_call(node) == 'LaunchDescription' and node.args:
            yield 'LaunchDescription', node.args[0].elts if isinstance(node.args[0], ast.List) else []


@rule(
    'launch.equals-swapped',
    what="the arguments of {condition} are swapped: '{second}' is a launch argument, and '{first}' is not",
    why='the first value must be the name of the launch argument, and the second must be the expected value',
    do="write {condition}('{second}', '{first}')",
    lesson=LESSON_CONDITIONS,
    level='error',
)
def equals_swapped(scripts: list[Script]) -> Iterator[Finding]:
    """Report swapped values of LaunchConfigurationEquals, if the second value is an argument that a script declares."""
    calls = [(file, call) for file, tree in scripts for call in walked(tree) if isinstance(call, ast.Call)]
    declared = {
        _text(call, 0, 'name') for _, call in calls if name_of_call(call) in ('DeclareLaunchArgument', 'SetLaunchConfiguration')
    }
    for file, call in calls:
        if name_of_call(call) in ('LaunchConfigurationEquals', 'LaunchConfigurationNotEquals'):
            first, second = _text(call, 0, 'launch_configuration_name'), _text(call, 1, 'expected_value')
            if first and second and first not in declared and second in declared:
                facts: dict[str, Any] = {'condition': name_of_call(call), 'first': first, 'second': second}
                yield found('argument', second, file=file, line=call.lineno, **facts)


def _text(call: ast.Call, number: int, name: str) -> str | None:
    """Return the literal string that a call passes as an argument, by position or by keyword, or None."""
    value = call.args[number] if len(call.args) > number else keyword_of(call, name)
    return value.value if isinstance(value, ast.Constant) and isinstance(value.value, str) else None

"""Rules about lines of programs that are valid Python but, as the run shows, do not do what the student meant."""

from __future__ import annotations

import ast
import linecache
import os
import re
from collections import Counter
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import launch_files, name_of_call, program_scripts, walked
from edulaunch.advice.runs import end_place, ends_by_name, files_of, own_nodes

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

FUNCTIONS = (ast.FunctionDef, ast.AsyncFunctionDef, ast.Lambda)


@rule(
    'programs.not-called',
    what='the line `{written}` has no parentheses, so Python does not call {function}()',
    why='without parentheses, a function is a value, and a line with only a value does nothing',
    do='write {written}({argument})',
    lesson='00_python',
    level='error',
    hides=('messages.nobody-publishes', 'messages.nobody-listens', 'programs.ended-at-once', 'programs.never-spun'),
)
def not_called(recording: Recording) -> Iterator[Finding]:
    """Report a statement that only names a method, as in `self.publisher.publish` or `rclpy.shutdown`.

    A statement that only names a value, such as `self.count`, is rare and harmless, so the rule does not report it.
    """
    for file, tree in program_scripts(recording):
        for node in walked(tree):
            if isinstance(node, ast.Expr) and isinstance(node.value, ast.Attribute) and node.value.attr in CALLED:
                written, function = ast.unparse(node.value), node.value.attr
                facts: dict[str, Any] = {'function': function, 'argument': CALLED[function]}
                yield found('text', written, file=file, line=node.lineno, written=written, **facts)


CALLED = {
    **dict.fromkeys(('init', 'shutdown', 'destroy_node', 'try_shutdown', 'succeed', 'abort', 'canceled', 'reset', 'cancel'), ''),
    **dict.fromkeys(('wait_for_service', 'wait_for_server', 'get_result_async', 'tick', 'stop', 'start'), ''),
    **dict.fromkeys(('publish', 'publish_feedback'), 'msg'),
    'spin': 'node',
    'spin_once': 'node',
    'sendTransform': 'transform',
    'send_goal_async': 'goal',
    'call_async': 'request',
    **dict.fromkeys(('debug', 'info', 'warn', 'warning', 'error', 'fatal'), "'text'"),
}
"""Names of methods that a statement calls, each with its usual argument."""


@rule(
    'programs.made-after-spin',
    what='{function}() on line {at} comes after {spin}() on line {spun}, which returns only when the program ends',
    why='the lines after {spin}() run too late: nothing spins the node any more',
    do='move line {at} before line {spun}',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('messages.nobody-publishes', 'messages.nobody-listens', 'programs.after-shutdown'),
)
def made_after_spin(recording: Recording) -> Iterator[Finding]:
    """Report an endpoint or a timer that a block creates after rclpy.spin(), if no later line spins."""
    for file, tree in program_scripts(recording):
        for body in (getattr(node, 'body', None) for node in walked(tree)):
            calls = [call for line in body for call in _calls(line)] if isinstance(body, list) else []
            spins = [number for number, call in enumerate(calls) if name_of_call(call).startswith('spin')]
            spin = calls[spins[0]] if len(spins) == 1 else None
            if spin is None or name_of_call(spin) != 'spin' or ast.unparse(spin).endswith('(self)'):
                continue
            for late in [call for call in calls[spins[0] + 1 :] if name_of_call(call) in MADE][:1]:
                facts: dict[str, Any] = {'at': late.lineno, 'spun': spin.lineno, 'spin': ast.unparse(spin.func)}
                yield found('function', name_of_call(late), file=file, line=late.lineno, **facts)


@rule(
    'programs.spun-in-turn',
    what='rclpy.spin({second}) on line {at} begins only after the end of rclpy.spin({first}) on line {spun}',
    why='rclpy.spin() returns only when rclpy shuts down',
    do='spin both nodes in one executor: executor = SingleThreadedExecutor(), executor.add_node({first}), '
    'executor.add_node({second}), executor.spin()',
    lesson='13_large_project',
    level='error',
    hides=('programs.never-spun', 'messages.not-taken', 'programs.after-shutdown'),
)
def spun_in_turn(recording: Recording) -> Iterator[Finding]:
    """Report a block that calls rclpy.spin() twice, for two nodes."""
    for file, tree in program_scripts(recording):
        for body in (getattr(node, 'body', None) for node in walked(tree)):
            calls = [call for line in body for call in _calls(line)] if isinstance(body, list) else []
            spins = [call for call in calls if ast.unparse(call.func) in ('rclpy.spin', 'spin') and call.args]
            for one, other in zip(spins[:1], spins[1:2], strict=False):
                first, second = ast.unparse(one.args[0]), ast.unparse(other.args[0])
                if first != second:
                    facts: dict[str, Any] = {'first': first, 'second': second, 'at': other.lineno, 'spun': one.lineno}
                    yield found('function', 'spin', file=file, line=other.lineno, **facts)


MADE = frozenset(('create_timer', 'create_publisher', 'create_subscription', 'create_service', 'create_client', 'ActionServer'))


def _calls(line: ast.AST) -> list[ast.Call]:
    """Return the calls in one simple statement, in the order of `ast.walk`. Return an empty list for a compound statement."""
    if isinstance(line, (*FUNCTIONS, ast.ClassDef, ast.While, ast.For, ast.Try, ast.If, ast.With)):
        return []
    return [node for node in ast.walk(line) if isinstance(node, ast.Call)]


@rule(
    'programs.global-forgotten',
    what='{function}() stores {variable} in a local variable, so the variable {variable} of line {made} keeps its first value',
    why='in a function, an assignment creates a local variable, unless a global statement names it',
    do='write `global {variable}` as the first line of {function}(), or store the value in self.{variable}',
    lesson='00_python',
    level='error',
)
def global_forgotten(recording: Recording) -> Iterator[Finding]:
    """Report a module variable that one function only assigns, without `global`, and that another function only reads."""
    for file, tree in program_scripts(recording):
        made = {
            target.id: line.lineno
            for line in tree.body
            if isinstance(line, ast.Assign)
            for target in line.targets
            if isinstance(target, ast.Name) and not target.id.isupper()
        }
        functions = [node for node in walked(tree) if isinstance(node, ast.FunctionDef)] if made else []
        uses = {id(one): _uses(one) for one in functions}
        changed = {name for stored, _, declared in uses.values() for name in declared & stored.keys()}
        for one in functions:
            stored, loaded, declared = uses[id(one)]
            for name in sorted(stored.keys() & made.keys() - declared - loaded - changed - _parameters(one)):
                if any(name in other[1] and name not in other[0] for key, other in uses.items() if key != id(one)):
                    facts: dict[str, Any] = {'function': one.name, 'made': made[name]}
                    yield found('variable', name, file=file, line=stored[name], **facts)


def _uses(function: ast.FunctionDef) -> tuple[dict[str, int], set[str], set[str]]:
    """Return three groups of variables of a function.

    They are the assigned variables with their lines, the variables that the function reads, and the variables that it declares
    as global or nonlocal.

    """
    names = [node for node in ast.walk(function) if isinstance(node, ast.Name)]
    stored = {name.id: name.lineno for name in reversed(names) if isinstance(name.ctx, ast.Store)}
    declared = {one for node in ast.walk(function) if isinstance(node, (ast.Global, ast.Nonlocal)) for one in node.names}
    return stored, {name.id for name in names if isinstance(name.ctx, ast.Load)}, declared


def _parameters(function: ast.FunctionDef) -> set[str]:
    return {node.arg for node in ast.walk(function) if isinstance(node, ast.arg)}


_HERTZ = re.compile(r'(?<![a-z])(hz|hertz|freq|frequency|rate)(?![a-z])', re.IGNORECASE)
_IN_COMMENT = re.compile(r'#.*?\b(\d+(?:\.\d+)?)\s*(?:hz|hertz)\b', re.IGNORECASE)


@rule(
    'time.period-in-hertz',
    what=(
        'create_timer({written}, ...) calls the function every {period_s:g} s, but the comment of this line says {hertz} Hz',
        'create_timer({written}, ...) calls the function every {period_s:g} s, but {variable} is the name of a frequency',
    ),
    why='create_timer() expects the number of seconds between two calls, not the number of calls per second',
    do='write create_timer(1.0 / {written}, ...)',
    lesson='09_broadcaster_and_listener',
)
def period_in_hertz(recording: Recording) -> Iterator[Finding]:
    """Report a timer whose period is a frequency: a variable with a name such as `rate_hz`, or a number with 'Hz' in the
    comment.
    """
    for file, tree in program_scripts(recording):
        for call in walked(tree):
            if isinstance(call, ast.Call) and name_of_call(call) == 'create_timer' and call.args:
                period, comment = call.args[0], _IN_COMMENT.search(linecache.getline(file, call.lineno))
                name = period.id if isinstance(period, ast.Name) else period.attr if isinstance(period, ast.Attribute) else ''
                if isinstance(period, ast.Constant):
                    is_hertz = comment is not None and period.value not in (0, 1) and float(comment[1]) == period.value
                    value, hertz = period.value, comment and comment[1]
                else:
                    value, hertz = only_number(tree, name) if _HERTZ.search(name.replace('_', ' ')) else None, None
                    is_hertz = value is not None and value > 1
                if is_hertz:
                    facts: dict[str, Any] = {'written': ast.unparse(period), 'period_s': value, 'hertz': hertz, 'variable': name}
                    yield found('function', 'create_timer', file=file, line=call.lineno, **facts)


def only_number(tree: ast.Module, name: str) -> float | None:
    """Return the number in the only assignment to a variable or attribute. Return None for any other value, and for several
    assignments.
    """
    values = [
        node.value
        for node in walked(tree)
        if isinstance(node, ast.Assign)
        for target in node.targets
        if (isinstance(target, ast.Name) and target.id == name) or (isinstance(target, ast.Attribute) and target.attr == name)
    ]
    value = values[0].value if len(values) == 1 and isinstance(values[0], ast.Constant) else None
    return float(value) if isinstance(value, (int, float)) and not isinstance(value, bool) else None


@rule(
    'programs.exit-in-callback',
    what='{written} in {callback}() ended the program of {node} when it received message number {messages}',
    why='exit() ends the whole program, and the node with it; return ends only this call of {callback}()',
    do='replace {written} with return, if the node should wait for the next message',
    lesson='09_broadcaster_and_listener',
    confidence='asked',
    hides=('programs.died', 'messages.too-early', 'messages.nobody-listens'),
)
def exit_in_callback(recording: Recording) -> Iterator[Finding]:
    """Report exit() in a callback of a subscription.

    The program must have ended by itself within a second after its first message. Other nodes must have published on the
    topic for at least another second.
    """
    ended = {one.name: one for one in recording.own_processes if one.returncode == 0 and one.ended_s is not None}
    nodes = [node for node in recording.nodes if node.process in ended and node.name in own_nodes(recording)]
    for file, tree in program_scripts(recording) if nodes else ():
        for node in nodes:
            end_s = ended[node.process].ended_s or 0.0
            if file in files_of(recording, node.name):
                for topic, _ in node.subscriptions:
                    times = [time / 1e9 for row in recording.rows('topics') if row['topic'] == topic for time in row['times']]
                    before = [time for time in times if node.started_s <= time <= end_s]
                    if before and end_s - before[0] <= 1.0 and times[-1] > end_s + 1.0:
                        yield from _exits(tree, file, node.name, len(before))


def _exits(tree: ast.Module, file: str, node: str, messages: int) -> Iterator[Finding]:
    called_back = {
        call.args[2].attr
        for call in walked(tree)
        if isinstance(call, ast.Call) and name_of_call(call) == 'create_subscription' and len(call.args) > 2
        if isinstance(call.args[2], ast.Attribute)
    }
    for method in walked(tree):
        if isinstance(method, ast.FunctionDef) and method.name in called_back:
            for call in ast.walk(method):
                if isinstance(call, ast.Call) and ast.unparse(call.func) in ('exit', 'quit', 'sys.exit'):
                    facts: dict[str, Any] = {'written': ast.unparse(call), 'callback': method.name, 'messages': messages}
                    yield found('node', node, file=file, line=call.lineno, **facts)
                    return


SAME_TIME = 20


@rule(
    'messages.own-echo',
    what='{node} receives each message that it publishes on {topic}, and publishes it again: {count} times in {span_s:g} s',
    why='a node that subscribes to the topic on which it publishes also receives its own messages',
    do='publish on another topic than {topic}, the topic of the subscription',
    lesson='01_first_launch',
    level='error',
    hides=('messages.not-taken', 'messages.two-commanders'),
)
def own_echo(recording: Recording) -> Iterator[Finding]:
    """Report a node that subscribes to its own topic and publishes on it many times at the same simulated time."""
    ends = ends_by_name(recording)
    own = own_nodes(recording)
    for (kind, topic), publishers in ends.items():
        listening = {end.node for end in ends.get(('subscription', topic), ())} if kind == 'publisher' else set()
        for end in publishers:
            if end.node in listening & own:
                times = [time for time, node, _ in recording.published(topic, end.type) if node == end.node]
                most = max(Counter(times).values(), default=0)
                if most >= SAME_TIME:
                    file, line = end_place(recording, 'publisher', topic, end.node)
                    span_s = (times[-1] - times[0]) / 1e9
                    yield found('topic', topic, file=file, line=line, node=end.node, count=len(times), span_s=span_s)


@rule(
    'launch.yaml-key-twice',
    what="one item of this list has the key '{key}' twice, in lines {first} and {again}, and YAML keeps only the second value",
    why='in YAML, each item of a list begins with a dash, and a mapping has each key once',
    do="begin line {again} with a dash: '- {key}:'",
    lesson='06_xml_yaml',
    level='error',
    hides=('messages.nobody-publishes', 'messages.nobody-listens', 'messages.other-topic'),
)
def yaml_key_twice(recording: Recording) -> Iterator[Finding]:
    """Report a key that occurs twice in one mapping of a YAML launch file."""
    files = launch_files(recording) if recording.launch.error is None else []
    for file in dict.fromkeys(file for file in files if file.endswith(('.yaml', '.yml')) and os.path.isfile(file)):
        for key, first, again in _keys_twice(file):
            yield found('key', key, file=file, line=again, first=first, again=again)


def _keys_twice(file: str) -> Iterator[tuple[str, int, int]]:
    """Yield each repeated key of a mapping in a YAML file, with the lines of its first and second occurrence."""
    import yaml

    with open(file, encoding='utf-8') as text:
        todo: list[yaml.Node | None] = [yaml.compose(text, yaml.SafeLoader)]
    while todo:
        node = todo.pop()
        pairs = node.value if isinstance(node, yaml.MappingNode) else []
        lines: dict[str, int] = {}
        for key, _ in pairs:
            line = key.start_mark.line + 1
            if str(key.value) in lines:
                yield str(key.value), lines[str(key.value)], line
            lines[str(key.value)] = line
        todo += [value for _, value in pairs] if pairs else node.value if isinstance(node, yaml.SequenceNode) else []

"""Rules about mistakes in the source of programs and launch files whose effect a run has shown."""

from __future__ import annotations

import ast
import linecache
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import keyword_of, launch_scripts, name_of_call, program_scripts, walked
from edulaunch.advice.runs import end_place, ends_by_name, files_of, is_ros_own, node_place, own_nodes

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import NodeRecord, ProcessRecord


@rule(
    'programs.goal-unfinished',
    what='{node} ends a goal without a final state, so the client receives the status aborted',
    why='an execute callback must set the final state before it returns the result',
    do='call goal_handle.succeed(), abort() or canceled() before the return',
    lesson='14_services',
    level='error',
)
def goal_unfinished(recording: Recording) -> Iterator[Finding]:
    """Report an execute callback that returned without setting the state of its goal. rclpy logs this."""
    reported: set[str] = set()
    for time_ns, process, _, _, message in recording.rows('logs'):
        if message.startswith('Goal state not set') and process not in reported:
            reported.add(process)
            node = next((one.name for one in recording.nodes if one.process == process), process)
            file, line = node_place(recording, node)
            for script, tree in program_scripts(recording):
                for call in walked(tree):
                    if name_of_call(call) == 'ActionServer':
                        file, line = script, call.lineno  # type: ignore[attr-defined]
            yield found('node', node, file=file, line=line, time_s=time_ns / 1e9)


@rule(
    'programs.spun-once',
    what='{node} calls rclpy.spin_once(), which runs one callback only, and ends',
    why='the program and its node end when main() returns',
    do='replace rclpy.spin_once(node) with rclpy.spin(node)',
    lesson='09_broadcaster_and_listener',
    level='error',
    hides=('messages.nobody-listens', 'messages.too-early'),
)
def spun_once(recording: Recording) -> Iterator[Finding]:
    """Report a program with subscriptions or timers that calls spin_once outside of any loop and ended with exit code 0."""
    ended = {
        process.name: process for process in recording.own_processes if process.returncode == 0 and process.ended_s is not None
    }
    nodes = [
        node
        for node in recording.nodes
        if node.process in ended and any(_goes_on(recording, node, topic) for topic, _ in node.subscriptions)
    ]
    for file, tree in program_scripts(recording) if nodes else ():
        loops = {id(inner) for loop in walked(tree) if isinstance(loop, (ast.While, ast.For)) for inner in ast.walk(loop)}
        calls = [node for node in walked(tree) if isinstance(node, ast.Call)]
        spins = [call for call in calls if name_of_call(call) == 'spin_once' and id(call) not in loops]
        if spins and not any(name_of_call(call) in ('spin', 'spin_until_future_complete') for call in calls):
            for node in nodes:
                if file in (*ended[node.process].argv[:2], *files_of(recording, node.name)):
                    yield found('node', node.name, file=file, line=spins[0].lineno, time_s=ended[node.process].ended_s)


def _goes_on(recording: Recording, node: NodeRecord, topic: str) -> bool:
    """Return whether other nodes published on a topic for at least a second after a node had ended."""
    others = [end for end in ends_by_name(recording).get(('publisher', topic), ()) if end.node != node.name]
    times = [row['times'][-1] / 1e9 for row in recording.rows('topics') if row['topic'] == topic and row['times']]
    return not is_ros_own(topic) and bool(others and times) and max(times) > (node.ended_s or node.started_s) + 1.0


@rule(
    'programs.method-twice',
    what='the class {klass} defines the method {method}() twice, and Python keeps only the second one',
    why='in Python, a later definition silently replaces an earlier one with the same name',
    do='rename one of the two, and use the new name where you create the subscription or timer',
    lesson='00_python',
    level='error',
    hides=('messages.field', 'programs.callback-arguments', 'programs.died'),
)
def method_twice(recording: Recording) -> Iterator[Finding]:
    """Report two methods with one name in one class. Skip methods with decorators, such as a property and its setter."""
    for file, tree in program_scripts(recording):
        for klass in (node for node in walked(tree) if isinstance(node, ast.ClassDef)):
            first: dict[str, ast.FunctionDef] = {}
            for method in klass.body:
                if isinstance(method, ast.FunctionDef) and not method.decorator_list:
                    if method.name in first:
                        yield found('class', klass.name, file=file, line=method.lineno, klass=klass.name, method=method.name)
                    first[method.name] = method


@rule(
    'programs.activated-without-super',
    what='on_activate() of {klass} does not call super().on_activate(state), so its lifecycle publishers send nothing',
    why='on_activate() of LifecycleNode enables the publishers, and a method of the same name replaces it',
    do='end on_activate() with: return super().on_activate(state)',
    level='error',
)
def activated_without_super(recording: Recording) -> Iterator[Finding]:
    """Report a class with lifecycle publishers whose on_activate() does not call on_activate() of the base class."""
    for file, tree in program_scripts(recording):
        for klass in (node for node in walked(tree) if isinstance(node, ast.ClassDef)):
            text = ast.unparse(klass)
            for method in klass.body if 'create_lifecycle_publisher(' in text and '.on_activate(' not in text else ():
                if isinstance(method, ast.FunctionDef) and method.name == 'on_activate':
                    yield found('class', klass.name, file=file, line=method.lineno, klass=klass.name)


@rule(
    'programs.spin-in-constructor',
    what='the constructor of {klass} calls rclpy.spin(self) on line {at}, so its next lines never run',
    why='rclpy.spin() returns only when the program ends',
    do='remove this line, and call rclpy.spin(node) in main(), after the node is created',
    level='error',
)
def spin_in_constructor(recording: Recording) -> Iterator[Finding]:
    """Report a call of rclpy.spin(self) in a constructor, if other lines follow it."""
    for file, tree in program_scripts(recording):
        for klass in (node for node in walked(tree) if isinstance(node, ast.ClassDef)):
            for method in klass.body:
                for line in method.body[:-1] if isinstance(method, ast.FunctionDef) and method.name == '__init__' else ():
                    if ast.unparse(line) == 'rclpy.spin(self)':
                        yield found('class', klass.name, file=file, line=line.lineno, klass=klass.name, at=line.lineno)


@rule(
    'programs.equals-plus',
    what='{written} sets {variable} to {value} each time, because =+ is an assignment of +{value}',
    why='Python reads `=+ 1` as `= (+1)`',
    do='write {variable} += {value}',
    lesson='00_python',
    level='error',
    edits=(('=+', '+='),),
)
def equals_plus(recording: Recording) -> Iterator[Finding]:
    """Report `=+` with a space after it. `x =+1` is not reported, because its plus sign can be the sign of the number."""
    for file, tree in program_scripts(recording):
        for node in walked(tree):
            is_plus = isinstance(node, ast.Assign) and isinstance(node.value, ast.UnaryOp) and isinstance(node.value.op, ast.UAdd)
            if is_plus and isinstance(node, ast.Assign) and isinstance(node.value, ast.UnaryOp):
                line = linecache.getline(file, node.lineno)
                match = re.search(r'([\w.]+)\s*=\+\s+', line)
                if match is not None:
                    facts: dict[str, Any] = {'written': line.strip(), 'value': ast.unparse(node.value.operand)}
                    yield found('variable', match[1], file=file, line=node.lineno, **facts)


MANY_PUBLISHERS = 5


@rule(
    'messages.publisher-each-time',
    what='{node} creates a new publisher on {topic} for each message ({count} so far)',
    why='on a network, a new publisher needs some time until the subscriptions find it, and its first message is lost',
    do='create the publisher once, in the constructor, and keep it: self.publisher = self.create_publisher(...)',
    lesson='01_first_launch',
    hides=('messages.too-early',),
)
def publisher_each_time(recording: Recording) -> Iterator[Finding]:
    """Report at least five publishers of one node on one topic, if each publisher sends a message when it is created."""
    made: dict[tuple[str, str], set[float]] = {}
    own = own_nodes(recording)
    for (kind, topic), ends in ends_by_name(recording).items():
        if kind != 'publisher' or len(ends) < MANY_PUBLISHERS or is_ros_own(topic):
            continue
        sent = {(round(time / 1e9, 6), node) for time, node, _ in recording.published(topic, ends[0].type)}
        for end in ends:
            if end.node in own and (round(end.made_s, 6), end.node) in sent:
                made.setdefault((end.node, topic), set()).add(end.made_s)
    for (node, topic), times in made.items():
        if len(times) >= MANY_PUBLISHERS:
            file, line = end_place(recording, 'publisher', topic, node)
            yield found('topic', topic, file=file, line=line, node=node, count=len(times))


RUNS_LONG_S = 5.0
ENDING = ('Shutdown', 'EmitEvent', 'LogInfo')


@rule(
    'launch.waits-for-endless',
    what='OnProcessExit waits for the end of {process}, which never ends by itself, so its actions never start',
    why='a node runs until you stop it; only a program that finishes its work ends by itself',
    do='use OnProcessStart(target_action=..., on_start=[...]), or wait for a program that ends by itself',
    lesson='05_events',
    confidence='asked',
)
def waits_for_endless(recording: Recording) -> Iterator[Finding]:
    """Report a handler that waits for the end of an endless program, if the program ran for at least five seconds.

    Skip a handler that only shuts the launch down or logs.
    """
    for file, tree in launch_scripts(recording):
        made = {
            node.targets[0].id: node.value
            for node in walked(tree)
            if isinstance(node, ast.Assign)
            and isinstance(node.targets[0], ast.Name)
            and name_of_call(node.value) in ('Node', 'LifecycleNode')
        }
        for call in walked(tree):
            if not isinstance(call, ast.Call) or name_of_call(call) != 'OnProcessExit':
                continue
            target, then = keyword_of(call, 'target_action'), keyword_of(call, 'on_exit')
            action = made.get(target.id) if isinstance(target, ast.Name) else target
            starts = isinstance(then, ast.List) and any(name_of_call(item) not in ENDING for item in then.elts)
            if action is None or not starts or name_of_call(action) not in ('Node', 'LifecycleNode'):
                continue
            span = range(action.lineno, (action.end_lineno or action.lineno) + 1)
            for process in recording.processes:
                if process.file == file and process.line in span and _outlived(recording, process):
                    yield found('process', process.name, file=file, line=call.lineno)


def _outlived(recording: Recording, process: ProcessRecord) -> bool:
    """Return whether a program ran for a long time, until the run ended or a signal ended the program."""
    end_s = recording.duration_s if process.ended_s is None else process.ended_s
    return process.returncode in (None, -2, -15) and end_s - process.started_s >= RUNS_LONG_S

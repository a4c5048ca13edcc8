"""Rules about tasks with turtles: a goal in degrees, a turtle that mimics itself, and an exact comparison of an angle."""

from __future__ import annotations

import ast
import math
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.recordings.code_lines import only_number
from edulaunch.advice.recordings.turtles import FULL_TURN, turtles
from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import program_scripts, walked
from edulaunch.advice.runs import end_place, files_of, node_place, own_nodes, speaker

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

LESSON = '09_broadcaster_and_listener'
POSE = 'turtlesim/msg/Pose'
FIELDS = ('x', 'y', 'theta', 'linear_velocity', 'angular_velocity')


@rule(
    'turtlesim.goal-in-degrees',
    what='{node} sends the goal theta = {angle} to {action}, and this is more than a full turn in radians',
    why='all angles in ROS 2 are in radians: a quarter turn is 1.57, and a full turn is 6.28',
    do='convert the angle: math.radians({angle})',
    lesson='14_services',
    confidence='asked',
)
def goal_in_degrees(recording: Recording) -> Iterator[Finding]:
    """Report a goal of RotateAbsolute that is larger than a full turn."""
    for time_ns, service, type_name, client, request, *_ in recording.rows('calls'):
        if type_name == 'turtlesim/action/RotateAbsolute_SendGoal' and abs(request[1]) > FULL_TURN:
            action = service.removesuffix('/_action/send_goal')
            file, line = end_place(recording, 'client', service, client)
            node = speaker(recording, client)
            yield found(
                'turtle', action, file=file, line=line, time_s=time_ns / 1e9, node=node, action=action, angle=round(request[1], 2)
            )


@rule(
    'turtlesim.mimics-itself',
    what='{node} reads the pose of {turtle} and sends its commands to the same turtle, so nothing moves',
    why='mimic drives one turtle at the speed of another turtle',
    do='remap /input/pose to the pose topic of the leading turtle, and /output/cmd_vel to the cmd_vel topic of the other one',
    lesson='02_names',
    level='error',
)
def mimics_itself(recording: Recording) -> Iterator[Finding]:
    """Report a node of the program mimic whose input and output belong to the same turtle."""
    programs = {process.name for process in recording.processes if process.executable == 'mimic'}
    for node in recording.nodes:
        if node.process in programs:
            heard = {name.removesuffix('/pose') for name, type_ in node.subscriptions if type_ == POSE}
            sent = {name.removesuffix('/cmd_vel') for name, _ in node.publishers if name.endswith('/cmd_vel')}
            for turtle in sorted(heard & sent & turtles(recording).keys()):
                file, line = node_place(recording, node.name)
                yield found('turtle', turtle, file=file, line=line, node=node.name)


@rule(
    'programs.exact-float',
    what='{written} is never true: {field} went from {below} to {above}, and was never exactly {value}',
    why='a turtle moves in steps of 16 ms, so a measured value is almost never exactly the expected one',
    do='compare with a tolerance: abs({left} - {right}) < 0.05',
    lesson='00_python',
    level='error',
    hides=('turtlesim.wall',),
)
def exact_float(recording: Recording) -> Iterator[Finding]:
    """Report `pose.theta == math.pi / 2` in a program, if the recorded values passed this value but never were equal to it."""
    own = own_nodes(recording)
    scripts = program_scripts(recording)
    compared = [one for file, tree in scripts for one in _comparisons(file, tree)]
    for node in recording.nodes if compared else ():
        topics = [name for name, type_ in node.subscriptions if type_ == POSE] if node.name in own else []
        for file, test, left, right, value in compared if len(topics) == 1 else ():
            if file in files_of(recording, node.name) | {end_place(recording, 'subscription', topics[0], node.name)[0]}:
                values = [wire[FIELDS.index(left.attr)] for _, wire in recording.wires(topics[0], POSE)]
                steps = zip(values, values[1:], strict=False)
                passed = next((step for step in steps if min(step) < value < max(step) and max(step) - min(step) < 1.0), None)
                if passed is not None and value not in values:
                    facts: dict[str, Any] = {'written': ast.unparse(test), 'field': left.attr, 'value': round(value, 6)}
                    facts |= {'below': round(passed[0], 4), 'above': round(passed[1], 4), 'left': ast.unparse(left)}
                    yield found('node', node.name, file=file, line=test.lineno, node=node.name, right=ast.unparse(right), **facts)


def _comparisons(file: str, tree: ast.Module) -> Iterator[tuple[str, ast.Compare, ast.Attribute, ast.expr, float]]:
    """Yield the comparisons with == between a field of a pose and a value that is known from the file alone."""
    for test in walked(tree):
        if isinstance(test, ast.Compare) and len(test.ops) == 1 and isinstance(test.ops[0], ast.Eq):
            sides = (test.left, test.comparators[0])
            for left, right in (sides, sides[::-1]):
                value = _value(tree, right)
                if isinstance(left, ast.Attribute) and left.attr in FIELDS[:3] and value is not None:
                    yield file, test, left, right, value


def _value(tree: ast.Module, node: ast.expr) -> float | None:
    """Return the value of an expression of literals, math.pi and variables with a single value.

    Return None for any other expression.
    """
    if isinstance(node, ast.Constant) and isinstance(node.value, (int, float)) and not isinstance(node.value, bool):
        return float(node.value)
    if isinstance(node, ast.UnaryOp) and isinstance(node.op, ast.USub):
        inner = _value(tree, node.operand)
        return None if inner is None else -inner
    if isinstance(node, ast.BinOp) and isinstance(node.op, (ast.Add, ast.Sub, ast.Mult, ast.Div)):
        left, right = _value(tree, node.left), _value(tree, node.right)
        if left is None or right is None or (isinstance(node.op, ast.Div) and not right):
            return None
        signs = {ast.Add: left + right, ast.Sub: left - right, ast.Mult: left * right}
        return signs[type(node.op)] if type(node.op) in signs else left / right
    name = node.id if isinstance(node, ast.Name) else node.attr if isinstance(node, ast.Attribute) else ''
    return math.pi if name == 'pi' else only_number(tree, name)

"""Rules about values, arguments and descriptions that a program accepts, but interprets in another way than the user meant."""

from __future__ import annotations

import ast
import math
import re
from collections.abc import Iterator
from typing import TYPE_CHECKING, Any

from edulaunch.advice.rule import Finding, found, rule
from edulaunch.advice.run_sources import name_of_call, program_scripts, walked
from edulaunch.advice.runs import origin_place, own_nodes
from edulaunch.engine.nearest import nearest

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording
    from edulaunch.engine.recording.records import ProcessRecord

BOOLEAN = re.compile('true|false|True|False')
GETTERS = ('declare_parameter', 'get_parameter', 'get_parameter_or')


@rule(
    'programs.text-for-bool',
    what=("the parameter '{parameter}' of {node} is the string '{value}', and `if` treats every non-empty string as true",),
    why='the parameter was declared with a string as its default, and a value in quotes is a string',
    do="declare a boolean with self.declare_parameter('{parameter}', False), and pass true or false without quotes",
    lesson='03_parameters',
    level='error',
)
def text_for_bool(recording: Recording) -> Iterator[Finding]:
    """Report a string as the value of a boolean parameter, if a program tests the value itself, as in `if value:`."""
    tested: set[str] | None = None
    for node in recording.nodes:
        if node.name not in own_nodes(recording):
            continue
        for name, parameter in recording.parameters(node.name).items():
            if isinstance(parameter.value, str) and BOOLEAN.fullmatch(parameter.value):
                tested = _tested(recording) if tested is None else tested
                if name in tested:
                    file, line = origin_place(recording, node.process, parameter.origin)
                    yield found('parameter', name, file=file, line=line, node=node.name, value=parameter.value)


def _tested(recording: Recording) -> set[str]:
    """Return the names of parameters whose values a program of the run tests directly."""
    found_names: set[str] = set()
    for _, tree in program_scripts(recording):
        holders = {
            ast.unparse(target): name
            for node in walked(tree)
            if isinstance(node, ast.Assign) and (name := _parameter_read(node.value))
            for target in node.targets
        }
        for node in walked(tree):
            if isinstance(node, (ast.If, ast.IfExp, ast.While)):
                for test in node.test.values if isinstance(node.test, ast.BoolOp) else (node.test,):
                    inner = test.operand if isinstance(test, ast.UnaryOp) and isinstance(test.op, ast.Not) else test
                    name = _parameter_read(inner) or holders.get(ast.unparse(inner))
                    found_names |= {name} if name else set()
    return found_names


def _parameter_read(node: ast.AST) -> str | None:
    """Return the name of the parameter that an expression such as `self.get_parameter('x').value` reads, or None."""
    if isinstance(node, ast.Attribute) and node.attr in ('value', 'string_value'):
        inner: ast.AST = node.value
        while isinstance(inner, (ast.Attribute, ast.Call)):
            if name_of_call(inner) in GETTERS and isinstance(inner, ast.Call) and inner.args:
                first = inner.args[0]
                return first.value if isinstance(first, ast.Constant) and isinstance(first.value, str) else None
            inner = inner.func if isinstance(inner, ast.Call) else inner.value
    return None


@rule(
    'programs.parameter-read-once',
    what="'{parameter}' of {node} was set while the node was running, but {node} reads it only in its constructor",
    why='a value that the constructor copies, as in self.{parameter} = ..., does not change later',
    do="call self.get_parameter('{parameter}').value where you use the value, or update it in add_on_set_parameters_callback()",
    lesson='03_parameters',
)
def parameter_read_once(recording: Recording) -> Iterator[Finding]:
    """Report a parameter that was set successfully, but that the program reads only in a constructor.

    The program has no callback for changed parameters.
    """
    if not any(row[2] == SET for row in recording.rows('calls')):
        return
    for call in recording.service_calls:
        node = call.service.removesuffix('/set_parameters')
        if call.type != SET or call.response is None or node not in own_nodes(recording):
            continue
        for parameter, result in zip(call.request.parameters, call.response.results, strict=False):
            place = _read_in_constructor(recording, parameter.name) if result.successful else None
            if place is not None:
                facts = {'node': node, 'asker': call.client}
                yield found('parameter', parameter.name, file=place[0], line=place[1], time_s=call.time_s, **facts)


SET = 'rcl_interfaces/srv/SetParameters'


def _read_in_constructor(recording: Recording, name: str) -> tuple[str, int] | None:
    """Return the file and line that read a parameter in a constructor.

    Return None if the program also reads it elsewhere, or if a callback handles changes.
    """
    place = None
    for file, tree in program_scripts(recording):
        inside = {
            id(inner): method.name for method in walked(tree) if isinstance(method, ast.FunctionDef) for inner in ast.walk(method)
        }
        used = {id(node.value) for node in walked(tree) if isinstance(node, ast.Attribute)}
        for node in walked(tree):
            called = name_of_call(node)
            if called.endswith('_set_parameters_callback'):
                return None
            reads = (
                called in GETTERS
                and isinstance(node, ast.Call)
                and any(isinstance(word, ast.Constant) and word.value == name for word in node.args)
            )
            if called in ('get_parameters', 'get_parameters_by_prefix'):
                return None
            if reads and called != 'declare_parameter' and inside.get(id(node)) != '__init__':
                return None
            if reads and isinstance(node, ast.Call) and (called != 'declare_parameter' or id(node) in used):
                place = (file, node.lineno)
    return place


def _static_publishers(recording: Recording) -> Iterator[tuple[ProcessRecord, list[str]]]:
    for process in recording.processes:
        if process.executable == 'static_transform_publisher' or 'static_transform_publisher' in process.argv[:4]:
            words = process.argv[: process.argv.index('--ros-args')] if '--ros-args' in process.argv else process.argv
            start = next(number for number, word in enumerate(words) if word.endswith('static_transform_publisher'))
            yield process, words[start + 1 :]


def _place(process: ProcessRecord) -> dict[str, Any]:
    return {'file': process.file, 'line': process.line, 'time_s': process.started_s}


ORDER = ('--x', '--y', '--z', '--yaw', '--pitch', '--roll')
"""The order of the numbers without option names."""
OPTIONS = (
    *('--x', '--y', '--z', '--qx', '--qy', '--qz', '--qw', '--roll', '--pitch', '--yaw', '--frame-id', '--child-frame-id'),
    *('--help', '-h'),
)


@rule(
    'tf.unknown-option',
    what='static_transform_publisher has no option {option}',
    why='the program ends at once, so it does not broadcast the frame',
    do=('write {near}', 'use these options: --x --y --z --yaw --pitch --roll --frame-id --child-frame-id'),
    lesson='08_static_broadcaster',
    level='error',
    hides=('programs.died',),
)
def unknown_option(recording: Recording) -> Iterator[Finding]:
    """Report the first unknown option of a static_transform_publisher that has ended with an error."""
    for process, words in _static_publishers(recording):
        unknown = [word for word in words if word.startswith('--') and ' ' not in word and word not in OPTIONS]
        if unknown and process.returncode:
            begins = [option for option in OPTIONS if option.startswith(unknown[0])]
            near = begins[0] if begins else nearest(unknown[0], OPTIONS)
            yield found('process', process.name, **_place(process), option=unknown[0], near=near)


@rule(
    'tf.few-arguments',
    what='static_transform_publisher receives {count} numbers, and no frames',
    why='the program ends at once, so it does not broadcast the frame',
    do='write option names, and both frames: {options} --frame-id PARENT --child-frame-id CHILD',
    lesson='08_static_broadcaster',
    level='error',
    hides=('programs.died',),
)
def few_arguments(recording: Recording) -> Iterator[Finding]:
    """Report the six numbers without the names of the frames."""
    for process, words in _static_publishers(recording):
        if process.returncode and len(words) == len(ORDER) and all(_number(word) is not None for word in words):
            options = ' '.join(f'{name} {word}' for name, word in zip(ORDER, words, strict=True))
            yield found('process', process.name, **_place(process), count=len(words), options=options)


@rule(
    'tf.degrees',
    what='{process} rotates its frame by {option} {value}, which is more than a full turn in radians',
    why='all angles in ROS 2 are in radians: a quarter turn is 1.5708, and a full turn is 6.2832',
    do='write {option} {radians}',
    lesson='08_static_broadcaster',
    confidence='asked',
)
def static_degrees(recording: Recording) -> Iterator[Finding]:
    """Report an angle of a static_transform_publisher that is larger than a full turn."""
    for process, words in _static_publishers(recording):
        old = list(zip(('yaw', 'pitch', 'roll'), words[3:6], strict=False)) if _is_old(words) else []
        for option, text in [*zip(words, words[1:], strict=False), *old]:
            value = _number(text)
            if option in ('--yaw', '--pitch', '--roll', 'yaw', 'pitch', 'roll') and value is not None and abs(value) > 6.3:
                facts: dict[str, Any] = {'option': option, 'value': text, 'radians': f'{math.radians(value):.4f}'}
                yield found('process', process.name, **_place(process), **facts)


@rule(
    'tf.old-order',
    what='{process} rotates its frame by {angle} about the x axis (roll), and not about the z axis (yaw)',
    why='without option names, the order is x y z yaw pitch roll',
    do='use option names: --x {x} --y {y} --z {z} --yaw {angle} --frame-id {parent} --child-frame-id {child}',
    lesson='08_static_broadcaster',
    confidence='asked',
)
def old_order(recording: Recording) -> Iterator[Finding]:
    """Report a static_transform_publisher with eight arguments without options, in which only the last angle is not 0."""
    for process, words in _static_publishers(recording):
        if _is_old(words) and not _number(words[3]) and not _number(words[4]) and _number(words[5]):
            x, y, z, _, _, angle, parent, child = words
            facts: dict[str, Any] = {'angle': angle, 'x': x, 'y': y, 'z': z, 'parent': parent, 'child': child}
            yield found('process', process.name, **_place(process), **facts)


def _is_old(words: list[str]) -> bool:
    return len(words) == 8 and all(_number(word) is not None for word in words[:6])


def _number(text: str) -> float | None:
    try:
        return float(text)
    except ValueError:
        return None


@rule(
    'launch.arguments-in-one',
    what="{process} receives the single argument '{text}' with spaces, but it expects several arguments",
    why='launch passes each entry of the list as one word, and only a shell splits at spaces',
    do='write each word as a separate string: {entries}',
    lesson='08_static_broadcaster',
    level='error',
    hides=('programs.died',),
)
def arguments_in_one(recording: Recording) -> Iterator[Finding]:
    """Report an argument of a program that begins with an option, or with several numbers, and continues after a space.

    Long options of ROS begin with two dashes in the cure, such as `--remap` for `-remap`.
    """
    for process in recording.processes:
        for word in process.argv[1:] if process.package else ():
            if re.match(r'--?[a-z][\w-]* \S|(-?[\d.]+ ){3}', word):
                words = (re.sub('^-(ros-args|remap|param|params-file|log-level)$', r'--\1', one) for one in word.split()[:8])
                entries = ', '.join(map(repr, words))
                yield found('process', process.name, **_place(process), text=word[:80], entries=entries)

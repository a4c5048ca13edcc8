"""Rules about wrong arguments of a node's methods: types, topics, periods and requests."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator
from linecache import getline

from edulaunch.advice.errors.about import report
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.advice.run_sources import name_of_call, script_of

LESSON = '14_services'


def calls_on_line(failure: Failure) -> list[ast.Call]:
    """Return the calls on the failing line, from the outermost to the innermost."""
    tree = script_of(failure.file)
    nodes = [] if tree is None else [node for node in ast.walk(tree) if isinstance(node, ast.Call)]
    return [call for call in nodes if call.lineno <= (failure.line or 0) <= (call.end_lineno or 0)]


@rule(
    'messages.type-as-text',
    what=(
        '{method}() needs the type first and then the name, but here the name {text} comes before {second}',
        '{method}() needs the class of the type, but {text} is a string',
    ),
    do=('write {method}({second}, {text}, ...)', 'write {word} without quotes, and import it'),
    lesson='09_broadcaster_and_listener',
    level='error',
)
def type_as_text(failure: Failure) -> Iterator[Finding]:
    """Report a message type that is given as a string or swapped with the topic, as in `create_subscription('Pose', ...)`."""
    as_type, as_name = (
        r"type object 'str' has no attribute '_TYPE_SUPPORT'",
        r'incompatible function arguments: a name .* not Metaclass_',
    )
    if not re.match(f'{as_type}|{as_name}', failure.message):
        return
    for call in calls_on_line(failure):
        arguments = [*call.args, *[ast.Constant(None)] * 2][:2]
        if (
            name_of_call(call).startswith('create_')
            and isinstance(arguments[0], ast.Constant)
            and isinstance(arguments[0].value, str)
        ):
            second = ast.unparse(arguments[1]) if isinstance(arguments[1], (ast.Name, ast.Attribute)) else None
            word = re.split(r'[/.]', arguments[0].value)[-1]
            yield report(failure, method=name_of_call(call), text=repr(arguments[0].value), second=second, word=word)
            return


@rule(
    'programs.timer-order',
    what='create_timer() needs the period in seconds first and then the function, but here the function comes first',
    do='write create_timer({second}, {first})',
    lesson='14_services',
    level='error',
)
def timer_order(failure: Failure) -> Iterator[Finding]:
    """Report swapped arguments of create_timer, as in `create_timer(self.tick, 1.0)`."""
    if not re.match(r"float\(\) argument must be a string or a real number, not '(method|function)'", failure.message):
        return
    for call in calls_on_line(failure):
        if name_of_call(call) == 'create_timer' and len(call.args) > 1:
            yield report(failure, first=ast.unparse(call.args[0]), second=ast.unparse(call.args[1]))
            return


@rule(
    'messages.service-class',
    what='{service}() is not possible: only its Request and its Response can be created',
    do='write {service}.Request()',
    lesson=LESSON,
    level='error',
)
def service_class(failure: Failure) -> Iterator[Finding]:
    """Report a service class in place of a request object, as in `client.call_async(Spawn())`."""
    if failure.message == 'Service classes can not be instantiated':
        made = [call.func for call in calls_on_line(failure) if isinstance(call.func, ast.Name)]
        yield report(failure, service=next((one.id for one in made if one.id[:1].isupper()), 'the service class'))


@rule(
    'programs.parameter-object',
    what=(
        'this line uses the object that {getter} returns, instead of the value in it',
        'this line uses a Parameter object instead of its value',
    ),
    why='get_parameter() returns an object with the name, the type and the value',
    do=(
        'write .value in place of .{getter}, or add the field of its type, such as .double_value',
        'write .value after get_parameter(...)',
    ),
    lesson='03_parameters',
    level='error',
    hides=('messages.field-value',),
)
def parameter_object(failure: Failure) -> Iterator[Finding]:
    """Report a Parameter object in place of its value, as in `self.get_parameter('speed') * 2` or in a field of a message."""
    used = re.search(
        r"'(Parameter(?:Value)?)'(?: and '|$|:? )|and '(Parameter(?:Value)?)'|not '?(Parameter(?:Value)?)'?$", failure.message
    )
    given = str(failure.facts.get('given')).rpartition('.')[2]
    if given in ('Parameter', 'ParameterValue') or (failure.type == 'TypeError' and used is not None and failure.process):
        is_inner = given == 'ParameterValue' or (used is not None and 'ParameterValue' in used.groups())
        yield report(failure, getter='get_parameter_value()' if is_inner else None)


@rule(
    'programs.local-not-attribute',
    what='line {made} stores {attribute} in a local variable, so self.{attribute} does not exist',
    why='a local variable exists only until its method returns; other methods see only attributes of self',
    do='write self.{attribute} = ... on line {made}',
    level='error',
)
def local_not_attribute(failure: Failure) -> Iterator[Finding]:
    """Report a callback that reads `self.pub` although the constructor stored the object in the local variable `pub`."""
    match = re.fullmatch(r"'(\w+)' object has no attribute '(\w+)'", failure.message)
    tree = script_of(failure.file) if match is not None else None
    if match is None or tree is None:
        return
    for owner in ast.walk(tree):
        if isinstance(owner, ast.ClassDef) and owner.name == match[1]:
            added = {id(node.target) for node in ast.walk(owner) if isinstance(node, ast.AugAssign)}  # += needs an earlier value
            stores = [node for node in ast.walk(owner) if isinstance(node, (ast.Name, ast.Attribute)) and id(node) not in added]
            local = [node for node in stores if isinstance(node, ast.Name) and node.id == match[2] and _is_stored(node)]
            attributes = [
                node for node in stores if isinstance(node, ast.Attribute) and node.attr == match[2] and _is_stored(node)
            ]
            if local and not attributes:
                yield report(failure, attribute=match[2], made=local[0].lineno)


def _is_stored(node: ast.Name | ast.Attribute) -> bool:
    return isinstance(node.ctx, ast.Store)


CALLED_WITH = {
    'create_service': (2, 'request, response'),
    'create_timer': (1, ''),
    'ActionServer': (3, 'goal_handle'),
    'add_done_callback': (0, 'future'),
}
"""The calls that receive a function: its position, and the arguments with which rclpy calls it."""


@rule(
    'programs.callback-signature',
    what=(
        'rclpy calls the callback {method}() of {made_by}() with the arguments {parameters}, but it has other parameters',
        'rclpy calls the callback {method}() of {made_by}() without arguments, but it has parameters',
    ),
    do=('write def {method}(self, {parameters})', 'write def {method}(self)'),
    lesson=LESSON,
    level='error',
)
def callback_signature(failure: Failure) -> Iterator[Finding]:
    """Report a callback with the wrong parameters. The callback may belong to a service, a timer, an action or a future."""
    match = re.match(r'(?:\w+\.)?(\w+)\(\) (?:takes [1-9]|missing \d+ ).*argument', failure.message)
    tree = script_of(failure.file) if match is not None and failure.process is not None else None
    if match is None or tree is None or any(name_of_call(call) == match[1] for call in calls_on_line(failure)):
        return
    defined = next((node for node in ast.walk(tree) if isinstance(node, ast.FunctionDef) and node.name == match[1]), None)
    for call in ast.walk(tree) if defined is not None else ():
        made_by = name_of_call(call)
        number, parameters = CALLED_WITH.get(made_by, (0, ''))
        given = call.args[number : number + 1] if made_by in CALLED_WITH and isinstance(call, ast.Call) else []
        if defined is not None and any(ast.unparse(one).endswith(match[1]) for one in given):
            facts = {'method': match[1], 'made_by': made_by, 'parameters': parameters or None}
            yield report(failure, **facts)._replace(line=defined.lineno)
            return


PARTS = {'float': 'double_value', 'int': 'integer_value', 'bool': 'bool_value', 'str': 'string_value'}


@rule(
    'programs.other-part-of-value',
    what='this line reads .{read} of the parameter, but a field of type {wanted} needs .{part}',
    why='each part of a ParameterValue has its own type, and all parts except the part of the value are empty or 0',
    do='write .{part} instead of .{read}, or get the value of any type with get_parameter(...).value',
    lesson='03_parameters',
    level='error',
    hides=('messages.field-value',),
    edits=(('.{read}', '.{part}'),),
)
def other_part_of_value(failure: Failure) -> Iterator[Finding]:
    """Report a wrong part of a ParameterValue in a field of a message, as in `msg.x = value.integer_value`."""
    part = PARTS.get(str(failure.facts.get('wanted')))
    if failure.facts.get('about') == 'messages.field-value' and part is not None and failure.process is not None:
        read = re.findall(r'\.((?:double|integer|bool|string)_value)\b', getline(failure.file or '', failure.line or 0))
        if len(read) == 1 and read[0] != part:
            yield report(failure, read=read[0], part=part)


@rule(
    'programs.attribute-never-set',
    what=(
        'line {line_read} reads self.{attribute}, but line {inside} defines {attribute}() inside another function',
        'line {line_read} reads self.{attribute}, but no line of the class {klass} gives it a value',
    ),
    why=(
        'the indentation makes {inner}() a local function, not a method of the class',
        'an attribute exists only after its first assignment, so assign it in the constructor',
    ),
    do=(
        'indent `def {inner}` on line {inside} as deep as `def __init__`, and its body four spaces deeper',
        'write self.{near} if you mean that one, or self.{attribute} = ... in __init__ of {klass}',
        'write self.{attribute} = ... in __init__ of {klass}',
    ),
    lesson='00_python',
    level='error',
)
def attribute_never_set(failure: Failure) -> Iterator[Finding]:
    """Report an attribute of a student's class that no line of the file assigns. Other rules are about methods of Node."""
    match = re.fullmatch(r"'(\w+)' object has no attribute '([a-z]\w*)'(?:\. Did you mean: '(\w+)'\?)?", failure.message)
    tree = script_of(failure.file) if match is not None and failure.process is not None else None
    if match is None or tree is None:
        return
    for owner in (node for node in ast.walk(tree) if isinstance(node, ast.ClassDef) and node.name == match[1]):
        inner = list(ast.walk(owner))
        added = {id(node.target) for node in inner if isinstance(node, ast.AugAssign)}  # += needs an earlier value

        uses = [node for node in inner if isinstance(node, ast.Attribute) and node.attr == match[2]]
        is_set = any(_is_stored(node) and id(node) not in added for node in uses)
        is_called = any(name_of_call(node) == match[2] for node in inner)
        has_local = any(isinstance(node, ast.Name) and node.id == match[2] for node in inner)
        if uses and not (is_set or is_called or has_local):
            methods = {id(node) for node in owner.body}
            functions = [node for node in inner if isinstance(node, ast.FunctionDef) and node.name == match[2]]
            inside = next((node.lineno for node in functions if id(node) not in methods), None)
            facts = {'attribute': match[2], 'klass': match[1], 'near': match[3], 'line_read': failure.line}
            facts |= {'inside': inside, 'inner': match[2] if inside else None}
            yield report(failure, **facts)

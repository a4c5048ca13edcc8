"""Rules about common mistakes in calls for which Python's message is too general: brackets, arguments, futures, constructors."""

from __future__ import annotations

import ast
import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import report
from edulaunch.advice.errors.node_calls import calls_on_line
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.advice.run_sources import name_of_call, script_of

FORMS = (
    (r'.*\.(lookup_transform)\(\) missing', 'lookup_transform(target_frame, source_frame, Time())'),
    (r'.*\.(can_transform)\(\) missing', 'can_transform(target_frame, source_frame, Time())'),
    (r'.*\.(call_async)\(\) missing', 'client.call_async(request)'),
    (r'(spin_until_future_complete)\(\) missing', 'rclpy.spin_until_future_complete(node, future)'),
    (r'(TransformBroadcaster)\.__init__\(\) missing', 'TransformBroadcaster(self)'),
    (r'(StaticTransformBroadcaster)\.__init__\(\) missing', 'StaticTransformBroadcaster(self)'),
    (r'(TransformListener)\.__init__\(\) missing', 'TransformListener(self.buffer, self)'),
    (r'RcutilsLogger\.(debug|info|warning|warn|error|fatal)\(\) takes 2 positional', "get_logger().{}(f'speed: {{speed}}')"),
    (r'(Node)\.__init__\(\) takes 2 positional', "super().__init__('node_name')"),
    (r'Invalid parameter tuple length', "declare_parameters('', [('speed', 1.0), ('name', 'robo')])"),
    (r'(QoSProfile)\.__init__\(\) takes 1 positional', 'QoSProfile(depth=10)'),
    (r"'Buffer' object has no attribute '(?:create_|get_|destroy_|declare_)", 'TransformListener(self.buffer, self)'),
    (r'parameter must be instance of type', "set_parameters([Parameter('speed', value=0.4)])"),
    (r'incompatible function arguments: a name must be a str, not (?:method|function)', 'create_service(Type, name, callback)'),
)
"""For each called function, the beginning of Python's message, and the correct form of the call."""
LAUNCH_FORMS = (
    (r'LaunchDescription\.(add_action)\(\) takes 2 positional', '{}(action) once for each action'),
    (r'(generate_launch_description)\(\) missing \d+ required', 'def {}() without parameters'),
)
"""The same for functions that launch files call."""


@rule(
    'programs.wrong-call',
    what='{call}() was called with arguments that it does not accept',
    do='write the call as {form}',
    level='error',
)
def wrong_call(failure: Failure) -> Iterator[Finding]:
    """Report a call of a ROS 2 function with too few arguments, too many arguments, or arguments in the wrong order."""
    for pattern, form in LAUNCH_FORMS if failure.process is None else FORMS:
        match = re.match(pattern, failure.message)
        if match is not None:
            name = match[1] if match.groups() else form.partition('(')[0]
            yield report(failure, call=name, form=form.format(name))
            return


@rule(
    'programs.brackets-missing',
    what=(
        '{called} has no parentheses, so Python does not call it',
        '{klass} is a class, but an object of this class is needed here',
    ),
    do=('write {called}()', 'create an object with parentheses: {klass}()'),
    level='error',
)
def brackets_missing(failure: Failure) -> Iterator[Finding]:
    """Report a missing pair of brackets, as in `self.get_logger.info(...)` or `Twist.linear.x = 0.2`."""
    match = re.match(r"'(function|method|property)' object has no attribute '(\w+)'", failure.message)
    compared = re.match(r"'[<>]=?' not supported between instances of ('property'|.* and 'property')", failure.message)
    tree = script_of(failure.file) if failure.process is not None and (match or compared) else None
    nodes = [] if tree is None else [node for node in ast.walk(tree) if getattr(node, 'lineno', 0) == failure.line]
    if match is not None and match[1] != 'property':
        holders = [node.value for node in nodes if isinstance(node, ast.Attribute) and node.attr == match[2]]
        for holder in holders[:1]:
            yield report(failure, called=ast.unparse(holder))
        return
    arguments = [word for call in nodes if isinstance(call, ast.Call) for word in call.args]
    owners = [node.value for node in nodes if isinstance(node, ast.Attribute)] if match is not None else arguments
    classes = [node.id for node in owners if isinstance(node, ast.Name) and node.id[:1].isupper()]
    for name in classes[:1]:
        yield report(failure, klass=name)


@rule(
    'programs.not-callable',
    what='{called} is a value of type {type}, not a function, so Python cannot call it',
    do='write {called} without the parentheses ()',
    level='error',
)
def not_callable(failure: Failure) -> Iterator[Finding]:
    """Report brackets after something that is not a function, as in `message.x()`.

    The rule reports such a call only if it is the only call without arguments on its line.
    """
    match = re.fullmatch(r"'(float|int|bool|str|list|QoSProfile)' object is not callable", failure.message)
    tree = script_of(failure.file) if failure.process is not None and match is not None else None
    calls = (
        [] if tree is None else [node for node in ast.walk(tree) if isinstance(node, ast.Call) and node.lineno == failure.line]
    )
    empty = [ast.unparse(call.func) for call in calls if not call.args and not call.keywords]
    if match is not None and len(empty) == 1:
        yield report(failure, called=empty[0], type=match[1])


@rule(
    'programs.method-replaced',
    what='this line gives self.{method} a value, which replaces the method {method}() of line {defined}',
    why='Python finds the attribute of an object before the method of its class',
    do='use another name for the attribute or for the method',
    lesson='00_python',
    level='error',
    hides=('programs.not-callable',),
)
def method_replaced(failure: Failure) -> Iterator[Finding]:
    """Report an attribute with the name of a method of its class, if a program calls it as the method."""
    tree = script_of(failure.file) if failure.process is not None and failure.message.endswith('object is not callable') else None
    for owner in (node for node in ast.walk(tree) if isinstance(node, ast.ClassDef)) if tree is not None else ():
        methods = {node.name: node.lineno for node in owner.body if isinstance(node, ast.FunctionDef)}
        for node in ast.walk(owner):
            is_own = isinstance(node, ast.Attribute) and isinstance(node.ctx, ast.Store) and ast.unparse(node.value) == 'self'
            if is_own and isinstance(node, ast.Attribute) and node.attr in methods:
                yield report(failure._replace(line=node.lineno), method=node.attr, defined=methods[node.attr])


@rule(
    'programs.no-local-value',
    what='this function assigns {variable}, so Python does not use the {variable} of the file, and {variable} has no value yet',
    why='a name that a function assigns anywhere is a local variable in the whole function',
    do='write `global {variable}` as the first line of the function, or use self.{variable} and set it in the constructor',
    lesson='00_python',
    level='error',
)
def no_local_value(failure: Failure) -> Iterator[Finding]:
    """Report a method that changes a global variable without `global`, as in `count += 1`."""
    match = re.match(r"(?:cannot access local variable|local variable) '(\w+)'", failure.message)
    if failure.type != 'UnboundLocalError' or match is None:
        return
    assigned = [node for node in getattr(script_of(failure.file), 'body', ()) if isinstance(node, ast.Assign)]
    if any(isinstance(target, ast.Name) and target.id == match[1] for node in assigned for target in node.targets):
        yield report(failure, variable=match[1])


@rule(
    'programs.future-no-answer',
    what='{future} is a future, and only future.result() returns the reply with {attribute}',
    do='write {future}.result().{attribute} after the reply has arrived',
    lesson='14_services',
    level='error',
)
def future_no_answer(failure: Failure) -> Iterator[Finding]:
    """Report a field of a reply that the program reads from the future, as in `future.sum`."""
    match = re.match(r"'Future' object has no attribute '(\w+)'", failure.message)
    tree = script_of(failure.file) if failure.process is not None and match is not None else None
    if match is None or tree is None:
        return
    for node in ast.walk(tree):
        if isinstance(node, ast.Attribute) and node.attr == match[1] and node.lineno == failure.line:
            yield report(failure, future=ast.unparse(node.value), attribute=match[1])
            return


@rule(
    'programs.goal-handle-no-result',
    what='this future has the goal handle of an accepted goal, and not the result of the goal',
    why='the server first accepts a goal, and sends the result when the goal has ended',
    do='write future.result().get_result_async().add_done_callback(self.on_result), and read the result in on_result()',
    lesson='14_services',
    level='error',
)
def goal_handle_no_result(failure: Failure) -> Iterator[Finding]:
    """Report `future.result().result` for the future of send_goal_async(). The result of this future is a goal handle."""
    if failure.process is not None and failure.message.startswith("'ClientGoalHandle' object has no attribute 'result'"):
        yield report(failure)


@rule(
    'programs.init-misspelt',
    what=(
        'Python never calls {method}() of {klass}, because the constructor must be called __init__',
        'this line calls {called}() of super(), but the constructor is called __init__',
    ),
    do=('write {wanted} with two underscores on each side',),
    level='error',
)
def init_misspelt(failure: Failure) -> Iterator[Finding]:
    """Report a misspelt constructor such as `def _init_(self):`, or a call of a misspelt constructor."""
    called = re.match(r"'super' object has no attribute '(?:_[A-Za-z]\w*?)??(_{1,2}(?:init|int|inti)_{0,2})'", failure.message)
    if called is not None:
        yield report(failure, called=called[1], wanted='super().__init__(...)')
    tree = script_of(failure.file) if failure.message.startswith('Node.__init__() missing 1 required') else None
    for klass in [] if tree is None else ast.walk(tree):
        names = [node.name for node in klass.body if isinstance(node, ast.FunctionDef)] if isinstance(klass, ast.ClassDef) else []
        if '__init__' not in names:
            for name in names:
                if re.fullmatch(r'_{0,3}(init|int|inti)_{0,3}', name):
                    yield report(failure, method=name, klass=klass.name, wanted='def __init__(self)')  # type: ignore[attr-defined]


@rule(
    'messages.fields-by-name',
    what='{type}() needs its fields by name',
    do=('write {type}(data=...)', 'write the name of each field, as in {type}(x=1.0, y=2.0)'),
    level='error',
)
def fields_by_name(failure: Failure) -> Iterator[Finding]:
    """Report positional arguments of a message class, as in `String('hello')`."""
    match = re.match(r'(\w+)\.__init__\(\) takes 1 positional argument but \d+ were given', failure.message)
    tree = script_of(failure.file) if failure.process is not None and match is not None else None
    if match is None or tree is None:
        return
    for node in ast.walk(tree):
        home = (node.module or '') if isinstance(node, ast.ImportFrom) else ''
        if home.endswith(('.msg', '.srv')) and any(match[1] in (name.name, name.asname) for name in node.names):  # type: ignore[attr-defined]
            yield report(failure, type=match[1], data='data' if home == 'std_msgs.msg' else None)
            return


@rule(
    'programs.parameter-no-value',
    what="the parameter '{parameter}' has no value, because it has no default and no launch file sets it",
    do="pass a second argument to declare_parameter('{parameter}'), or set the parameter in the launch file",
    lesson='03_parameters',
    level='error',
    hides=('messages.field-value',),
)
def parameter_no_value(failure: Failure) -> Iterator[Finding]:
    """Report a parameter without a value, if a program reads the parameter or assigns it to a field of a message."""
    unset = re.match(r"The parameter '(\S+)' is not initialized", failure.message)
    if unset is not None and failure.process is not None:
        yield report(failure, parameter=unset[1])
    is_none = failure.facts.get('about') == 'messages.field-value' and failure.facts.get('given') == 'None'
    tree = script_of(failure.file) if is_none and any(map(_reads_parameter, calls_on_line(failure))) else None
    for call in [] if tree is None else ast.walk(tree):
        words = [*call.args, *call.keywords] if isinstance(call, ast.Call) and name_of_call(call) == 'declare_parameter' else []
        if len(words) == 1 and isinstance(words[0], ast.Constant):
            yield report(failure, parameter=words[0].value)
            return


def _reads_parameter(call: ast.Call) -> bool:
    return name_of_call(call) == 'get_parameter'

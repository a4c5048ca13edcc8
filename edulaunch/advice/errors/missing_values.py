"""Rules about values that do not exist yet when a line uses them: environment variables, replies, launch arguments and
conversions.
"""

from __future__ import annotations

import ast
import linecache
import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import report
from edulaunch.advice.launch_names import class_named
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.advice.run_sources import keyword_of, name_of_call, script_of

MODELS = {'TURTLEBOT3_MODEL': 'burger', 'LINOROBOT2_BASE': '2wd', 'LDS_MODEL': 'LDS-01'}
"""Values that tutorials set."""
LONGEST = 200_000


def _line(failure: Failure) -> str:
    return linecache.getline(failure.file or '', failure.line or 0)


@rule(
    'programs.no-variable',
    what="the environment variable '{variable}' is not set in this terminal",
    why="os.environ['{variable}'] raises KeyError if the variable is not set",
    do=(
        'run `export {variable}={example}` and start the program again, or use a default value: os.environ.get({quoted}, ...)',
        'run `export {variable}=...` and start the program again, or use a default value: os.environ.get({quoted}, ...)',
    ),
    level='error',
    hides=('launch.fails',),
)
def no_variable(failure: Failure) -> Iterator[Finding]:
    """Report a missing environment variable in a launch file or a program, as in `os.environ['NAME']`."""
    match = re.fullmatch(r"'(\w+)'", failure.message)
    if failure.type == 'KeyError' and match is not None and 'environ' in _line(failure):
        yield report(failure, variable=match[1], example=MODELS.get(match[1]), quoted=repr(match[1]))


@rule(
    'programs.result-too-early',
    what='result() of this future returns None, because the reply has not arrived yet',
    why='call_async() only sends the request; the node receives the reply later, while it spins',
    do=(
        'in main(), call rclpy.spin_until_future_complete(node, future); in a callback, call '
        'future.add_done_callback(self.on_answer)'
    ),
    lesson='14_services',
    level='error',
    hides=('programs.result-before-reply',),
)
def result_too_early(failure: Failure) -> Iterator[Finding]:
    """Report the use of a future's result before it exists.

    The failing line reads an attribute of None. The None comes from `.result()` on this line, or from a variable that a line
    above has assigned from `.result()`.
    """
    if failure.type != 'AttributeError' or not failure.message.startswith("'NoneType' object has no attribute"):
        return
    above = [
        linecache.getline(failure.file or '', number) for number in range(max(1, (failure.line or 1) - 8), failure.line or 1)
    ]
    held = {match[1] for line in above if (match := re.match(r'\s*([\w.]+)\s*(?::[^=]+)?=\s*.*\.result\(\)', line))}
    line = _line(failure)
    if '.result()' in line or any(re.search(rf'(?<![\w.]){re.escape(name)}\.', line) for name in held):
        yield report(failure)


@rule(
    'launch.path-too-early',
    what='{given} is not a path while Python reads the launch file, so os.path cannot join it',
    why='a substitution gets its value when launch starts the action',
    do=(
        "write PathJoinSubstitution([FindPackageShare('my_package'), 'file']), or get the path at once with "
        "get_package_share_directory('my_package')",
        "let launch join the path: PathJoinSubstitution([{given}(...), 'file'])",
    ),
    lesson='07_packages',
    level='error',
    hides=('launch.fails',),
)
def path_too_early(failure: Failure) -> Iterator[Finding]:
    """Report a substitution in place of a path, as in `os.path.join(FindPackageShare('robo'), 'config')`."""
    match = re.match(r'(?:expected str, bytes or os.PathLike object|.*should be string.*), not (\w+)', failure.message)
    if match is not None and hasattr(class_named(match[1]), 'perform'):
        yield report(failure, given=match[1])


@rule(
    'launch.condition-word',
    what="the condition tests the string '{word}', not the launch argument with that name",
    why='a condition uses a string as it is; only a LaunchConfiguration returns the value of an argument',
    do="write {condition}(LaunchConfiguration('{word}'))",
    lesson='04_conditions',
    level='error',
    hides=('launch.condition-value',),
)
def condition_word(failure: Failure) -> Iterator[Finding]:
    """Report a condition that is a plain word, as in `IfCondition('gui')`. The rule reads the file that failed."""
    match = re.match(r"invalid condition expression.* but got '(\w+)'", failure.message)
    lines = _lines(failure.file) if match is not None and failure.file else []
    if match is not None and any(re.search(rf"""DeclareLaunchArgument\(.*['"]{match[1]}['"]""", line) for line in lines):
        for number, line in enumerate(lines, 1):
            written = re.search(rf"""(IfCondition|UnlessCondition)\(\s*(['"]){match[1]}\2\s*\)""", line)
            if written is not None:
                yield report(failure._replace(line=number), word=match[1], condition=written[1])
                return


@rule(
    'launch.declared-after-use',
    what="the launch argument '{configuration}' is used before its declaration on line {declared}",
    why='launch executes the actions of a list in order, so the argument has no value before its declaration',
    do=(
        'move <{element} name="{configuration}" .../> before this line',
        "move DeclareLaunchArgument('{configuration}', ...) to the beginning of the list",
    ),
    lesson='01_first_launch',
    level='error',
    hides=('launch.no-configuration',),
)
def declared_after_use(failure: Failure) -> Iterator[Finding]:
    """Report a launch argument that its file declares only after the first use."""
    match = re.fullmatch(r"launch configuration '(.*)' does not exist", failure.message)
    if match is not None and (failure.file or '').endswith('.xml'):
        yield from _declared_below(failure, match[1])
    tree = script_of(failure.file) if match is not None else None
    if match is None or tree is None:
        return
    for call in ast.walk(tree):
        if isinstance(call, ast.Call) and name_of_call(call) == 'DeclareLaunchArgument':
            name = call.args[0] if call.args else keyword_of(call, 'name')
            if isinstance(name, ast.Constant) and name.value == match[1] and _comes_later(tree, call.lineno, failure.line or 0):
                yield report(failure, configuration=match[1], declared=call.lineno)
                return


def _declared_below(failure: Failure, name: str) -> Iterator[Finding]:
    """Report an <arg> or <let> that an XML launch file contains only after the use of its name."""
    for number, line in enumerate(linecache.getlines(failure.file or ''), 1):
        element = re.search(rf'<(arg|let)\b[^>]*\bname=["\']{re.escape(name)}["\']', line)
        if element is not None and number > (failure.line or 0):
            yield report(failure, configuration=name, declared=number, element=element[1])
            return


def _comes_later(tree: ast.Module, declared: int, used: int) -> bool:
    """Return whether the action on line `declared` comes after the action on line `used`.

    Compare their positions in the file or, for variables that contain actions, in a list.
    """
    lines = {
        node.targets[0].id: node.value.lineno
        for node in ast.walk(tree)
        if isinstance(node, ast.Assign) and isinstance(node.targets[0], ast.Name)
    }
    for items in (node.elts for node in ast.walk(tree) if isinstance(node, ast.List)):
        order = [lines.get(item.id, 0) if isinstance(item, ast.Name) else item.lineno for item in items]
        if declared in order and used in order:
            return order.index(declared) > order.index(used)
    return declared > used


@rule(
    'launch.set-in-group',
    what="'{configuration}' is set inside a GroupAction, and the group ends before this use",
    why='a value that a group sets is valid only inside that group',
    do='add scoped=False to the group, or move this use into the group',
    lesson='01_first_launch',
    level='error',
    hides=('launch.no-configuration', 'launch.declared-after-use'),
)
def set_in_group(failure: Failure) -> Iterator[Finding]:
    """Report a launch configuration that the file sets only inside a GroupAction."""
    match = re.fullmatch(r"launch configuration '(.*)' does not exist", failure.message)
    tree = script_of(failure.file) if match is not None else None
    if match is None or tree is None:
        return
    for group in ast.walk(tree):
        if isinstance(group, ast.Call) and name_of_call(group) == 'GroupAction' and keyword_of(group, 'scoped') is None:
            sets = [call for call in ast.walk(group) if isinstance(call, ast.Call) and name_of_call(call) in SETTING]
            if any(isinstance(word, ast.Constant) and word.value == match[1] for call in sets for word in call.args[:1]):
                yield report(failure, configuration=match[1])
                return


SETTING = ('SetLaunchConfiguration', 'DeclareLaunchArgument')


@rule(
    'launch.class-for-action',
    what='{given} has no parentheses, so it is a class, not an action',
    why='launch calls a handler with the event and the context, and this class does not accept these arguments',
    do='write {keyword}={given}()',
    lesson='05_events',
    level='error',
    hides=('launch.positional', 'launch.call'),
)
def class_for_action(failure: Failure) -> Iterator[Finding]:
    """Report a class in place of an action, as in `on_exit=Shutdown`."""
    match = re.match(r'(\w+)\.__init__\(\) takes 1 positional argument but 3 were given', failure.message)
    if match is not None:
        yield report(failure, given=match[1], keyword='on_exit' if match[1] == 'Shutdown' else 'on_start')


def _lines(file: str) -> list[str]:
    """Return the lines of a Python launch file. Return an empty list for another file or a very long file."""
    lines = linecache.getlines(file) if file.endswith('.py') else []
    return lines if sum(map(len, lines)) < LONGEST else []


CONVERTERS = {'geometry_msgs': 'tf2_geometry_msgs', 'sensor_msgs': 'tf2_sensor_msgs'}


@rule(
    'tf.no-converter',
    what='tf2 cannot transform a {kind_of} until the program imports {converter}',
    why='that import registers the conversions for messages of {package}; tf2 itself has none',
    do='write at the top of the program: import {converter}',
    lesson='09_broadcaster_and_listener',
    level='error',
)
def no_converter(failure: Failure) -> Iterator[Finding]:
    """Report `buffer.transform(pose, 'map')` without the import that registers the conversion."""
    match = re.match(r"Type <class '(\w+)\.msg\.\w+\.(\w+)'> is not loaded or supported", failure.message)
    if match is not None and match[1] in CONVERTERS:
        yield report(failure, package=match[1], kind_of=match[2], converter=CONVERTERS[match[1]])


ELSEWHERE = {
    'Duration': 'rclpy.duration',
    'Node': 'rclpy.node',
    'QoSProfile': 'rclpy.qos',
    'Time': 'rclpy.time',
    'remove_ros_args': 'rclpy.utilities',
}
"""Names that programs expect in `rclpy` itself, with the modules that contain them."""


@rule(
    'programs.other-module',
    what='{part} is part of {module}, not of rclpy itself',
    do='write: from {module} import {part}',
    level='error',
)
def other_module(failure: Failure) -> Iterator[Finding]:
    """Report a name such as `rclpy.remove_ros_args` that is not in `rclpy` itself, but in one of its modules."""
    match = re.match(r"module 'rclpy' has no attribute '(\w+)'", failure.message)
    if match is not None and match[1] in ELSEWHERE:
        yield report(failure, part=match[1], module=ELSEWHERE[match[1]])

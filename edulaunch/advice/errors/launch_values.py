"""Rules about values that launch computes during a run."""

from __future__ import annotations

import ast
import linecache
import os
import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import about, in_share, report
from edulaunch.advice.launch_names import class_named
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.advice.run_sources import name_of_call, script_of
from edulaunch.engine.nearest import nearest, nearest_spelling


@rule(
    'launch.command-failed',
    what=("the command '{command}' failed: {said}", "the command '{command}' failed"),
    why='the launch file needs the output of the command',
    do=(
        'write the prefix into the root element: <robot name="..." xmlns:{prefix}="http://www.ros.org/wiki/xacro">',
        'run the command in a terminal, and fix the problem that it reports: {command}',
    ),
    level='error',
    hides=('programs.died',),
)
def command_failed(failure: Failure) -> Iterator[Finding]:
    """Report a failed command of the substitution Command. The fact `said` is the first line of the command's standard error."""
    matched = re.match(r'executed command failed. Command: (.*)(?:\nCaptured stderr output: ((?s:.*)))?', failure.message)
    if matched is not None:
        words = [os.path.realpath(word) if os.path.exists(word) else word for word in matched[1].split()]
        lines = [line.strip() for line in (matched[2] or '').splitlines() if line.strip()]
        prefix = 'xacro' if lines and 'unbound prefix' in lines[0] and 'xacro' in matched[1] else None
        yield report(failure, command=in_share(' '.join(words)), said=lines[0] if lines else None, prefix=prefix)


@rule(
    'launch.command-no-space',
    what="Command joins '{program}' and '{path}' to one word, '{joined}', because there is no space between them",
    why='Command joins the items of its list as they are, and then splits the result at spaces',
    do="write a space after the program: '{program} '",
    lesson='12_urdf',
    level='error',
    hides=('launch.fails', 'launch.program-absent', 'programs.died'),
)
def command_no_space(failure: Failure) -> Iterator[Finding]:
    """Report a Command such as `Command(['xacro', path])`, which joins the program and the path of a file into one word."""
    if failure.facts.get('about') != 'launch.program-absent':
        return
    program, slash, rest = str(failure.facts.get('program')).partition('/')
    path = in_share(os.path.realpath(slash + rest))
    if re.fullmatch(r'\w+', program) and os.path.isfile(slash + rest):
        calls = [node for node in ast.walk(script_of(failure.file) or ast.Module([], [])) if name_of_call(node) == 'Command']
        line = calls[0].lineno if len(calls) == 1 and isinstance(calls[0], ast.Call) else failure.line
        name = os.path.basename(path)
        yield report(failure._replace(line=line), program=program, path=f'/.../{name}', joined=f'{program}/.../{name}')


@rule(
    'launch.output-word',
    what="the output of an action cannot be '{given}'",
    why="output= accepts 'screen', 'log' and 'both'; 'screen' also writes the log file",
    do=("write output='{near}'", "write output='screen' or output='log'"),
    lesson='01_first_launch',
    level='error',
    hides=('launch.fails',),
    edits=(('{given}', '{near}'),),
)
def output_word(failure: Failure) -> Iterator[Finding]:
    """Report a value of `output=` that launch does not accept."""
    match = re.match(r'(.+) is not a valid (?:standard|combined) output config', failure.message)
    if match is not None:
        near = nearest_spelling(match[1].lower(), ('screen', 'log', 'both', 'own_log', 'full'))
        yield report(failure, given=match[1], near=near)


@rule(
    'launch.program-absent',
    what="this launch file needs the program '{program}', which this computer does not have on its PATH",
    why='launch looks for the program on the computer that runs it',
    do=("write '{near}' if you mean that program", "install '{program}' here, or run this launch file on a computer that has it"),
    level='info',
    hides=('launch.fails', 'programs.died'),
)
def program_absent(failure: Failure) -> Iterator[Finding]:
    """Report a program that the substitution Command or FindExecutable cannot find."""
    if failure.facts.get('about') == 'launch.program-absent':
        yield report(failure)


@rule(
    'launch.no-configuration',
    what=(
        "the launch configuration '{scoped}' was set inside a GroupAction that has already ended",
        "the launch configuration '{configuration}' does not exist",
    ),
    why="launch runs events and timers after the group that set '{scoped}' has ended",
    do=(
        "write '{near}' if you mean this name",
        'add scoped=False to the group, or read {scoped} in an OpaqueFunction inside the group',
        'write <arg name="{xml}" default="..."/> before this line, or pass the value in the '
        '<include> element of the other launch file',
        "write `- arg: {{name: {yaml}, default: '...'}}` before this line, or pass the value in the include of the "
        'other launch file',
        "write DeclareLaunchArgument('{configuration}', default_value='...') before this use",
    ),
    lesson='01_first_launch',
    level='error',
    edits=(('{configuration}', '{near}', 'near'),),
)
def no_configuration(failure: Failure) -> Iterator[Finding]:
    """Report the use of a launch configuration that nothing declares or sets."""
    if failure.facts.get('about') == 'launch.no-configuration':
        name, file = failure.facts['configuration'], failure.file or ''
        is_xml, is_yaml = file.endswith(('.xml', '.launch')), file.endswith(('.yaml', '.yml'))
        yield report(failure, xml=name if is_xml else None, yaml=name if is_yaml else None)


@rule(
    'launch.no-argument',
    what=("the launch argument '{needed}' is required, but you passed '{near}'", "the launch argument '{needed}' is required"),
    do=(
        "write '{needed}' instead of '{near}' as the name of the launch argument",
        'pass {needed}:=..., or add default_value=... to its DeclareLaunchArgument',
    ),
    level='error',
    lesson='01_first_launch',
)
def no_argument(failure: Failure) -> Iterator[Finding]:
    """Report a missing launch argument that has no default."""
    match = re.search(r"missing required argument '(.*?)' .*given: \[(.*)\]", failure.message, re.DOTALL)
    if match is not None:
        given = [name for name in match[2].split(', ') if name]
        yield report(failure, needed=match[1], near=nearest(match[1], given))


@rule(
    'launch.no-variable',
    what="the environment variable '{variable}' is not set",
    do=("write '{near}' if you mean this name", "add a default: EnvironmentVariable('{variable}', default_value='...')"),
    level='error',
    edits=(('{variable}', '{near}', 'near'),),
)
def no_variable(failure: Failure) -> Iterator[Finding]:
    """Report the use of an environment variable that is not set and has no default."""
    match = re.search(r"environment variable '(.*)' does not exist", failure.message)
    if match is not None:
        yield report(failure, variable=match[1])


@rule(
    'launch.condition-value',
    what=('{code} has quotes around it, so the condition tests this string itself', 'this condition is neither true nor false'),
    do=(
        'remove the quotes: {code}',
        'use true, 1, false or 0, and compare strings with $(eval {compared})',
        'use true, 1, false or 0, and compare strings with EqualsSubstitution(left, right)',
    ),
    level='error',
    lesson='01_first_launch',
)
def condition_value(failure: Failure) -> Iterator[Finding]:
    """Report a condition whose value is not a boolean, as in `IfCondition('maybe')`."""
    if failure.message.startswith('invalid condition expression'):
        code = None
        for node in ast.walk(script_of(failure.file) or ast.Module([], [])):
            is_condition = isinstance(node, ast.Call) and name_of_call(node) in ('IfCondition', 'UnlessCondition')
            word = node.args[0] if is_condition and node.args else None  # type: ignore[attr-defined]
            if isinstance(word, ast.Constant) and re.match(r'LaunchConfiguration\(', str(word.value)):
                code = str(word.value)
        is_markup = not (failure.file or '').endswith('.py')
        yield report(failure, code=code, compared="\"'$(var mode)' == 'sim'\"" if is_markup else None)


@rule(
    'launch.namespace',
    what='this namespace is not valid',
    do="use only letters, digits, '_' and '/', and do not start any part with a digit",
    level='error',
)
def namespace(failure: Failure) -> Iterator[Finding]:
    """Report a namespace that ROS 2 rejects."""
    if failure.message.startswith('The resulting namespace is invalid'):
        yield report(failure)


@rule(
    'launch.executed-twice',
    what='the launch description lists the same action object twice, but the object can start only one process',
    do=(
        'remove {handled} from the list of LaunchDescription, because an event handler starts it',
        'create a new action object for each use',
    ),
    level='error',
)
def executed_twice(failure: Failure) -> Iterator[Finding]:
    """Report an `ExecuteProcess` object that a launch file uses in two places."""
    if 'executed more than once' not in failure.message:
        return
    listed: set[str] = set()
    handled: list[str] = []
    for node in ast.walk(script_of(failure.file) or ast.Module([], [])):
        if isinstance(node, ast.Call) and name_of_call(node) == 'LaunchDescription':
            listed.update(item.id for word in node.args for item in getattr(word, 'elts', ()) if isinstance(item, ast.Name))
        elif isinstance(node, ast.keyword) and str(node.arg).startswith('on_'):
            handled += [name.id for name in ast.walk(node.value) if isinstance(name, ast.Name)]
    yield report(failure, handled=next((name for name in handled if name in listed), None))


@rule(
    'launch.too-deep',
    what='actions, includes or calls are nested without end',
    do='look for a launch file that includes itself, or a function that calls itself',
    level='error',
)
def too_deep(failure: Failure) -> Iterator[Finding]:
    """Report endless recursion in a launch file."""
    if failure.process is None and failure.message.startswith('maximum recursion depth'):
        yield report(failure)


INCLUDE_RING = about(
    'launch.include-ring',
    what=('{itself} includes itself', 'launch files include each other in a circle: {ring}'),
    do=(
        'remove this include, or give it a condition that becomes false in {itself}',
        'remove one of these includes, or give it a condition that becomes false',
    ),
)
_JOINED = re.compile(
    r"""can only concatenate str \(not "(?P<plus>\w+)"\)|unsupported operand type\(s\) for \+: '(?P<left>\w+)'"""
    r"""|bad operand type for unary -: '(?P<minus>\w+)'|[^<]*<launch[\w.]*\.substitutions\.[\w.]*\.(?P<text>\w+) object at""",
    re.DOTALL,
)


@rule(
    'launch.joined-too-early',
    what='Python converts {given} to a string before it has a value',
    do="pass a list such as ['carrot_', {given}(...)]; launch joins the parts when it runs",
    level='error',
    hides=('programs.sign-in-name',),
)
def joined_too_early(failure: Failure) -> Iterator[Finding]:
    """Report a substitution that is joined to a string, as in `'carrot_' + LaunchConfiguration('leader')` or in an f-string.

    Also report a minus sign in front of a substitution.

    """
    match = _JOINED.match(failure.message)
    given = (
        next(filter(None, match.groups()), None)
        if match is not None and not failure.facts.get('about') and failure.process is None
        else None
    )
    if given not in (None, 'TextSubstitution') and hasattr(class_named(given), 'perform'):
        yield report(failure, given=given)


@rule(
    'launch.value-too-early',
    what='a {given} has no value yet while Python reads the launch file',
    do=(
        'use its value in an OpaqueFunction: int({counted}(...).perform(context))',
        'give the action a condition in place of the `if`: '
        "condition=IfCondition(PythonExpression([{compared}('count'), ' > 1']))",
        'call perform() in the function of an OpaqueFunction, with its context: {given}(...).perform(context)',
    ),
    level='error',
)
def value_too_early(failure: Failure) -> Iterator[Finding]:
    """Report a substitution that is used like its value, as in `LaunchConfiguration('count') > 1`.

    Also report a call of `.perform()` without a context.
    """
    match = re.match(r"'[<>]=?' not supported between instances of '(\w+)'|(\w+)\.perform\(\) missing 1 req", failure.message)
    counted = re.match(r"'(\w+)' object cannot be interpreted as an integer", failure.message)
    name = counted[1] if counted is not None else None if match is None else match[1] or match[2]
    if name is not None and failure.process is None and hasattr(class_named(name), 'perform'):
        yield report(failure, given=name, counted=counted and name, compared=match and match[1])


@rule(
    'launch.default-no-choice',
    what="the default '{default}' is not one of the choices",
    do="write a list of strings that contains the default: choices=['{default}', '...']",
    level='error',
)
def default_no_choice(failure: Failure) -> Iterator[Finding]:
    """Report a default that is not among the choices, as with `choices=[True, False]`.

    Python reads `choices='true false'` as a list of letters.
    """
    match = re.match(r'Provided default_value "(.*)" is not in provided choices', failure.message)
    if match is not None:
        yield report(failure, default=match[1])


@rule(
    'launch.bool-wanted',
    what='{value} is used where True or False is expected',
    do='write True or False, without quotes',
    level='error',
)
def bool_wanted(failure: Failure) -> Iterator[Finding]:
    """Report a string for a boolean argument, as in `respawn='yes'`."""
    match = re.match(r"value=(.*) is not an instance of <class 'bool'>", failure.message)
    if match is not None and failure.process is None:
        yield report(failure, value=match[1])


@rule(
    'launch.number-wanted',
    what="'{value}' is not a number",
    do='write only the number, without a unit and without quotes: 2.0',
    level='error',
    hides=('launch.element',),
)
def number_wanted(failure: Failure) -> Iterator[Finding]:
    """Report a string that is not a number where launch expects a number, as in `period='2 s'`."""
    match = re.match(r"could not convert string to float: '(.*)'", failure.message)
    if match is not None and failure.process is None:
        yield report(failure, value=match[1])


@rule(
    'launch.text-is-bytes',
    what='event.text is bytes, but this line uses it as a string',
    do='convert it to a string first: event.text.decode()',
    level='error',
)
def text_is_bytes(failure: Failure) -> Iterator[Finding]:
    """Report a string that a handler of OnProcessIO compares with bytes, as in `'ready' in event.text`."""
    match = re.match(
        'a bytes-like object is required|argument should be integer or bytes-like|.*must be bytes or', failure.message
    )
    if match is not None and failure.process is None and '.text' in linecache.getline(failure.file or '', failure.line or 0):
        yield report(failure)

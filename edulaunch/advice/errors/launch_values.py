"""Rules about values that launch computes during a run, parameters and their files, and the command line."""

from __future__ import annotations

import ast
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
    do='run the command in a terminal, and fix the problem that it reports: {command}',
    level='error',
    hides=('programs.died',),
)
def command_failed(failure: Failure) -> Iterator[Finding]:
    """Report a failed command of the substitution Command. The fact `said` is the first line of the command's standard error."""
    matched = re.match(r'executed command failed. Command: (.*)(?:\nCaptured stderr output: ((?s:.*)))?', failure.message)
    if matched is not None:
        words = [os.path.realpath(word) if os.path.exists(word) else word for word in matched[1].split()]
        lines = [line.strip() for line in (matched[2] or '').splitlines() if line.strip()]
        yield report(failure, command=in_share(' '.join(words)), said=lines[0] if lines else None)


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
    do=('replace {near}:= with {needed}:=', 'pass {needed}:=..., or add default_value=... to its DeclareLaunchArgument'),
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
EMPTY_PARAMETER_FILE = about(
    'launch.empty-parameter-file',
    what='the parameter file {parameter_file} is empty',
    do='write the name of the node, then ros__parameters below it, and the parameters below that',
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
    'programs.parameter-type',
    what=(
        "the parameter '{parameter}' was declared as {expected}, but its value '{said}' is of type STRING",
        "the parameter '{parameter}' was declared as {expected}, but its value is of type {given}",
    ),
    do=(
        'write {meant}',
        "declare it with a decimal point, as in declare_parameter('{parameter}', 1.0), because {fraction} is not an integer",
        'write the value with a decimal point: {as_double}',
        'write the value without a decimal point: {as_integer}',
        "put the value in quotes: '{as_text}'",
        'set a value of type {expected}, or declare the parameter with a default of another type',
    ),
    level='error',
)
def parameter_type(failure: Failure) -> Iterator[Finding]:
    """Report a parameter value of the wrong type. The type of a parameter never changes, and an integer is not a double."""
    facts = failure.facts
    if facts.get('about') == 'programs.parameter-type':
        pair, value = (facts.get('given'), facts.get('expected')), str(facts.get('value'))
        fraction = value if pair == ('DOUBLE', 'INTEGER') and value.partition('.')[2].strip('0') else None
        yield report(
            failure,
            as_double=f'{value}.0' if pair == ('INTEGER', 'DOUBLE') else None,
            as_integer=value.partition('.')[0] if pair == ('DOUBLE', 'INTEGER') and not fraction else None,
            fraction=fraction,
            said=value if pair[0] == 'STRING' and facts.get('value') is not None else None,
            meant=_meant(value, str(pair[1])) if pair[0] == 'STRING' else None,
            as_text=value if pair[1] == 'STRING' and pair[0] in ('INTEGER', 'DOUBLE', 'BOOL') else None,
        )


def _meant(text: str, wanted: str) -> str | None:
    """Return the value of the wanted type that the user probably means with a string such as `2,5`, `Ture` or `0.5 1.5`, or
    None.
    """
    number, words = r'-?\d+(?:\.\d+)?', text.replace(',', ' ').split()
    if wanted == 'DOUBLE' and re.fullmatch(r'-?\d+,\d+', text):
        return text.replace(',', '.')
    if wanted.endswith('_ARRAY') and len(words) > 1 and all(re.fullmatch(number, word) for word in words):
        return f'[{", ".join(words)}]'
    return nearest_spelling(text.lower(), ('true', 'false')) if wanted == 'BOOL' else None


@rule(
    'programs.parameter-undeclared',
    what="the parameter '{parameter}' is used before the node declares it",
    why='a node ignores a parameter of a launch file until it declares that parameter',
    do=(
        "write '{near}' if you mean this name",
        "declare it first with a default value: self.declare_parameter('{parameter}', ...)",
    ),
    lesson='03_parameters',
    level='error',
    edits=(('{parameter}', '{near}', 'near'),),
)
def parameter_undeclared(failure: Failure) -> Iterator[Finding]:
    """Report an undeclared parameter that a node reads or sets."""
    facts = failure.facts
    if facts.get('about') == 'programs.parameter-undeclared':
        yield report(failure, near=nearest(str(facts.get('parameter')), map(str, facts.get('declared') or ())))


PARAMETER_FILE = about(
    'launch.parameter-file',
    what='the values in this parameter file have no node name or no ros__parameters above them',
    do='write the name of the node (or /**), then ros__parameters below it, and the parameters below that',
)
PARAMETER_NO_SPACE = about(
    'launch.parameter-no-space',
    what=(
        "line {at} of the parameter file is read as the string '{words}', because there is no colon after the name",
        "line {at} of the parameter file is read as the string '{squeezed}', because there is no space after the colon",
    ),
    do="write '{spaced}'",
    lesson='03_parameters',
    edits=(('{squeezed}', '{spaced}'),),
)
NO_PARAMETER_FILE = about(
    'launch.no-parameter-file',
    what='the parameter file {wanted} does not exist',
    do=("write '{near}'", 'write an absolute path, or a path relative to the folder in which you run the command'),
)
PARAMETER_FILE_ENCODING = about(
    'launch.parameter-file-encoding',
    what='the parameter file {unreadable} is not encoded in UTF-8',
    do='save the file again in UTF-8',
)
PARAMETERS_KEY = about(
    'launch.parameters-key',
    what=(
        "{parameter_file} contains '{found}' above line {at}, which is not a key of parameter files",
        "'{found}' is not a key of parameter files",
    ),
    do='write ros__parameters, with two underscores',
    edits=(('{found}', 'ros__parameters'),),
)
PARAMETER_VALUE = about(
    'launch.parameter-value', what='ROS 2 cannot read this parameter value', do='write a single value or a list of values'
)


@rule(
    'launch.value-as-yaml',
    what="launch reads the value of the parameter '{parameter}' as YAML, but it is not valid YAML",
    why='without a type, launch reads a value as YAML, so 5 becomes a number, and an XML document can be an error',
    do=(
        'add type="str" to the <{xml}> of {parameter}',
        'add the line `{yaml}: str` to the parameter {parameter}',
        'write ParameterValue({python}, value_type=str), with: from launch_ros.parameter_descriptions import ParameterValue',
    ),
    level='error',
)
def value_as_yaml(failure: Failure) -> Iterator[Finding]:
    """Report a parameter, such as the output of xacro, whose type launch cannot determine."""
    if failure.facts.get('about') == 'launch.value-as-yaml':
        ending = os.path.splitext(failure.file or '')[1]
        forms = {'.xml': {'xml': 'param'}, '.launch': {'xml': 'param'}, '.yaml': {'yaml': 'type'}, '.yml': {'yaml': 'type'}}
        yield report(failure, **forms.get(ending, {'python': '...'}))


LIST_OF_ONE_TYPE = about(
    'launch.list-of-one-type',
    what=(
        'the values of the list on line {at} of {parameter_file} are of different types',
        'the values of this list are of different types',
    ),
    do=(
        "replace '{word}' with a number, or put every value in quotes",
        'write all numbers of a list with a decimal point, or all without',
    ),
)
NO_VALUE = about('launch.no-value', what='this parameter has no value', do='remove the line, or write "" for an empty string')
PARAMETER_RULE = about(
    'launch.parameter-rule',
    what="-p needs an argument of the form 'name:=value'",
    do='write it without spaces, as in background_r:=200',
)
LOG_LEVEL = about(
    'launch.log-level', what='--log-level needs a level, or logger:=level', do='use debug, info, warn, error or fatal'
)
REMAP_RULE = about(
    'launch.remap-rule',
    what="'{rule}' is not a valid remapping",
    do='write from:=to without spaces, as in turtle1/cmd_vel:=cmd_vel, with letters, digits, _ and single slashes in both names',
)


@rule(
    'launch.yaml',
    what=(
        'line {at} of {parameter_file} is not valid YAML: {problem}',
        'line {at} of the YAML file is not valid: {problem}',
        'the YAML file is not valid: {problem}',
    ),
    do=(
        'indent with spaces, because YAML does not allow a {tab}',
        'write /{star} for all nodes, because YAML needs quotes around a name that begins with *',
        'check indentation, colons and quotes in that line and in the line above',
    ),
    level='error',
)
def yaml(failure: Failure) -> Iterator[Finding]:
    """Report a parameter file that is not valid YAML."""
    if failure.facts.get('about') == 'launch.yaml':
        has_tab = 'cannot start any token' in str(failure.facts.get('problem'))
        has_star = 'did not find expected alphabetic' in str(failure.facts.get('problem'))
        yield report(failure, tab='tab' if has_tab else None, star='**' if has_star else None)

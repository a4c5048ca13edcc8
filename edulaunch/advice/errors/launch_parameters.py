"""Rules about parameters, their files, and the rules of a command line."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator

from edulaunch.advice.errors.about import about, report
from edulaunch.advice.rule import Failure, Finding, rule
from edulaunch.engine.nearest import nearest, nearest_spelling

EMPTY_PARAMETER_FILE = about(
    'launch.empty-parameter-file',
    what='the parameter file {parameter_file} is empty',
    do='write the name of the node, then ros__parameters below it, and the parameters below that',
)


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
        "in {parameter_file}, '{found}' (above line {at}) is not a key of parameter files",
        "'{found}' is not a key of parameter files",
    ),
    do='write ros__parameters, with two underscores',
    edits=(('{found}', 'ros__parameters'),),
)
PARAMETER_VALUE = about(
    'launch.parameter-value',
    what="a parameter cannot have the value '{value}', which is a mapping",
    do='write a single value or a list of values',
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
NESTED_LIST = about(
    'launch.nested-list',
    what='the list on line {at} of {parameter_file} contains another list or a mapping, which parameters cannot have',
    do='write one flat list, such as [1.0, 2.0, 5.0, 6.0], and let the program read two values at a time',
    lesson='03_parameters',
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

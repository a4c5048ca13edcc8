"""Parameters: their types, their files, and the rules of the command line."""

from __future__ import annotations

from collections.abc import Iterator

from edulaunch.advice.errors.about import about, speak
from edulaunch.advice.failure import Failure
from edulaunch.advice.finding import Finding
from edulaunch.advice.rule import rule
from edulaunch.nearest import nearest


@rule(
    'programs.parameter-type',
    what="parameter '{parameter}' was declared as {expected}, but its value is of type {given}",
    do=(
        'write it with its point: {as_double}',
        'write it without a point: {as_integer}',
        "put it in quotation marks: '{as_text}'",
        'give it a value of type {expected}, or declare it with another default',
    ),
    level='error',
)
def parameter_type(failure: Failure) -> Iterator[Finding]:
    """Types of parameters never change; integers are no doubles."""
    facts = failure.facts
    if facts.get('about') == 'programs.parameter-type':
        pair, value = (facts.get('given'), facts.get('expected')), str(facts.get('value'))
        yield speak(
            failure,
            as_double=f'{value}.0' if pair == ('INTEGER', 'DOUBLE') else None,
            as_integer=value.partition('.')[0] if pair == ('DOUBLE', 'INTEGER') else None,
            as_text=value if pair[1] == 'STRING' and pair[0] in ('INTEGER', 'DOUBLE', 'BOOL') else None,
        )


@rule(
    'programs.parameter-undeclared',
    what="the parameter '{parameter}' is used here, but was not declared",
    why='a node knows only the parameters that it has declared, also those that a launch file sets',
    do=(
        "write '{near}', if that is the one you mean",
        "declare it before: self.declare_parameter('{parameter}', ...), with a default value",
    ),
    lesson='05_large_project',
    level='error',
)
def parameter_undeclared(failure: Failure) -> Iterator[Finding]:
    """By get_parameter, set_parameters and the like."""
    facts = failure.facts
    if facts.get('about') == 'programs.parameter-undeclared':
        yield speak(failure, near=nearest(str(facts.get('parameter')), map(str, facts.get('declared') or ())))


PARAMETER_FILE = about(
    'launch.parameter-file',
    what='this parameter file has no node name, or no ros__parameters, above its values',
    do='write the name of the node (or /**), below it ros__parameters, and below that the parameters',
)
PARAMETERS_KEY = about(
    'launch.parameters-key', what="'{found}' is no word of parameter files", do='write ros__parameters, with two underscores'
)
PARAMETER_VALUE = about(
    'launch.parameter-value', what='this value of a parameter cannot be read', do='write a value or a list of values'
)
LIST_OF_ONE_TYPE = about(
    'launch.list-of-one-type',
    what='the values of this list are of different types',
    do='write all numbers of a list with a point, or all without',
)
NO_VALUE = about('launch.no-value', what='this parameter has no value', do='leave the line out, or write "" for an empty text')
PARAMETER_RULE = about(
    'launch.parameter-rule', what="-p takes 'name:=value'", do='write it without spaces, such as background_r:=200'
)
LOG_LEVEL = about(
    'launch.log-level', what='--log-level takes a level, or logger:=level', do='choose debug, info, warn, error or fatal'
)
REMAP_RULE = about(
    'launch.remap-rule', what="-r takes 'from:=to'", do='write it without spaces, such as turtle1/cmd_vel:=cmd_vel'
)


@rule(
    'launch.yaml',
    what=('line {at} of the YAML file cannot be read: {problem}', 'the YAML file cannot be read: {problem}'),
    do=('indent with spaces: YAML takes no {tab}', 'look at that line and the one above it: indentation, colons, quotes'),
    level='error',
)
def yaml(failure: Failure) -> Iterator[Finding]:
    """A parameter file that is no YAML."""
    if failure.facts.get('about') == 'launch.yaml':
        has_tab = 'cannot start any token' in str(failure.facts.get('problem'))
        yield speak(failure, tab='tab' if has_tab else None)

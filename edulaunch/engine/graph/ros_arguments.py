"""Parses the part of a command line between `--ros-args` and `--` as rcl does: remap rules, parameters and log levels."""

from __future__ import annotations

import os
import re
from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from edulaunch.engine.facts import facts_of, with_facts, with_facts_of
from edulaunch.engine.graph.names import RemapRule, absolute_namespace
from edulaunch.engine.graph.parameter_files import Entry, ParameterFileError, read_parameter_file, read_value
from edulaunch.engine.graph.parameters import pattern_matches, precedence
from edulaunch.engine.graph.rule_reader import (
    END,
    NAMESPACE,
    NODE,
    SEPARATOR,
    SERVICE_SCHEME,
    TOKEN,
    TOPIC_SCHEME,
    RuleError,
    RuleReader,
    read_matched_name,
    read_new_name,
    read_new_namespace,
    read_parameter_name,
)
from edulaunch.engine.nearest import nearest_file
from edulaunch.errors import UnusableInput

_NAME = r'(?:[A-Za-z]|_(?!_))(?:_?[A-Za-z0-9])*_?(?:/(?:[A-Za-z]|_(?!_))(?:_?[A-Za-z0-9])*_?)*'
_PLAIN_RULE = re.compile(f'((?:~?/)?{_NAME}|(__node)|(__ns)):=((?:~?/)?{_NAME})')
"""Matches nearly all rules in a tenth of the time that the reader of rules needs."""
SEVERITIES = {'debug': 10, 'info': 20, 'warn': 30, 'error': 40, 'fatal': 50}


class RosArgumentsError(UnusableInput):
    """A rule, flag or parameter file after `--ros-args` that rcl rejects."""


class Override(NamedTuple):
    """A parameter override and its origin ('command line' or 'file.yaml line 12')."""

    value: Any
    origin: str


class RosArguments:
    """The ROS arguments of a command line.

    :ivar remap_rules: the remap rules in order of appearance; the first matching rule is used.
    :ivar parameters: node pattern -> parameter name -> :class:`Override`; patterns in order of first appearance.
    :ivar log_levels: logger name -> severity number; the name '' is the default level.
    :ivar outputs: whether 'stdout', 'rosout' and 'external-lib' logs are on, for each of these outputs that a flag sets.
    :ivar others: the arguments outside any `--ros-args` section, including the name of the program.
    :ivar deprecated: the remap rules outside any `--ros-args` section.
    :ivar unknown: the unknown tokens inside a section.
    """

    def __init__(self) -> None:
        self.remap_rules: list[RemapRule] = []
        self.parameters: dict[str, dict[str, Override]] = {}
        self.log_levels: dict[str, int] = {}
        self.outputs: dict[str, bool] = {}
        self.settings: dict[str, str] = {}
        self.others: list[str] = []
        self.deprecated: list[str] = []
        self.unknown: list[str] = []

    def overrides_for(self, fully_qualified_name: str) -> dict[str, Override]:
        """Return the parameter overrides for one node. Later patterns take precedence over earlier patterns."""
        found: dict[str, Override] = {}
        for pattern, values in self.parameters.items():
            if pattern_matches(pattern, fully_qualified_name):
                found.update(values)
        return found


def parse_ros_arguments(arguments: Sequence[str], entries_of: Callable[[str], Sequence[Entry]] | None = None) -> RosArguments:
    """Parse a whole command line, and return its ROS arguments.

    :param entries_of: a function that returns the entries of a parameter file, given its path as written (default: read
        the file).
    :raises RosArgumentsError: with rcl's message, for an invalid rule, flag or parameter file.
    """
    result = RosArguments()
    tokens = iter(arguments)
    inside = False
    for token in tokens:
        if token == '--ros-args':
            inside = True
        elif not inside:
            _read_other(result, token)
        elif token == '--':
            inside = False
        else:
            _read_flag(result, token, tokens, entries_of or entries_of_file)
    return result


def _read_other(result: RosArguments, token: str) -> None:
    """Read an argument outside of `--ros-args`. A remap rule also takes effect there, but rcl reports it as deprecated."""
    try:
        if ':=' in token:
            result.remap_rules.append(remap_rule(token))
            result.deprecated.append(token)
            return
    except RuleError:
        pass
    result.others.append(token)


def entries_of_file(path: str) -> Sequence[Entry]:
    """Return the entries of a parameter file.

    :raises OSError: if the file cannot be opened.
    :raises UnicodeDecodeError: if the file is not UTF-8.
    :raises ParameterFileError: if rcl would reject the content.
    """
    with open(path, encoding='utf-8') as file:
        return read_parameter_file(file.read())


_FLAGS = {
    '-r': 'remap',
    '--remap': 'remap',
    '-p': 'param',
    '--param': 'param',
    '--params-file': 'params-file',
    '--log-level': 'log-level',
    '-e': 'enclave',
    '--enclave': 'enclave',
    '--log-file-name': 'log-file-name',
    '--log-config-file': 'log-config-file',
    '--log-file': 'log-file-name',
}
_MISSING = {
    'remap': "Couldn't parse trailing {} flag. No remap rule found.",
    'param': "Couldn't parse trailing {} flag. No parameter override rule found.",
    'params-file': "Couldn't parse trailing {} flag. No file path provided.",
    'log-level': "Couldn't parse trailing log level flag: '{}'. No log level provided.",
    'enclave': "Couldn't parse trailing {} flag. No enclave path provided.",
    'log-file-name': "Couldn't parse trailing {} flag. No file name prefix provided.",
    'log-config-file': "Couldn't parse trailing {} flag. No file path provided.",
}


def _read_flag(result: RosArguments, flag: str, tokens: Any, entries_of: Callable[[str], Sequence[Entry]]) -> None:
    meaning = _FLAGS.get(flag)
    if meaning is None:
        _read_switch(result, flag)
        return
    value = next(tokens, None)
    if value is None:
        raise RosArgumentsError(_MISSING[meaning].format(flag))
    if meaning == 'remap':
        result.remap_rules.append(_remap_rule(flag, value))
    elif meaning == 'param':
        _add_parameter(result, flag, value)
    elif meaning == 'params-file':
        _add_file(result, flag, value, entries_of)
    elif meaning == 'log-level':
        _add_log_level(result, flag, value)
    else:
        result.settings[meaning] = value


def _read_switch(result: RosArguments, flag: str) -> None:
    for state in ('enable', 'disable'):
        for output in ('stdout', 'rosout', 'external-lib'):
            if flag == f'--{state}-{output}-logs':
                result.outputs[output] = state == 'enable'
                return
    result.unknown.append(flag)


def _refuse(what: str, flag: str, value: str, reason: str) -> RosArgumentsError:
    return RosArgumentsError(f"Couldn't parse {what}: '{flag} {value}'. Error: {reason}")


def _remap_rule(flag: str, text: str) -> RemapRule:
    try:
        return remap_rule(text)
    except RuleError as error:
        raise with_facts(_refuse('remap rule', flag, text, str(error)), 'launch.remap-rule', rule=text) from None


def remap_rule(text: str) -> RemapRule:
    """Return the remap rule that a string such as `from:=to` describes.

    :raises RuleError: if the rule is invalid.
    """
    plain = _PLAIN_RULE.fullmatch(text)
    if plain is not None:
        match, of_node, of_namespace, replacement = plain.groups()
        if of_node is None and of_namespace is None:
            return RemapRule('any', None, match, replacement)
        if of_node is not None and '/' not in replacement:
            return RemapRule('node', None, match, replacement)
        if of_namespace is not None and replacement[0] == '/':
            return RemapRule('namespace', None, match, replacement)
    reader = RuleReader(text)
    node_name = reader.node_prefix()
    if reader.kind in (NODE, NAMESPACE):
        kind = 'node' if reader.kind == NODE else 'namespace'
        match = reader.take()
        reader.expect(SEPARATOR)
        if kind == 'namespace':
            return RemapRule(kind, node_name, match, read_new_namespace(reader))
        replacement = reader.expect(TOKEN)
        reader.expect(END)
        return RemapRule(kind, node_name, match, replacement)
    kind = {SERVICE_SCHEME: 'service', TOPIC_SCHEME: 'topic'}.get(reader.kind, 'any')
    if kind != 'any':
        reader.take()
    match = read_matched_name(reader)
    return RemapRule(kind, node_name, match, read_new_name(reader))


def _refused_parameter(flag: str, text: str, error: RuleError | ParameterFileError) -> RosArgumentsError:
    refused = _refuse('parameter override rule', flag, text, str(error))
    return with_facts_of(refused, error) if facts_of(error) else with_facts(refused, 'launch.parameter-rule')


def _add_parameter(result: RosArguments, flag: str, text: str) -> None:
    reader = RuleReader(text)
    try:
        node_name = reader.node_prefix()
        name = read_parameter_name(reader)
        override = Override(read_value(text[reader.position :]), 'command line')
    except (RuleError, ParameterFileError) as error:
        raise _refused_parameter(flag, text, error) from None
    pattern = absolute_namespace(node_name) if node_name else '/**'
    _keep(result.parameters.setdefault(pattern, {}), name, override)


def _keep(values: dict[str, Override], name: str, override: Override) -> None:
    """Add a parameter override, unless the stored value of the parameter takes precedence.

    rcl stores one value of each type, and rclpy uses the first type: bool, integer, double, string, then arrays.
    """
    kept = values.get(name)
    if kept is None or precedence(override.value) <= precedence(kept.value):
        values[name] = override


def _add_file(result: RosArguments, flag: str, path: str, entries_of: Callable[[str], Sequence[Entry]]) -> None:
    try:
        entries = entries_of(path)
    except OSError as error:
        refused = _refuse('params file', flag, path, 'Error opening YAML file')
        raise with_facts(refused, 'launch.no-parameter-file', wanted=path, near=_near_file(error.filename or path)) from None
    except UnicodeDecodeError:
        refused = _refuse('params file', flag, path, 'Error parsing a event: the file is not UTF-8 text')
        raise with_facts(refused, 'launch.parameter-file-encoding', unreadable=path) from None
    except ParameterFileError as error:
        facts_of(error).update(parameter_file=os.path.basename(path), parameter_path=path)
        raise with_facts_of(_refuse('params file', flag, path, str(error)), error) from None
    base = path.replace('\\', '/').rpartition('/')[2]
    for entry in entries:
        override = Override(entry.value, f'{base} line {entry.line}')
        _keep(result.parameters.setdefault(entry.pattern, {}), entry.name, override)


def _near_file(path: str) -> str | None:
    folder, name = os.path.split(path)
    return nearest_file(name, os.listdir(folder or '.')) if os.path.isdir(folder or '.') else None


def _add_log_level(result: RosArguments, flag: str, text: str) -> None:
    try:
        name, number = _log_level(text)
    except RuleError as error:
        raise with_facts(_refuse('log level', flag, text, str(error)), 'launch.log-level') from None
    result.log_levels[name] = number


def _log_level(text: str) -> tuple[str, int]:
    """Parse `level` or `logger:=level`, and return the logger ('' for the default level) and the severity number.

    :raises RuleError: if the logger name or the severity is invalid.
    """
    name, separator, level = text.partition(':=')
    if not separator:
        name, level = '', text
    elif not name:
        raise RuleError('Argument has an invalid logger item that name is empty')
    else:
        reader = RuleReader(text, len(name) + len(separator))
        reader.expect(TOKEN)
        reader.expect(END)
    number = SEVERITIES.get(level.lower())
    if number is None:
        raise RuleError('Argument does not use a valid severity level')
    return name, number

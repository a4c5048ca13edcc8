"""The part of a command line between `--ros-args` and `--`: remap rules, parameters and log levels, by rcl's rules."""
from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput
from edulaunch.graph.names import RemapRule, absolute_namespace, namespace_problem, node_name_problem
from edulaunch.graph.parameter_files import ParameterFileError, read_parameter_file, read_value
from edulaunch.graph.parameters import pattern_matches

SEVERITIES = {'debug': 10, 'info': 20, 'warn': 30, 'error': 40, 'fatal': 50}


class RosArgumentsError(UnusableInput):
    """A rule, flag or parameter file after `--ros-args` that rcl refuses."""


class Override(NamedTuple):
    """A parameter value given from outside, and where it came from ('command line' or 'file.yaml line 12')."""

    value: Any
    origin: str


class RosArguments:
    """What a command line says to ROS.

    :ivar remap_rules: in order of appearance; the first that matches is used.
    :ivar parameters: node pattern -> parameter name -> :class:`Override`; patterns in order of first appearance.
    :ivar log_levels: logger name -> severity number; the name '' is the default level.
    :ivar outputs: which of 'stdout', 'rosout', 'external-lib' logs were switched on or off.
    :ivar others: the arguments outside any `--ros-args` section, the program's own name included.
    :ivar unknown: tokens inside a section that mean nothing.
    """

    def __init__(self) -> None:
        self.remap_rules: list[RemapRule] = []
        self.parameters: dict[str, dict[str, Override]] = {}
        self.log_levels: dict[str, int] = {}
        self.outputs: dict[str, bool] = {}
        self.settings: dict[str, str] = {}
        self.others: list[str] = []
        self.unknown: list[str] = []

    def overrides_for(self, fully_qualified_name: str) -> dict[str, Override]:
        """The parameters for one node: later patterns overwrite earlier ones."""
        found: dict[str, Override] = {}
        for pattern, values in self.parameters.items():
            if pattern_matches(pattern, fully_qualified_name):
                found.update(values)
        return found


def parse_ros_arguments(arguments: Sequence[str], read_text: Callable[[str], str] | None = None) -> RosArguments:
    """Read a whole command line.

    :param read_text: how to read a parameter file, given its path as written; by default from the file system.
    :raises RosArgumentsError: with rcl's text, for a rule or file that cannot be understood.
    """
    result = RosArguments()
    tokens = iter(arguments)
    inside = False
    for token in tokens:
        if token == '--ros-args':
            inside = True
        elif not inside:
            result.others.append(token)
        elif token == '--':
            inside = False
        else:
            _read_flag(result, token, tokens, read_text or read_file)
    return result


def read_file(path: str) -> str:
    """The text of a parameter file."""
    with open(path, encoding='utf-8') as file:
        return file.read()


_FLAGS = {
    '-r': 'remap', '--remap': 'remap', '-p': 'param', '--param': 'param', '--params-file': 'params-file',
    '--log-level': 'log-level', '-e': 'enclave', '--enclave': 'enclave',
    '--log-file-name': 'log-file-name', '--log-config-file': 'log-config-file', '--log-file': 'log-file-name',
}
_MISSING = {
    'remap': "Couldn't parse trailing {} flag. No remap rule found.",
    'param': "Couldn't parse trailing {} flag. No parameter override rule found.",
    'params-file': "Couldn't parse trailing {} flag. No file path provided.",
    'log-level': "Couldn't parse trailing log level flag: '{}'. No log level found.",
    'enclave': "Couldn't parse trailing {} flag. No enclave path provided.",
    'log-file-name': "Couldn't parse trailing {} flag. No file name prefix provided.",
    'log-config-file': "Couldn't parse trailing {} flag. No file path provided.",
}


def _read_flag(result: RosArguments, flag: str, tokens: Any, read_text: Callable[[str], str]) -> None:
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
        _add_file(result, flag, value, read_text)
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


def _refuse(what: str, flag: str, value: str, reason: str, help: str | None = None) -> RosArgumentsError:
    return RosArgumentsError(f"Couldn't parse {what}: '{flag} {value}'. Error: {reason}", help=help)


def _remap_rule(flag: str, text: str) -> RemapRule:
    def refuse(reason: str) -> RosArgumentsError:
        return _refuse('remap rule', flag, text, reason, "write 'from:=to', such as turtle1/cmd_vel:=cmd_vel")

    left, separator, replacement = text.partition(':=')
    if not separator or not left or not replacement:
        raise refuse("Expected a name, ':=' and a new name")
    kind = 'any'
    for scheme, meaning in (('rostopic://', 'topic'), ('rosservice://', 'service')):
        head, found, tail = left.partition(scheme)
        if found:
            left, kind = head + tail, meaning
    node_name, colon, match = left.rpartition(':')
    if colon and node_name_problem(node_name):
        raise refuse(f"'{node_name}' is not a node name")
    if match in ('__node', '__name', '__ns'):
        kind = 'namespace' if match == '__ns' else 'node'
        problem = node_name_problem(replacement) if kind == 'node' else namespace_problem(absolute_namespace(replacement))
        if problem:
            raise refuse(problem[0])
        replacement = absolute_namespace(replacement) if kind == 'namespace' else replacement
    return RemapRule(kind, node_name or None, match, replacement)


def _add_parameter(result: RosArguments, flag: str, text: str) -> None:
    def refuse(reason: str) -> RosArgumentsError:
        return _refuse('parameter override rule', flag, text, reason, "write 'name:=value', such as background_r:=200")

    left, separator, value = text.partition(':=')
    node_name, _, name = left.rpartition(':')
    if not separator or not name:
        raise refuse("Expected a parameter name, ':=' and a value")
    try:
        override = Override(read_value(value), 'command line')
    except ParameterFileError as error:
        raise refuse(str(error)) from None
    pattern = absolute_namespace(node_name) if node_name else '/**'
    result.parameters.setdefault(pattern, {})[name] = override


def _add_file(result: RosArguments, flag: str, path: str, read_text: Callable[[str], str]) -> None:
    try:
        entries = read_parameter_file(read_text(path))
    except OSError:
        raise _refuse('params file', flag, path, 'Error opening YAML file') from None
    except UnicodeDecodeError:
        raise _refuse('params file', flag, path, 'Error parsing a event: the file is not UTF-8 text') from None
    except ParameterFileError as error:
        raise _refuse('params file', flag, path, str(error), error.help) from None
    base = path.replace('\\', '/').rpartition('/')[2]
    for entry in entries:
        override = Override(entry.value, f'{base} line {entry.line}')
        result.parameters.setdefault(entry.pattern, {})[entry.name] = override


def _add_log_level(result: RosArguments, flag: str, text: str) -> None:
    name, separator, level = text.rpartition(':=')
    number = SEVERITIES.get(level.lower())
    if number is None or (separator and not name):
        raise _refuse('log level rule', flag, text, f"'{level}' is not one of DEBUG, INFO, WARN, ERROR, FATAL")
    result.log_levels[name] = number


def without_ros_arguments(arguments: Sequence[str]) -> list[str]:
    """A command line without its `--ros-args` sections."""
    kept: list[str] = []
    inside = False
    for token in arguments:
        if token == '--ros-args':
            inside = True
        elif inside and token == '--':
            inside = False
        elif not inside:
            kept.append(token)
    return kept

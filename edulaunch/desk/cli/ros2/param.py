"""`ros2 param`: read, set, save and load the parameters of nodes."""

from __future__ import annotations

import argparse
import os
import re
from typing import Any

from edulaunch.desk.cli.ros2 import cli_node, graph_names, node_parameters
from edulaunch.desk.cli.ros2.output import complain, say, say_lines, with_help
from edulaunch.engine.processes.current import current_process


def delete_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 param delete`."""
    node_parameters.add_node_arguments(parser)
    parser.add_argument('parameter_name', help='Name of the parameter')


def delete_verb(arguments: argparse.Namespace) -> None:
    """Delete the parameter and print the result. As in ROS 2, the exit code is 0 even if the node refuses."""
    from rcl_interfaces.msg import Parameter

    with node_parameters.parameters_of(arguments) as parameters:
        result = parameters.set([Parameter(name=arguments.parameter_name)])[0]
    reason = f': {result.reason}' if result.reason else ''
    if result.successful:
        say(f'Deleted parameter successfully{reason}')
    else:
        complain(f'Deleting parameter failed{reason}')


def describe_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 param describe`."""
    node_parameters.add_node_arguments(parser)
    parser.add_argument('parameter_names', nargs='+', help='Names of the parameters')


def describe_verb(arguments: argparse.Namespace) -> str | None:
    """Print the descriptor of each parameter."""
    with node_parameters.parameters_of(arguments) as parameters:
        descriptors = parameters.descriptors(arguments.parameter_names)
        if not descriptors:
            known = parameters.names()
            wrong = next((name for name in arguments.parameter_names if name not in known), arguments.parameter_names[0])
            return with_help(f'Requested parameter {wrong!r} is not declared', parameters.help_for(wrong))
    for descriptor in descriptors:
        say_lines(_lines(descriptor))
    return None


def _lines(descriptor: Any) -> list[str]:
    lines = [f'Parameter name: {descriptor.name}', f'  Type: {node_parameters.TYPE_WORDS[descriptor.type]}']
    if descriptor.description:
        lines.append(f'  Description: {descriptor.description}')
    constraints = ['    Read only: true'] if descriptor.read_only else []
    for limits in (*descriptor.floating_point_range, *descriptor.integer_range):
        constraints += [f'    Min value: {limits.from_value}', f'    Max value: {limits.to_value}']
        constraints += [f'    Step: {limits.step}'] if limits.step else []
    if descriptor.additional_constraints:
        constraints.append(f'    Additional constraints: {descriptor.additional_constraints}')
    return [*lines, '  Constraints:', *constraints] if constraints else lines


def dump_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the argument for the node, and the options for the output."""
    node_parameters.add_node_arguments(parser)
    parser.add_argument('--output-dir', help='The folder where the generated file is saved, as NODE.yaml')
    parser.add_argument('--print', action='store_true', help='accepted; without --output-dir everything is printed')


def dump_verb(arguments: argparse.Namespace) -> str | None:
    """Print or save the parameters of a node in the format that `--params-file` and `ros2 param load` read."""
    if arguments.print:
        complain("WARNING: '--print' is deprecated; this utility prints to stdout by default")
    with node_parameters.parameters_of(arguments) as parameters:
        text = node_parameters.nested_text(parameters.all_values(), parameters.name)
    if arguments.output_dir is None or arguments.print:
        say(text)
        return None
    path = os.path.join(
        current_process().cwd or '', arguments.output_dir, f'{parameters.name.strip("/").replace("/", "__")}.yaml'
    )
    try:
        with open(path, 'w', encoding='utf-8') as file:
            file.write(text)
    except OSError as error:
        return with_help(f"'{arguments.output_dir}' is not a valid directory.", error.strerror)
    say(f'Saving to:  {path}')
    return None


def get_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 param get`."""
    node_parameters.add_node_arguments(parser)
    parser.add_argument('parameter_name', help='Name of the parameter')
    parser.add_argument('--hide-type', action='store_true', help='Hide the type information')


def get_verb(arguments: argparse.Namespace) -> str | None:
    """Print the type and the value of the parameter."""
    name = arguments.parameter_name
    with node_parameters.parameters_of(arguments) as parameters:
        values = parameters.values([name])
        if not values:
            return with_help('Parameter not set', parameters.help_for(name))
    value = node_parameters.python_value(values[0])
    if value is None:
        say('Parameter not set.')
    else:
        say(str(value) if arguments.hide_type else f'{_label(values[0].type)} {value}')
    return None


def _label(kind: int) -> str:
    """Return the label for values of a parameter type, such as 'Double value is:' or 'Byte values are:'."""
    word, _, array = node_parameters.TYPE_WORDS[kind].partition(' ')
    return f'{word.capitalize()} {"values are" if array else "value is"}:'


def list_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 param list`."""
    node_parameters.add_node_arguments(parser, optional=True)
    parser.add_argument('--param-prefixes', nargs='+', default=[], help='Only list parameters with the provided prefixes')
    parser.add_argument('--param-type', action='store_true', help='Print parameter types with parameter names')
    parser.add_argument('--filter', metavar='REGEX', help='Only list parameters matching the provided regex')


def list_verb(arguments: argparse.Namespace) -> None:
    """Print the names of the node's parameters. If the user names no node, print the parameters of each node below its name."""
    if arguments.node_name is not None:
        with node_parameters.parameters_of(arguments) as parameters:
            _say(parameters, arguments, heading=False)
        return
    with cli_node.cli_node(arguments) as node:
        served = {name for name, _ in node.get_service_names_and_types()}
        for name in graph_names.node_names(node, arguments.include_hidden_nodes):
            if f'{name}/list_parameters' in served:
                parameters = node_parameters.ParametersOf(node, name)
                parameters.waits_s = (1.0,)
                try:
                    _say(parameters, arguments, heading=True)
                except cli_node.NoAnswer as error:
                    complain(str(error))


def _say(parameters: node_parameters.ParametersOf, arguments: argparse.Namespace, heading: bool) -> None:
    found = parameters.names(arguments.param_prefixes)
    if arguments.filter is not None:
        found = [name for name in found if re.search(arguments.filter, name)]
    if heading and found:
        say(f'{parameters.name}:')
    types = [descriptor.type for descriptor in parameters.descriptors(found)] if arguments.param_type else []
    for position, name in enumerate(found):
        say(f'  {name}' + (f' (type: {node_parameters.TYPE_WORDS[types[position]]})' if types else ''))


def load_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 param load`."""
    node_parameters.add_node_arguments(parser)
    parser.add_argument('parameter_file', help='Parameter file')
    parser.add_argument(
        '--no-use-wildcard', action='store_true', help="Do not load parameters in the '/**' namespace into the node"
    )


def load_verb(arguments: argparse.Namespace) -> str | None:
    """Set each parameter of the file, and print the results."""
    from rclpy.parameter import parameter_dict_from_yaml_file

    path = os.path.join(current_process().cwd or '', arguments.parameter_file)
    with node_parameters.parameters_of(arguments) as parameters:
        try:
            found = parameter_dict_from_yaml_file(path, not arguments.no_use_wildcard, [parameters.name])
        except OSError as error:
            return with_help(
                f"[Errno {error.errno}] {error.strerror}: '{arguments.parameter_file}'",
                'give the path from the folder where the command runs',
            )
        results = parameters.set(list(found.values()))
    for name, result in zip(found, results, strict=True):
        if result.successful:
            say(f'Set parameter {name} successful' + (f': {result.reason}' if result.reason else ''))
        else:
            complain(f'Set parameter {name} failed: {result.reason}')
    return None


def set_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 param set`."""
    node_parameters.add_node_arguments(parser)
    parser.add_argument('parameter_name', help='Name of the parameter')
    parser.add_argument('value', help='Value of the parameter, read as YAML')


def set_verb(arguments: argparse.Namespace) -> None:
    """Set the parameter and print the result. As in ROS 2, the exit code is 0 even if the node refuses."""
    import yaml
    from rcl_interfaces.msg import Parameter
    from rclpy.parameter import get_parameter_value

    name = arguments.parameter_name
    try:
        value = get_parameter_value(arguments.value)
    except (yaml.YAMLError, ValueError, RecursionError) as error:
        help = f"""for a string, use two kinds of quotation marks: '"{arguments.value}"'"""
        raise RuntimeError(with_help(str(error), help)) from None
    with node_parameters.parameters_of(arguments) as parameters:
        result = parameters.set([Parameter(name=name, value=value)])[0]
        reason = f': {result.reason}' if result.reason else ''
        if result.successful:
            say(f'Set parameter successful{reason}')
        else:
            known = node_parameters.type_help(result.reason)
            complain(with_help(f'Setting parameter failed{reason}', known or _name_help(parameters, name)))


def _name_help(parameters: node_parameters.ParametersOf, name: str) -> str | None:
    return None if name in parameters.names() else parameters.help_for(name)

"""`ros2 param set`: change a parameter."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import node_parameters
from edulaunch.cli.ros2.output import complain, say, with_help


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 param set`."""
    node_parameters.add_arguments(parser)
    parser.add_argument('parameter_name', help='Name of the parameter')
    parser.add_argument('value', help='Value of the parameter, read as YAML')


def main(arguments: argparse.Namespace) -> None:
    """Set it and print how that went; status 0 either way, as in ROS 2."""
    import yaml
    from rcl_interfaces.msg import Parameter
    from rclpy.parameter import get_parameter_value

    name = arguments.parameter_name
    try:
        value = get_parameter_value(arguments.value)
    except yaml.YAMLError as error:
        help = f"""to mean text, put it into quotation marks twice: '"{arguments.value}"'"""
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

"""`ros2 param get`: the value of a parameter."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import node_parameters
from edulaunch.cli.ros2.output import say, with_help

LABELS = (
    'Parameter not set.',
    'Boolean value is:',
    'Integer value is:',
    'Double value is:',
    'String value is:',
    'Byte values are:',
    'Boolean values are:',
    'Integer values are:',
    'Double values are:',
    'String values are:',
)


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 param get`."""
    node_parameters.add_arguments(parser)
    parser.add_argument('parameter_name', help='Name of the parameter')
    parser.add_argument('--hide-type', action='store_true', help='Hide the type information')


def main(arguments: argparse.Namespace) -> str | None:
    """Print it with its type."""
    name = arguments.parameter_name
    with node_parameters.parameters_of(arguments) as parameters:
        values = parameters.values([name])
        if not values:
            return with_help('Parameter not set', parameters.help_for(name))
    value = node_parameters.python_value(values[0])
    if value is None:
        say(LABELS[0])
    else:
        say(str(value) if arguments.hide_type else f'{LABELS[values[0].type]} {value}')
    return None

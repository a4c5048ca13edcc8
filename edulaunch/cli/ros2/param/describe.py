"""`ros2 param describe`: type, description and constraints of parameters."""

from __future__ import annotations

import argparse
from typing import Any

from edulaunch.cli.ros2 import node_parameters
from edulaunch.cli.ros2.names import say_lines
from edulaunch.cli.ros2.output import with_help


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 param describe`."""
    node_parameters.add_arguments(parser)
    parser.add_argument('parameter_names', nargs='+', help='Names of the parameters')


def main(arguments: argparse.Namespace) -> str | None:
    """Print what the node says of each."""
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

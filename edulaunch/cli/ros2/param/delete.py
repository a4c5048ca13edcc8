"""`ros2 param delete`: take a parameter away."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import node_parameters
from edulaunch.cli.ros2.output import complain, say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 param delete`."""
    node_parameters.add_arguments(parser)
    parser.add_argument('parameter_name', help='Name of the parameter')


def main(arguments: argparse.Namespace) -> None:
    """Set it to nothing and print how that went; status 0 either way, as in ROS 2."""
    from rcl_interfaces.msg import Parameter

    with node_parameters.parameters_of(arguments) as parameters:
        result = parameters.set([Parameter(name=arguments.parameter_name)])[0]
    reason = f': {result.reason}' if result.reason else ''
    if result.successful:
        say(f'Deleted parameter successfully{reason}')
    else:
        complain(f'Deleting parameter failed{reason}')

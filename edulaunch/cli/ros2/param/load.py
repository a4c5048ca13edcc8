"""`ros2 param load`: set the parameters of a parameter file."""

from __future__ import annotations

import argparse
import os

from edulaunch.cli.ros2 import node_parameters
from edulaunch.cli.ros2.output import complain, say, with_help
from edulaunch.processes.current import current_process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 param load`."""
    node_parameters.add_arguments(parser)
    parser.add_argument('parameter_file', help='Parameter file')
    parser.add_argument(
        '--no-use-wildcard', action='store_true', help="Do not load parameters in the '/**' namespace into the node"
    )


def main(arguments: argparse.Namespace) -> str | None:
    """Set each of them and print how that went."""
    from rclpy.parameter import parameter_dict_from_yaml_file

    path = os.path.join(current_process().cwd or '', arguments.parameter_file)
    with node_parameters.parameters_of(arguments) as parameters:
        try:
            found = parameter_dict_from_yaml_file(path, not arguments.no_use_wildcard, [parameters.name])
        except OSError as error:
            return with_help(
                f"[Errno {error.errno}] {error.strerror}: '{arguments.parameter_file}'",
                'the path counts from the folder where the command runs',
            )
        results = parameters.set(list(found.values()))
    for name, result in zip(found, results, strict=True):
        if result.successful:
            say(f'Set parameter {name} successful' + (f': {result.reason}' if result.reason else ''))
        else:
            complain(f'Set parameter {name} failed: {result.reason}')
    return None

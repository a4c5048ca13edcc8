"""`ros2 param dump`: all parameters of a node as a parameter file."""

from __future__ import annotations

import argparse
import os

from edulaunch.cli.ros2 import node_parameters
from edulaunch.cli.ros2.output import complain, say, with_help
from edulaunch.processes.current import current_process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The node, and where to write."""
    node_parameters.add_arguments(parser)
    parser.add_argument('--output-dir', help='The folder where the generated file is saved, as NODE.yaml')
    parser.add_argument('--print', action='store_true', help='accepted; without --output-dir everything is printed')


def main(arguments: argparse.Namespace) -> str | None:
    """Print them, or save them, as `--params-file` and `ros2 param load` read them."""
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

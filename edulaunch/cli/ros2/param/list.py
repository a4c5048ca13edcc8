"""`ros2 param list`: the parameters of one node or of all."""

from __future__ import annotations

import argparse
import re

from edulaunch.cli.ros2 import cli_node, names, node_parameters
from edulaunch.cli.ros2.node_parameters import ParametersOf
from edulaunch.cli.ros2.output import say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 param list`."""
    node_parameters.add_arguments(parser, optional=True)
    parser.add_argument('--param-prefixes', nargs='+', default=[], help='Only list parameters with the provided prefixes')
    parser.add_argument('--param-type', action='store_true', help='Print parameter types with parameter names')
    parser.add_argument('--filter', metavar='REGEX', help='Only list parameters matching the provided regex')


def main(arguments: argparse.Namespace) -> None:
    """Print names, under the name of their node when no node is given."""
    if arguments.node_name is not None:
        with node_parameters.parameters_of(arguments) as parameters:
            _say(parameters, arguments, heading=False)
        return
    with cli_node.cli_node(arguments) as node:
        served = {name for name, _ in node.get_service_names_and_types()}
        for name in names.node_names(node, arguments.include_hidden_nodes):
            if f'{name}/list_parameters' in served:
                _say(ParametersOf(node, name), arguments, heading=True)


def _say(parameters: ParametersOf, arguments: argparse.Namespace, heading: bool) -> None:
    found = parameters.names(arguments.param_prefixes)
    if arguments.filter is not None:
        found = [name for name in found if re.search(arguments.filter, name)]
    if heading and found:
        say(f'{parameters.name}:')
    types = [descriptor.type for descriptor in parameters.descriptors(found)] if arguments.param_type else []
    for position, name in enumerate(found):
        say(f'  {name}' + (f' (type: {node_parameters.TYPE_WORDS[types[position]]})' if types else ''))

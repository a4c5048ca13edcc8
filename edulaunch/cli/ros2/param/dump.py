"""`ros2 param dump`: all parameters of a node as a parameter file."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import node_parameters


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """As in ROS 2."""
    node_parameters.add_arguments(parser)


def main(arguments: argparse.Namespace) -> None:
    """Print them, as `--params-file` and `ros2 param load` read them."""
    with node_parameters.parameters_of(arguments) as parameters:
        node_parameters.say_nested(parameters.all_values(), parameters.name)

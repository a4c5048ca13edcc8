"""The options of `ros2 launch`, which `edulaunch launch` has, too."""

from __future__ import annotations

import argparse
from typing import TYPE_CHECKING

from edulaunch.errors import UnusableInput

if TYPE_CHECKING:
    from edulaunch.processes.process import Process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """How to launch, or only to look."""
    parser.add_argument(
        '-n', '--noninteractive', action='store_true', help='Run the launch system non-interactively, with no terminal associated'
    )
    parser.add_argument(
        '-d', '--debug', action='store_true', help='Put the launch system in debug mode, provides more verbose output.'
    )
    look = parser.add_mutually_exclusive_group()
    look.add_argument(
        '-p', '--print', '--print-description', action='store_true', help='Print the launch description, without launching it.'
    )
    look.add_argument(
        '-s', '--show-args', '--show-arguments', action='store_true', help='Show arguments that may be given to the launch file.'
    )
    parser.add_argument(
        '-a', '--show-all-subprocesses-output', action='store_true', help="Show all launched subprocesses' output"
    )
    parser.add_argument('--quiet', action='store_true', help='say nothing about mistakes that are found')
    parser.add_argument('--launch-prefix', help="Words in front of each program, in quotes, such as 'xterm -e gdb --args'")
    parser.add_argument('--launch-prefix-filter', help='Regular expression for the names of the programs that get the prefix')


def prefix_arguments(arguments: argparse.Namespace) -> dict[str, str]:
    """The launch configurations that hold the prefix.

    :raises UnusableInput: for a filter without a prefix, with ROS 2's text.
    """
    if arguments.launch_prefix is None and arguments.launch_prefix_filter is not None:
        raise UnusableInput('--launch-prefix must be specified if --launch-prefix-filter is provided')
    options = {'launch-prefix': arguments.launch_prefix, 'launch-prefix-filter': arguments.launch_prefix_filter}
    return {name: value for name, value in options.items() if value is not None}


def add_network(parser: argparse.ArgumentParser) -> None:
    """Whether it runs on a real network."""
    parser.add_argument('--network', action='store_true', help='join a real ROS 2 network while it runs (ROS_DOMAIN_ID)')
    parser.add_argument(
        '--network-topics',
        action='append',
        default=[],
        metavar='NAMES',
        help='topics and namespaces that cross, with commas; all',
    )
    parser.add_argument('--network-clock', action='store_true', help="publish the machine's time on /clock")
    parser.add_argument('--network-link', default='cyclonedds', metavar='LINK', help='what carries them: cyclonedds or rclpy')


def join_network(arguments: argparse.Namespace, process: Process) -> None:
    """Join the network that the options ask for, until the program ends.

    :raises EdulaunchError: when that cannot be.
    """
    if not (arguments.network or arguments.network_topics or arguments.network_clock):
        return
    if process.host.join_network is None:
        raise UnusableInput('--network needs a machine that runs in real time', help='ros2 launch ... in a terminal')
    names = [name for names in arguments.network_topics for name in names.split(',') if name]
    process.at_exit.append(process.host.join_network(process.env, arguments.network_link, arguments.network_clock, names))

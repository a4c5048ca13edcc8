"""`ros2 launch --network`: the shared machine joins a real ROS 2 network while a launch runs."""

from __future__ import annotations

import argparse

from edulaunch.desk.cli.ros2.output import say
from edulaunch.engine.processes.process import Process
from edulaunch.errors import UnusableInput
from edulaunch.extras.network import crossing


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add `--network` and its options."""
    parser.add_argument('--network', action='store_true', help='join a real ROS 2 network while it runs (ROS_DOMAIN_ID)')
    crossing.add_options(parser, 'network-')


def wants_network(arguments: argparse.Namespace) -> bool:
    """Return whether the command line contains `--network` or one of its options."""
    return bool(arguments.network or crossing.option_words(arguments, 'network-'))


def begin(arguments: argparse.Namespace, process: Process) -> None:
    """Join the network that the options describe, until the program ends.

    :raises EdulaunchError: when the machine cannot join.
    """
    if not wants_network(arguments):
        return
    if process.host.join_network is None:
        raise UnusableInput('--network needs a machine that runs in real time', help='type ros2 launch ... in a terminal')
    words = crossing.option_words(arguments, 'network-')
    process.lifecycle.at_exit.append(process.host.join_network(process.env, words, say))

"""`edulaunch launch --real`: each node runs as a real process. `--network` is for the machine of the terminals only."""

from __future__ import annotations

import argparse

from edulaunch.errors import UnusableInput
from edulaunch.extras.network.ros2_launch import add_options as add_network
from edulaunch.extras.network.ros2_launch import wants_network
from edulaunch.runtime.session import Session


def add_options(parser: argparse.ArgumentParser) -> None:
    """Whether nodes are real, and the options of `ros2 launch --network`."""
    add_network(parser)
    parser.add_argument(
        '--real', action='store_true', help='run each node as a real process on the real rclpy (edulaunch network install)'
    )


def session_class(arguments: argparse.Namespace) -> type[Session] | None:
    """What runs the launch; None for the simulation.

    :raises UnusableInput: for --real without the real rclpy, or with options that need simulated time; for --network.
    """
    if wants_network(arguments):
        why = 'a launch with a machine of its own joins no real network: only the machine of the terminals does'
        raise UnusableInput(why, help='type: ros2 launch --network ... (or --real: each node a real process)')
    if not arguments.real:
        return None
    from edulaunch.extras.native.environment import needed
    from edulaunch.extras.network.native_session import NativeSession

    if arguments.fast:
        raise UnusableInput('--fast needs simulated time.', help='leave out --fast, or --real')
    needed()
    return NativeSession

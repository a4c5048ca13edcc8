"""`edulaunch launch --real`: each node runs as a real process. `--network` is only for the shared machine."""

from __future__ import annotations

import argparse

from edulaunch.errors import UnusableInput
from edulaunch.extras.network.ros2_launch import add_options as add_network
from edulaunch.extras.network.ros2_launch import wants_network
from edulaunch.runtime.session import Session


def add_options(parser: argparse.ArgumentParser) -> None:
    """Add `--real`, and the options of `ros2 launch --network`."""
    add_network(parser)
    parser.add_argument(
        '--real',
        action='store_true',
        help='run each node as a real process on the real rclpy (requires edulaunch network install)',
    )


def session_class(arguments: argparse.Namespace) -> type[Session] | None:
    """Return the session class for the launch, or None for the simulation.

    :raises UnusableInput: for --real without the real rclpy or with options that need simulated time, and for --network.
    """
    if wants_network(arguments):
        why = 'edulaunch launch uses a private machine, but only the shared machine can join a real network'
        raise UnusableInput(why, help='type ros2 launch --network ..., or add --real to run each node as a real process')
    if not arguments.real:
        return None
    from edulaunch.extras.native.environment import needed
    from edulaunch.extras.network.native_session import NativeSession

    if arguments.fast:
        raise UnusableInput('--fast needs simulated time.', help='leave out --fast or --real')
    needed()
    return NativeSession

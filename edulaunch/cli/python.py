"""`edulaunch python node.py`: Python, with `rclpy`, `launch` ... and the packages of the workspaces here."""

from __future__ import annotations

import argparse
import os
import sys

from edulaunch.cli.env import sourced_environment


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """Whatever Python takes."""
    parser.add_argument('rest', nargs=argparse.REMAINDER, metavar='WORD', help='what you would tell python3')


def main(arguments: argparse.Namespace) -> int:
    """Run it; its exit code is the command's."""
    env = {**os.environ, **sourced_environment(os.environ)}
    words = [sys.executable, *arguments.rest]
    if os.name != 'nt':
        os.execve(sys.executable, words, env)
    import subprocess  # on Windows a program that is replaced seems to have ended to the shell

    return subprocess.run(words, env=env, check=False).returncode

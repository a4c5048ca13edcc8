"""`edulaunch network`: join the shared machine to a real ROS 2 network, or install the real rclpy."""

from __future__ import annotations

import argparse
import sys

from edulaunch.extras.network.crossing import add_options, join_request, option_words


def network_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of the verb: the command, and the names of the topics and services that cross."""
    commands = ('status', 'on', 'off', 'install')
    about = f'one of {", ".join(commands)} (default: status)'
    parser.add_argument('word', metavar='COMMAND', choices=commands, nargs='?', default='status', help=about)
    add_options(parser)


def network_verb(arguments: argparse.Namespace) -> int:
    """Send the command to the machine, or install the real rclpy. `on` starts a machine if necessary. Return the exit code."""
    from edulaunch.desk.machine.client import run

    if arguments.word == 'install':
        return _install()
    if arguments.word == 'status':
        _say_what_is_installed()
    words = ['machine', 'network', arguments.word]
    if arguments.word == 'on':
        words += option_words(arguments)
        join_request(option_words(arguments))
    return run(words, start=arguments.word == 'on')


def _say_what_is_installed() -> None:
    from edulaunch.extras.native import environment

    there = environment.found()
    if there is None:
        print(f'real rclpy: not installed ({environment.unsuited() or "type edulaunch network install"})', flush=True)
    else:
        print(f'real rclpy: {there.version} in {there.place}', flush=True)


def _install() -> int:
    """Create the environment. On a terminal, each step overwrites the previous one."""
    from edulaunch.extras.native import environment

    live = sys.stderr.isatty()
    made = environment.install(lambda step: print(f'\r\x1b[K{step}' if live else step, end='' if live else '\n', file=sys.stderr))
    if live:
        print('\r\x1b[K', end='', file=sys.stderr)
    print(f'real rclpy: {made.version} in {made.place}')
    return 0

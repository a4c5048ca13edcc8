"""`ros2 launch`: a launch file in this process."""

from __future__ import annotations

import argparse
import os

from edulaunch.launching import find_launch_file
from edulaunch.processes.current import current_process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """As in ROS 2."""
    parser.add_argument(
        '-n', '--noninteractive', action='store_true', help='Run the launch system non-interactively, with no terminal associated'
    )
    parser.add_argument(
        '-d', '--debug', action='store_true', help='Put the launch system in debug mode, provides more verbose output.'
    )
    parser.add_argument(
        '-a', '--show-all-subprocesses-output', action='store_true', help="Show all launched subprocesses' output"
    )
    shown = parser.add_mutually_exclusive_group()
    shown.add_argument(
        '-p',
        '--print',
        '--print-description',
        dest='print',
        action='store_true',
        help='Print the launch description to the console without launching it.',
    )
    shown.add_argument(
        '-s',
        '--show-args',
        '--show-arguments',
        dest='show_args',
        action='store_true',
        help='Show arguments that may be given to the launch file.',
    )
    _add_names(parser)


def _add_names(parser: argparse.ArgumentParser) -> None:
    """What to launch, and with which arguments."""
    parser.add_argument('package_name', help='Name of the ROS package which contains the launch file, or path of a launch file')
    parser.add_argument('launch_file_name', nargs='?', help='Name of the launch file')
    parser.add_argument(
        'launch_arguments', nargs='*', help="Arguments to the launch file; '<name>:=<value>' (for duplicates, last one wins)"
    )


def main(arguments: argparse.Namespace) -> int:
    """Launch it and wait for the end; returns launch's exit code.

    :raises UnusableInput: when there is no such package or file; in the words of ROS 2.
    """
    from ros2launch import api

    process, given = current_process(), list(arguments.launch_arguments)
    path = os.path.join(process.cwd or '', arguments.package_name)
    if os.path.isfile(path):
        given = [word for word in (arguments.launch_file_name,) if word is not None] + given
    else:
        path = find_launch_file(process.index, arguments.package_name, arguments.launch_file_name)
    if arguments.show_args or arguments.print:
        (api.print_arguments_of_launch_file if arguments.show_args else api.print_a_launch_file)(launch_file_path=path)
        return 0
    if arguments.show_all_subprocesses_output:
        process.env['OVERRIDE_LAUNCH_PROCESS_OUTPUT'] = 'both'
    return int(
        api.launch_a_launch_file(
            launch_file_path=path,
            launch_file_arguments=given,
            noninteractive=arguments.noninteractive or not process.stdin.isatty(),
            debug=arguments.debug,
        )
    )

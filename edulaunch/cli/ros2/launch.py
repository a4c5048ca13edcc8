"""`ros2 launch`: a launch file in this process."""

from __future__ import annotations

import argparse
import os

from edulaunch.cli import launch_options
from edulaunch.cli.ros2.output import say
from edulaunch.launching import LAUNCH_SUFFIXES, find_launch_file
from edulaunch.processes.current import current_process
from edulaunch.processes.process import Process


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """What to launch, how, and with which arguments."""
    launch_options.add_arguments(parser)
    parser.add_argument('--view', action='store_true', help='open the live page in a browser while it runs')
    launch_options.add_network(parser)
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

    process = current_process()
    given = [f'{name}:={value}' for name, value in launch_options.prefix_arguments(arguments).items()]
    path, first = _launch_file(process, arguments)
    given += [*first, *arguments.launch_arguments]
    if arguments.show_args or arguments.print:
        (api.print_arguments_of_launch_file if arguments.show_args else api.print_a_launch_file)(launch_file_path=path)
        return 0
    launch_options.join_network(arguments, process)
    if arguments.view:
        say('to see what runs, type in another terminal: edulaunch view')
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


def _launch_file(process: Process, arguments: argparse.Namespace) -> tuple[str, list[str]]:
    """The path of the launch file, from the folder of the terminal, and a launch argument that stands where its name could."""
    word, name = arguments.package_name, arguments.launch_file_name
    path = os.path.join(process.cwd or '', word)
    is_argument = name is not None and ':=' in name
    if os.path.isfile(path) or ((name is None or is_argument) and (os.sep in word or word.endswith(LAUNCH_SUFFIXES))):
        return find_launch_file(process.index, path, None), [] if name is None else [name]
    return find_launch_file(process.index, word, None if is_argument else name), [name] if is_argument else []

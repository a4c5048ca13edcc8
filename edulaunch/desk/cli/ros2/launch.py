"""`ros2 launch` runs a launch file in its own process, and `ros2 run` runs a program.

`edulaunch launch` has the same options as `ros2 launch`.
"""

from __future__ import annotations

import argparse
import os
import shlex
import signal
from typing import Any

from edulaunch.desk.cli.plugin_options import plugins_of
from edulaunch.desk.cli.ros2.output import say, with_help
from edulaunch.engine.packages import Index
from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.sim.task import current_task
from edulaunch.errors import UnusableInput
from edulaunch.ros.sources.missing import missing_executable, missing_package
from edulaunch.runtime.launching import LAUNCH_SUFFIXES, find_launch_file, launch_argument


def add_launch_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options of `ros2 launch`, including the options that only show the launch file."""
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
    parser.add_argument('--quiet', action='store_true', help='do not report mistakes')
    parser.add_argument('--launch-prefix', help="Words in front of each program, in quotes, such as 'xterm -e gdb --args'")
    parser.add_argument('--launch-prefix-filter', help='Regular expression for the names of the programs that get the prefix')


def prefix_arguments(arguments: argparse.Namespace) -> dict[str, str]:
    """Return the launch configurations for the options `--launch-prefix` and `--launch-prefix-filter`.

    :raises UnusableInput: for a filter without a prefix, with the message of ROS 2.
    """
    if arguments.launch_prefix is None and arguments.launch_prefix_filter is not None:
        raise UnusableInput('--launch-prefix must be specified if --launch-prefix-filter is provided')
    options = {'launch-prefix': arguments.launch_prefix, 'launch-prefix-filter': arguments.launch_prefix_filter}
    return {name: value for name, value in options.items() if value is not None}


def launch_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the arguments of `ros2 launch`: the launch file, the options and the launch arguments."""
    add_launch_arguments(parser)
    parser.add_argument('--view', action='store_true', help='open the live view in a browser while it runs')
    parser.add_argument('package_name', help='Name of the ROS package which contains the launch file, or path of a launch file')
    parser.add_argument('launch_file_name', nargs='?', help='Name of the launch file')
    parser.add_argument(
        'launch_arguments', nargs='*', help="Arguments to the launch file; '<name>:=<value>' (for duplicates, last one wins)"
    )


def launch_verb(arguments: argparse.Namespace) -> int:
    """Run the launch file to its end. Return the exit code of launch.

    :raises UnusableInput: for an unknown package or file, or an argument without `:=`, with the message of ROS 2.
    """
    from ros2launch import api

    from edulaunch.runtime.launch_process import note_launch_files, note_unread_arguments

    process = current_process()
    given = [f'{name}:={value}' for name, value in prefix_arguments(arguments).items()]
    path, first = _launch_file(process, arguments)
    given += [*first, *arguments.launch_arguments]
    if arguments.show_args or arguments.print:
        (api.print_arguments_of_launch_file if arguments.show_args else api.print_a_launch_file)(launch_file_path=path)
        return 0
    named = dict(map(launch_argument, given))
    for options in plugins_of(arguments):
        options.begin(arguments, process)
    if arguments.view:
        say('to see what runs, type in another terminal: edulaunch view')
    if arguments.show_all_subprocesses_output:
        process.env['OVERRIDE_LAUNCH_PROCESS_OUTPUT'] = 'both'
    code = api.launch_a_launch_file(
        launch_file_path=path,
        launch_file_arguments=given,
        noninteractive=arguments.noninteractive or not process.streams.stdin.isatty(),
        debug=arguments.debug,
    )
    note_unread_arguments(process, named)
    note_launch_files(process, path)
    return int(code)


def _launch_file(process: Process, arguments: argparse.Namespace) -> tuple[str, list[str]]:
    """Return the path of the launch file, and a list with the second word if it does not name the launch file.

    A path in the command line is relative to the folder of the terminal.
    """
    word, name = arguments.package_name, arguments.launch_file_name
    path = os.path.join(process.cwd or '', word)
    is_argument = name is not None and ':=' in name
    if os.path.isfile(path) or ((name is None or is_argument) and (os.sep in word or word.endswith(LAUNCH_SUFFIXES))):
        return find_launch_file(process.index, path, None), [] if name is None else [name]
    return find_launch_file(process.index, word, None if is_argument else name, as_ros=True), [name] if is_argument else []


def run_arguments(parser: argparse.ArgumentParser) -> None:
    """Add the options and arguments of `ros2 run`."""
    parser.add_argument('--prefix', help='Prefix command, which should go before the executable')
    parser.add_argument('--quiet', action='store_true', help='do not report mistakes')
    parser.add_argument('package_name', help='Name of the ROS package')
    parser.add_argument('executable_name', help='Name of the executable')
    parser.add_argument('argv', nargs=argparse.REMAINDER, help='Pass arbitrary arguments to the executable')


def run_verb(arguments: argparse.Namespace) -> int | str:
    """Run the program to its end. Return its exit code, or an error message if there is no such program."""
    from edulaunch.advice.workspace.not_needed import WINDOWS, shown_by

    process = current_process()
    package, executable = arguments.package_name, arguments.executable_name
    path = process.index.find_executable(package, executable)
    if path is None and package in WINDOWS:
        say(shown_by(package))
        return 0
    if path is None:
        return _not_found(process.index, package, executable)
    words = [*shlex.split(arguments.prefix or ''), path, *arguments.argv]
    spec = ProcessSpec(
        argv=tuple(words),
        name=process.name,
        cwd=process.cwd,
        env=dict(process.env),
        origin=process.spec.origin,
        package=package,
        executable=executable,
        has_pipe=process.spec.has_pipe,
    )
    code = run_child(process, spec)
    if code:
        say(f'[ros2run]: {signal.strsignal(-code) if code < 0 else f"Process exited with failure {code}"}')
    return code


def run_child(process: Process, spec: ProcessSpec) -> int:
    """Run a program that writes to the streams of `process`. Return the return code of the program.

    If `process` is interrupted by Ctrl-C, the program receives SIGINT.
    """
    from edulaunch.engine.processes.children import inherit_terminal

    task = current_task()
    child: Any = process.host.start(spec, process.on_output or process.write, lambda code: task.wake())
    child.is_passed_on = True
    inherit_terminal(process, child)
    for stream in ('stdout', 'stderr') if isinstance(child, Process) else ():
        getattr(child.streams, stream).is_terminal = getattr(process.streams, stream).is_terminal
    process.lifecycle.at_exit.append(lambda: child.send_signal(signal.SIGTERM))
    while child.returncode is None:
        try:
            task.park()
        except KeyboardInterrupt:
            child.send_signal(signal.SIGINT)
    return int(child.returncode)


def _not_found(index: Index, package: str, executable: str) -> str:
    from edulaunch.advice.rendering import help_of_facts

    if package not in index.packages():
        return with_help(f"Package '{package}' not found", help_of_facts(missing_package(index, package, current_process().cwd)))
    native = index.native_executables(package)
    if executable in native:
        return with_help(
            'No executable found', f'{executable} is compiled from C++ ({native[executable]}), which cannot run here'
        )
    return with_help('No executable found', help_of_facts(missing_executable(index, package, executable)))

"""`ros2 run`: start a program of a package."""

from __future__ import annotations

import argparse
import signal
from typing import Any

from edulaunch.cli.ros2.output import say, with_help
from edulaunch.packages import Index
from edulaunch.processes.children import inherit_terminal
from edulaunch.processes.current import current_process
from edulaunch.processes.process import Process
from edulaunch.processes.spec import ProcessSpec
from edulaunch.sim.task import current_task
from edulaunch.workspace.not_needed import WINDOWS, shown_by


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The options and words of `ros2 run`."""
    parser.add_argument('--prefix', help='Prefix command, which should go before the executable')
    parser.add_argument('--quiet', action='store_true', help='say nothing about mistakes that are found')
    parser.add_argument('package_name', help='Name of the ROS package')
    parser.add_argument('executable_name', help='Name of the executable')
    parser.add_argument('argv', nargs=argparse.REMAINDER, help='Pass arbitrary arguments to the executable')


def main(arguments: argparse.Namespace) -> int | str:
    """Run it to its end; returns its exit code."""
    process = current_process()
    package, executable = arguments.package_name, arguments.executable_name
    path = process.index.find_executable(package, executable)
    if path is None and package in WINDOWS:
        say(shown_by(package))
        return 0
    if path is None:
        return _not_found(process.index, package, executable)
    import shlex

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
    """Run a program that writes to the streams of `process` and gets its Ctrl-C; returns its return code."""
    task = current_task()
    child: Any = process.host.start(spec, process.on_output or process.write, lambda code: task.wake())
    child.is_passed_on = True
    inherit_terminal(process, child)
    for stream in ('stdout', 'stderr') if isinstance(child, Process) else ():
        getattr(child, stream).is_terminal = getattr(process, stream).is_terminal
    process.at_exit.append(lambda: child.send_signal(signal.SIGTERM))
    while child.returncode is None:
        try:
            task.park()
        except KeyboardInterrupt:
            child.send_signal(signal.SIGINT)
    return int(child.returncode)


def _not_found(index: Index, package: str, executable: str) -> str:
    from edulaunch.advice.below import help_of_facts
    from edulaunch.workspace.missing import missing_executable, missing_package

    if package not in index.packages():
        return with_help(f"Package '{package}' not found", help_of_facts(missing_package(index, package)))
    native = index.native_executables(package)
    if executable in native:
        return with_help('No executable found', f'{executable} is made from C++ ({native[executable]}), which cannot run here')
    return with_help('No executable found', help_of_facts(missing_executable(index, package, executable)))

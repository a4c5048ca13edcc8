"""The command `launch_test FILE [name:=value ...]`: runs a launch test file.

Each run opens a simulation of its own (`_simulated.py`).
"""

from __future__ import annotations

import os
import sys
from collections.abc import Sequence
from typing import TYPE_CHECKING, Any

from launch._lazy import has_ros_paths
from launch.launch_description import LaunchDescription

from edulaunch.errors import UnusableInput
from edulaunch.processes.current import current_process
from edulaunch.processes.traceback_text import student_traceback

from ._simulated import run_launch_test
from .loader import LoadTestsFromPythonModule, TestRun
from .test_result import TestResult, is_pytest_outcome

if TYPE_CHECKING:
    import argparse


class LaunchTest:
    """One run of a test file. Make it anywhere; :meth:`run` belongs inside a simulated process.

    :param path: of the test file.
    :param arguments: launch arguments, `name:=value`.
    :ivar results: how each launch went; empty before the run.
    :ivar error: why the file could not be run at all, or None.
    """

    def __init__(self, path: str, arguments: Sequence[str] = (), *, debug: bool = False) -> None:
        self.path = os.path.abspath(path)
        self.name = os.path.splitext(os.path.basename(path))[0].replace('.', '_')
        self.arguments = list(arguments)
        self.debug = debug
        self.results: dict[TestRun, TestResult] = {}
        self.error: BaseException | None = None

    def load(self) -> list[TestRun]:
        """Execute the file with the private modules of the running process; gives its launches."""
        module = current_process().loader.run_file(self.path, self.name)
        if not hasattr(module, 'generate_test_description'):
            raise AttributeError(f"Test file '{self.path}' does not contain generate_test_description function")
        return LoadTestsFromPythonModule(module, name=self.name)

    def run(self) -> int:
        """Run everything in the file; returns 0 when all went well, else 1."""
        from .test_runner import LaunchTestRunner

        try:
            self.results = LaunchTestRunner(self.load(), self.arguments, self.debug).run()
        except BaseException as error:
            if not isinstance(error, Exception) and not is_pytest_outcome(error):
                raise
            self.error = error
            current_process().stderr.write(self.error_text())
            return 1
        return 0 if all(result.wasSuccessful() for result in self.results.values()) else 1

    def error_text(self) -> str:
        """What `error` says, with the student's lines of the traceback if there are any."""
        assert self.error is not None
        text, place = student_traceback(self.error)
        return text if place is not None else f'{type(self.error).__name__}: {self.error}\n'

    def show_arguments(self) -> int:
        """Print the launch arguments of the (first) description; returns 0."""
        from ros2launch.api.api import arguments_text

        description, _ = self.load()[0].normalized_test_description(lambda: None)
        current_process().stdout.write(arguments_text(description) + '\n')
        return 0

    def write_junit_xml(self, path: str, package_name: str | None) -> None:
        """Write the results as JUnit XML."""
        from .junitxml import unittestResultsToXml

        name = self.name if package_name is None else f'{package_name}.{self.name}'
        tree: Any = unittestResultsToXml(name=name, test_results=self.results)
        tree.write(path, xml_declaration=True, encoding='UTF-8')


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """The file, and the options of ROS 2's `launch_test`."""
    parser.add_argument('test_file', metavar='FILE', help='path of the launch test')
    parser.add_argument('launch_arguments', nargs='*', metavar='name:=value', help='arguments of the launch description')
    parser.add_argument('-v', '--verbose', action='store_true', help='let launch log at level DEBUG')
    parser.add_argument('-s', '--show-args', '--show-arguments', action='store_true', help='show the arguments that may be given')
    parser.add_argument('--junit-xml', metavar='FILE', help='write the results as JUnit XML')
    parser.add_argument('--package-name', metavar='NAME', help='name of the package, for the JUnit XML')
    parser.add_argument('--workspace', action='append', metavar='DIR', help="folder with packages; default: the test file's own")


def main(argv: Sequence[str] | None = None) -> int:
    """`launch_test FILE [name:=value ...] [-v] [-s] [--junit-xml FILE]`; returns the exit code, 2 for unusable input."""
    import argparse

    parser = argparse.ArgumentParser(prog='launch_test', description='Run a launch test in simulated time.')
    add_arguments(parser)
    given = parser.parse_args(argv)
    if not os.path.isfile(given.test_file):
        parser.error(f"Test file '{given.test_file}' does not exist")
    test = LaunchTest(given.test_file, given.launch_arguments, debug=given.verbose)
    try:
        code = run_launch_test(test, workspaces=given.workspace, body=test.show_arguments if given.show_args else None)
    except KeyboardInterrupt:
        return 130
    if isinstance(test.error, UnusableInput):
        sys.stderr.write(f'error: {test.error}\n')
    if given.junit_xml:
        test.write_junit_xml(given.junit_xml, given.package_name)
    return code


if __name__ == '__main__':
    raise SystemExit(main())


def print_arguments_of_launch_description(*, launch_description: LaunchDescription) -> None:
    """Print the launch arguments of a description, as `launch_test --show-args` does."""
    from ros2launch.api.api import arguments_text

    current_process().stdout.write(arguments_text(launch_description) + '\n')


has_ros_paths(__name__)

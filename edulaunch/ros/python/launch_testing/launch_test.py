"""The command `launch_test FILE [name:=value ...]`, and launch tests in a simulation of their own, also for the pytest plugin."""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence

from edulaunch.engine.processes.current import current_process
from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.processes.traceback_text import student_traceback
from edulaunch.engine.sim.interruption import Interruption
from edulaunch.engine.sim.pacing import Pacer
from edulaunch.errors import UnusableInput
from edulaunch.extras.testing import workspaces_of
from edulaunch.runtime.session import Session

from .loader import TestRun, runs_of
from .test_result import TestResult, is_pytest_outcome

LONGEST_TEST_S = 3600.0


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
        return runs_of(module, self.name)

    def run(self) -> int:
        """Run everything in the file; returns 0 when all went well, else 1."""
        from .test_runner import run_all

        try:
            self.results = run_all(self.load(), self.arguments, self.debug)
        except BaseException as error:
            if not isinstance(error, Exception) and not is_pytest_outcome(error):
                raise
            self.error = error
            current_process().streams.stderr.write(self.error_text())
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

        description, _ = self.load()[0].description(lambda: None)
        current_process().streams.stdout.write(arguments_text(description) + '\n')
        return 0


def run_launch_test(
    test: LaunchTest, *, workspaces: Sequence[str] | None = None, seed: int = 0, body: Callable[[], int] | None = None
) -> int:
    """Run a launch test in a fresh simulation; its console goes to this program's own.

    :param workspaces: folders with packages; None: the workspace in which the test file lies.
    :param body: what the process does; None: `test.run`.
    :returns: 0 when all went well. What went wrong else is in `test.results` and `test.error`.
    :raises KeyboardInterrupt: after Ctrl-C.
    """
    words = ['launch_test', test.path, *test.arguments]
    with Session(seed=seed, workspaces=workspaces_of(test.path) if workspaces is None else workspaces) as session:
        spec = ProcessSpec(argv=tuple(words), name='launch_test')
        process = Process(session.host, spec, session.host.next_pid(), words, lambda _: (body or test.run)())
        process.on_output = _print
        process.loader.roots += session.index.python_roots()
        session.host.adopt(process)
        until_ns = session.sim.now_ns + round(LONGEST_TEST_S * 1e9)
        with streams_of_programs(), Interruption(session.sim) as interruption:
            Pacer(session.sim, 0).run(until_ns, lambda: interruption.came or process.returncode is not None)
        if interruption.came:
            raise KeyboardInterrupt
        if process.returncode is None:
            test.error = UnusableInput(
                f'{os.path.basename(test.path)}: the launch test was still waiting '
                f'after {session.sim.elapsed_s:.1f} s of simulated time.',
                help='give waits a timeout, such as event.wait(timeout=10)',
            )
        return 1 if process.returncode is None else process.returncode


def _print(stream: str, text: str) -> None:
    target = sys.stdout if stream == 'stdout' else sys.stderr
    target.write(text)
    target.flush()


def _parser() -> argparse.ArgumentParser:
    """The file, and the options of ROS 2's `launch_test`."""
    parser = argparse.ArgumentParser(prog='launch_test', description='Run a launch test in simulated time.')
    parser.add_argument('test_file', metavar='FILE', help='path of the launch test')
    parser.add_argument('launch_arguments', nargs='*', metavar='name:=value', help='arguments of the launch description')
    parser.add_argument('-v', '--verbose', action='store_true', help='let launch log at level DEBUG')
    parser.add_argument('-s', '--show-args', '--show-arguments', action='store_true', help='show the arguments that may be given')
    parser.add_argument('--junit-xml', metavar='FILE', help='write the results as JUnit XML')
    parser.add_argument('--package-name', metavar='NAME', help='name of the package, for the JUnit XML')
    parser.add_argument('--workspace', action='append', metavar='DIR', help="folder with packages; default: the test file's own")
    return parser


def main(argv: Sequence[str] | None = None) -> int:
    """`launch_test FILE [name:=value ...] [-v] [-s] [--junit-xml FILE]`; returns the exit code, 2 for unusable input."""
    parser = _parser()
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
        from .junitxml import unittestResultsToXml

        name = test.name if given.package_name is None else f'{given.package_name}.{test.name}'
        tree = unittestResultsToXml(name=name, test_results=test.results)
        tree.write(given.junit_xml, xml_declaration=True, encoding='UTF-8')
    return code


if __name__ == '__main__':
    raise SystemExit(main())

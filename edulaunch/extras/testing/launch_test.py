"""The command `launch_test FILE [name:=value ...]`, and launch tests in their own simulation. The pytest plugin uses them,
too.
"""

from __future__ import annotations

import argparse
import os
import sys
from collections.abc import Callable, Sequence

from launch_testing.launch_test import LaunchTest

from edulaunch.engine.processes.process import Process
from edulaunch.engine.processes.spec import ProcessSpec
from edulaunch.engine.processes.streams import streams_of_programs
from edulaunch.engine.sim.interruption import Interruption
from edulaunch.engine.sim.pacing import Pacer
from edulaunch.errors import UnusableInput
from edulaunch.extras.testing import workspaces_of
from edulaunch.runtime.session import Session

LONGEST_TEST_S = 3600.0


def run_launch_test(
    test: LaunchTest, *, workspaces: Sequence[str] | None = None, seed: int = 0, body: Callable[[], int] | None = None
) -> int:
    """Run a launch test in a new simulation. The test writes to this program's console.

    :param workspaces: folders with packages; None means the workspace of the test file.
    :param body: the main function of the process; None means `test.run`.
    :returns: 0 on success. `test.results` and `test.error` have the failures.
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
                help='give each wait a timeout, such as event.wait(timeout=10)',
            )
        return 1 if process.returncode is None else process.returncode


def _print(stream: str, text: str) -> None:
    target = sys.stdout if stream == 'stdout' else sys.stderr
    target.write(text)
    target.flush()


def _parser() -> argparse.ArgumentParser:
    """Return the parser for the file and the options of ROS 2's `launch_test`."""
    parser = argparse.ArgumentParser(prog='launch_test', description='Run a launch test in simulated time.')
    parser.add_argument('test_file', metavar='FILE', help='path of the launch test')
    parser.add_argument('launch_arguments', nargs='*', metavar='name:=value', help='arguments of the launch description')
    parser.add_argument('-v', '--verbose', action='store_true', help='let launch log at level DEBUG')
    parser.add_argument(
        '-s', '--show-args', '--show-arguments', action='store_true', help='show the arguments of the launch description'
    )
    parser.add_argument('--junit-xml', metavar='FILE', help='write the results as JUnit XML')
    parser.add_argument('--package-name', metavar='NAME', help='name of the package, for the JUnit XML')
    parser.add_argument(
        '--workspace', action='append', metavar='DIR', help='folder with packages (default: the workspace of the test file)'
    )
    return parser


def main(argv: Sequence[str] | None = None) -> int:
    """Run `launch_test FILE [name:=value ...] [-v] [-s] [--junit-xml FILE]`. Return the exit code, which is 2 for invalid
    input.
    """
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
        from launch_testing.junitxml import unittestResultsToXml

        name = test.name if given.package_name is None else f'{given.package_name}.{test.name}'
        tree = unittestResultsToXml(name=name, test_results=test.results)
        tree.write(given.junit_xml, xml_declaration=True, encoding='UTF-8')
    return code

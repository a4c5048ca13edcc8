"""`ros2 doctor` (or `ros2 wtf`): looks at the packages and the graph, and says what may be wrong."""

from __future__ import annotations

import argparse

from edulaunch.cli.ros2 import cli_node, doctor_checks, doctor_report
from edulaunch.cli.ros2.output import complain, say


def add_arguments(parser: argparse.ArgumentParser) -> None:
    """A report instead of the checks, and what counts."""
    parser.add_argument('check', nargs='?', choices=('hello',), help='hello: say that terminals of this machine hear each other')
    shown = parser.add_mutually_exclusive_group()
    shown.add_argument('-r', '--report', action='store_true', help='Print all reports.')
    shown.add_argument('-rf', '--report-failed', action='store_true', help='Print reports of failed checks only.')
    parser.add_argument('-ep', '--exclude-packages', action='store_true', help='Exclude package checks or report.')
    parser.add_argument('-iw', '--include-warnings', action='store_true', help='Include warnings as failed checks.')


def main(arguments: argparse.Namespace) -> int:
    """Print warnings, and how many checks passed; 1 when one failed."""
    if arguments.check == 'hello':
        say('All terminals of this simulated machine hear each other: there is no network between them.')
        return 0
    with cli_node.cli_node(argparse.Namespace(spin_time=None, no_daemon=False)) as node:
        if arguments.report:
            doctor_report.say_report(node, doctor_report.SECTIONS, arguments.exclude_packages)
            return 0
        results = doctor_checks.run(node, arguments.exclude_packages)
        failed = [name for name, found in results.items() if found.errors or (arguments.include_warnings and found.warnings)]
        for found in results.values():
            for line in (*found.warnings, *found.errors):
                complain(line)
        if not failed:
            say(f'\nAll {len(results)} checks passed\n')
            return 0
        say(f'\n{len(failed)}/{len(results)} check(s) failed\n\nFailed modules: {" ".join(failed)}\n')
        if arguments.report_failed:
            doctor_report.say_report(node, failed, arguments.exclude_packages)
    return 1

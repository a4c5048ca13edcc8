"""The options of the command `edugrade`."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from edulaunch.errors import UnusableInput
from edulaunch.runtime.version import __version__

from .rubrics.catalogue import exercises

EXAMPLES = """\
examples:
  edugrade exercises/circle.launch.py                  grade a launch file; its name selects the rubric
  edugrade exercises/large_project                     grade a package: launch its launch/large_project.launch.py
  edugrade exercises/*.launch.py --html report.html    grade several files, and write a page with pictures of the runs
  edugrade circle.launch.py --json report.json         write the report as JSON, too
  edugrade my_file.launch.py --rubric circle           grade a file that has another name
  edugrade exercises/circle.launch.py --hint 1         print a hint instead of a report (levels 1 to 3)

commands (edugrade COMMAND --help describes one):
"""
EXIT_CODES = """
exit status (the highest, if there are several reports):
  0  all checks passed
  1  at least one check failed or could not be run
  2  invalid input: no such file, no rubric for it, or a launch file that does not run at all
  3  the grader failed; this is never the student's fault, and gives no mark
"""


def read_options(argv: Sequence[str] | None) -> argparse.Namespace:
    """Parse the command line. If it is invalid, print a usage message and exit."""
    parser = edugrade_parser()
    if argv is None or {'-h', '--help'} & set(argv):
        parser.epilog = _epilog()
    return parser.parse_args(argv)


def edugrade_parser() -> argparse.ArgumentParser:
    """Return the parser of `edugrade PATH ...`, without the examples of its help."""
    parser = argparse.ArgumentParser(
        prog='edugrade',
        usage='edugrade [OPTION ...] PATH [PATH ...]\n       edugrade COMMAND ...',
        description='Grade ROS 2 launch files and packages by what they do in simulation.',
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument('--version', action='version', version=f'edugrade {__version__}')
    parser.add_argument('paths', metavar='PATH', nargs='+', help='a launch file, or the folder of a package')
    parser.add_argument('--json', metavar='FILE', help='also write the report as JSON')
    parser.add_argument('--junit', metavar='FILE', help='also write the report as JUnit XML, for CI servers')
    parser.add_argument('--html', metavar='FILE', help='also write the report as a web page, with pictures and a replay')
    add_common(parser)
    parser.add_argument(
        '--student',
        metavar='NAME',
        default='',
        help='name of the student; it is stored in the report and helps to select the runs',
    )
    parser.add_argument(
        '--advice',
        type=int,
        choices=(1, 2, 3),
        help='how specific the advice is. 1 names the kind of mistake, 2 the missing thing, and 3 how to write it. By default, '
        'each attempt and each hint make it more specific, or it is 1 outside a course. Does not count as an attempt',
    )
    parser.add_argument('--hint', type=int, choices=(1, 2, 3), help='print a hint of this level instead of grading')
    return parser


def _epilog() -> str:
    """Return examples, the commands that plug-ins add, and the exit codes."""
    from edulaunch.runtime import plugins

    verbs = sorted(plugins.grading_verbs().items())
    added = (f'  {verb.example:<50} {verb.about}\n' for _, verb in verbs)
    return ''.join((EXAMPLES, *added, EXIT_CODES))


def add_common(parser: argparse.ArgumentParser) -> None:
    """Add the options that all grading commands have to a parser."""
    parser.add_argument('--rubric', metavar='FILE|NAME', help='use this rubric; known names: ' + ', '.join(exercises()))
    parser.add_argument(
        '--seed',
        type=_whole,
        metavar='N',
        help="select the values of the runs from this number (default: from the file's content)",
    )
    parser.add_argument(
        '--only', metavar='CHECK', help='grade only this check and the checks that it needs; a batch keeps its other results'
    )
    parser.add_argument(
        '--course-secret-file',
        metavar='FILE',
        help='select the runs from this secret and the name of the student, so that students cannot predict them',
    )
    parser.add_argument(
        '--personal',
        action='store_true',
        help='each student has a personalised exercise (edulaunch course copy --student), made with the same secret file',
    )
    parser.add_argument(
        '--limit', type=_seconds, default=30.0, metavar='SECONDS', help='longest real time of each run (default: 30)'
    )
    parser.add_argument(
        '--workspace', action='append', default=[], metavar='DIR', help='a workspace with your own packages (repeatable)'
    )
    parser.add_argument(
        '--sandbox',
        choices=('auto', 'require', 'off'),
        default='auto',
        help='auto (default) uses what this system offers of the sandbox, require (default of a batch) needs all of it, '
        'and off uses none',
    )


def is_personal(options: argparse.Namespace) -> bool:
    """Return whether each student has personal exercises.

    :raises UnusableInput: if --personal is given without the secret.
    """
    if options.personal and not options.course_secret_file:
        raise UnusableInput(
            '--personal needs the secret with which the exercises were made', help='add --course-secret-file FILE'
        )
    return bool(options.personal)


def _whole(text: str) -> int:
    try:
        return int(text)
    except ValueError:
        raise argparse.ArgumentTypeError(f'{text!r} is not a whole number; write a number, as in --seed 7') from None


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 86_400:
        raise argparse.ArgumentTypeError(f'{text} is not a valid number of seconds')
    return value

"""The words of the command line."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from edulaunch.errors import UnusableInput
from edulaunch.version import __version__

from .rubrics.catalogue import exercises

EXAMPLES = """\
examples:
  edugrade exercises/circle.launch.py                  grade a launch file; the rubric is found by its name
  edugrade exercises/large_project                     a package: its launch/large_project.launch.py is launched
  edugrade exercises/*.launch.py --html report.html    several at once; a page with pictures of the runs
  edugrade circle.launch.py --json report.json         write the report as data too
  edugrade my_try.launch.py --rubric circle            a file of another name
  edugrade exercises/circle.launch.py --hint 1         a hint instead of a report (levels 1 to 3)
  edugrade course                                      whether exercises, solutions and rubrics belong together
  edugrade decoys                                      what the rubrics of a course pay for names without behaviour
  edugrade schema                                      the JSON schema of reports
"""
EXIT_CODES = """
exit codes (the worst one, of several):
  0  all checks passed
  1  some failed or could not be run
  2  unusable input: no such file, no rubric for it, or a launch file that cannot be run at all
  3  the grader broke; that is never the student's fault and gives no mark
"""


def read_options(argv: Sequence[str] | None) -> argparse.Namespace:
    """Parse the command line; ends the program with a usage message when it is wrong."""
    parser = argparse.ArgumentParser(
        prog='edugrade',
        description='Grade ROS 2 launch files by what they do when they are launched, in simulation.',
        epilog=_epilog() if argv is None or {'-h', '--help'} & set(argv) else None,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument('--version', action='version', version=f'edugrade {__version__}')
    parser.add_argument('paths', metavar='PATH', nargs='+', help="a launch file, or a package's folder")
    parser.add_argument('--json', metavar='FILE', help='write the report as JSON too')
    parser.add_argument('--junit', metavar='FILE', help='write it as JUnit XML too, as CI servers read it')
    parser.add_argument('--html', metavar='FILE', help='write it as a page too, with pictures and a replay')
    add_common(parser)
    parser.add_argument(
        '--student', metavar='NAME', default='', help='whose it is: kept in the reports, part of what chooses the runs'
    )
    parser.add_argument(
        '--advice',
        type=int,
        choices=(1, 2, 3),
        help='how much the report gives away: the kind of what is missing, the thing, how it is written '
        '(default: more with each try and each hint; 1 outside of a course); such a grading is no try',
    )
    parser.add_argument('--hint', type=int, choices=(1, 2, 3), help='print a hint of this level and end')
    return parser.parse_args(argv)


def _epilog() -> str:
    """Examples, those of plug-ins with them, and the exit codes."""
    from edulaunch.runtime import plugins

    added = (f'  {f"edugrade {verb.example}":<52} {verb.about}\n' for verb in plugins.grading_verbs().values())
    return ''.join((EXAMPLES, *added, EXIT_CODES))


def add_common(parser: argparse.ArgumentParser) -> None:
    """The options that every way of grading has."""
    parser.add_argument('--rubric', metavar='FILE|NAME', help='take this rubric; known names: ' + ', '.join(exercises()))
    parser.add_argument(
        '--seed', type=int, metavar='N', help="choose the runs' values by this number (default: by the file's content)"
    )
    parser.add_argument('--only', metavar='CHECK', help='grade this check only, with those that it needs; a batch keeps the rest')
    parser.add_argument(
        '--course-secret-file',
        metavar='FILE',
        help='choose the runs by this secret and the student, so that nobody can foresee them',
    )
    parser.add_argument(
        '--personal',
        action='store_true',
        help='the exercises were made for each student (edulaunch course copy --student) with the secret of --course-secret-file',
    )
    parser.add_argument('--limit', type=_seconds, default=30.0, metavar='SECONDS', help='real time for each run (default: 30)')
    parser.add_argument(
        '--workspace', action='append', default=[], metavar='DIR', help='a folder with your own packages (repeatable)'
    )
    parser.add_argument(
        '--sandbox',
        choices=('auto', 'require', 'off'),
        default='auto',
        help='confine runs as far as this system can (default; of a batch: require), run nothing that is not confined, '
        'or do not confine',
    )


def is_personal(options: argparse.Namespace) -> bool:
    """Whether each student has exercises of his or her own.

    :raises UnusableInput: when that is said without the secret that has chosen them.
    """
    if options.personal and not options.course_secret_file:
        raise UnusableInput('--personal needs the secret by which the exercises were made', help='--course-secret-file FILE')
    return bool(options.personal)


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 86_400:
        raise argparse.ArgumentTypeError(f'{text} is not a sensible number of seconds')
    return value

"""The words of the command line."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from edulaunch.errors import UnusableInput
from edulaunch.version import __version__

from .rubrics.catalogue import exercises

EPILOG = """\
examples:
  edugrade exercises/circle.launch.py                  grade a launch file; the rubric is found by its name
  edugrade exercises/large_project                     a package: its launch/large_project.launch.py is launched
  edugrade exercises/*.launch.py --html report.html    several at once; a page with pictures of the runs
  edugrade circle.launch.py --json report.json         write the report as data too
  edugrade my_try.launch.py --rubric circle            a file of another name
  edugrade exercises/circle.launch.py --hint 1         a hint instead of a report (levels 1 to 3)
  edugrade batch submissions/ --csv marks.csv          a class; --resume goes on where it was stopped
  edugrade verify report.json                          make a mark again, and say whether it holds
  edugrade sign report.json --key key.pem              sign a report
  edugrade similar submissions.results                 who has code in common, side by side
  edugrade export moodle submissions.results --out m.csv    marks for Moodle or Canvas
  edugrade gradescope build circle                     an autograder for Gradescope
  edugrade classroom circle                            autograding for GitHub Classroom
  edugrade course                                      whether exercises, solutions and rubrics belong together
  edugrade schema                                      the JSON schema of reports
  edugrade doctor                                      what a submission on this machine is kept from

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
        epilog=EPILOG,
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


def read_batch_options(words: Sequence[str]) -> argparse.Namespace:
    """Parse what follows ``edugrade batch``."""
    parser = argparse.ArgumentParser(
        prog='edugrade batch',
        description='Grade a class: a folder with a folder or a launch file for each student. Each result is a file of its own.',
    )
    parser.add_argument(
        'folder',
        metavar='SUBMISSIONS',
        help='a folder (or a .zip or .tar.gz of one) with a folder, an archive or a launch file for each student, such as '
        'Moodle, Gradescope and Canvas give out; or a table, .csv: student,url (of a git repository) or student,path',
    )
    parser.add_argument(
        '--name-pattern',
        metavar='REGEX',
        help="finds students' names in paths: a regular expression with a group (?P<student>...)",
    )
    parser.add_argument('--out', metavar='DIR', help='where the results go (default: SUBMISSIONS.results)')
    parser.add_argument('--resume', action='store_true', help='keep results of the same text, rubric, engine and seed')
    parser.add_argument('--jobs', type=_count, metavar='N', help='how many runs go at once (default: as many as processors)')
    parser.add_argument('--dask', metavar='ADDRESS', help='grade on a Dask cluster, such as tcp://127.0.0.1:8786')
    parser.add_argument('--csv', metavar='FILE', help='write all marks as a table too')
    parser.add_argument('--html', metavar='DIR', help='write a page for the class and one for each submission too')
    parser.add_argument('--junit', metavar='FILE', help='write all results as JUnit XML too')
    add_common(parser)
    return parser.parse_args(words)


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
        help='confine runs as far as this system can (default), run nothing that is not confined, or do not confine',
    )


def is_personal(options: argparse.Namespace) -> bool:
    """Whether each student has exercises of his or her own.

    :raises UnusableInput: when that is said without the secret that has chosen them.
    """
    if options.personal and not options.course_secret_file:
        raise UnusableInput('--personal needs the secret by which the exercises were made', help='--course-secret-file FILE')
    return bool(options.personal)


def _count(text: str) -> int:
    if not text.isdecimal() or not 0 < int(text) <= 1024:
        raise argparse.ArgumentTypeError(f'{text} is not a number from 1 to 1024')
    return int(text)


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 86_400:
        raise argparse.ArgumentTypeError(f'{text} is not a sensible number of seconds')
    return value

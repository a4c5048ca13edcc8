"""The options of `edugrade batch`."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from ...options import add_common


def read_batch_options(words: Sequence[str]) -> argparse.Namespace:
    """Parse the words after ``edugrade batch``."""
    return batch_parser().parse_args(words)


def batch_parser() -> argparse.ArgumentParser:
    """Return the parser of the words after ``edugrade batch``."""
    parser = argparse.ArgumentParser(
        prog='edugrade batch',
        description='Grade a class: a folder with a folder or a launch file for each student. Each result is a file of its own. '
        'There is no mark from a run that is not confined, unless --sandbox auto is given.',
    )
    parser.add_argument(
        'folder',
        metavar='SUBMISSIONS',
        help='a folder, .zip or .tar.gz with a folder, an archive or a launch file for each student, as Moodle, Gradescope '
        'and Canvas export it. It can also be a .csv table with the columns student,url (of a git repository) or student,path',
    )
    parser.add_argument(
        '--name-pattern',
        metavar='REGEX',
        help="find students' names in paths with this regular expression, which has a group (?P<student>...)",
    )
    parser.add_argument('--out', metavar='DIR', help='folder of the results (default: SUBMISSIONS.results)')
    parser.add_argument('--resume', action='store_true', help='keep results of the same submission, rubric, engine and seed')
    parser.add_argument('--jobs', type=_count, metavar='N', help='number of parallel runs (default: the number of processors)')
    parser.add_argument('--dask', metavar='ADDRESS', help='grade on a Dask cluster, such as tcp://127.0.0.1:8786')
    parser.add_argument('--csv', metavar='FILE', help='also write all marks as a table')
    parser.add_argument('--html', metavar='DIR', help='also write a page for the class and one for each submission')
    parser.add_argument(
        '--replays', action='store_true', help='also put replays into the pages of --html, which makes them twenty times as large'
    )
    parser.add_argument('--junit', metavar='FILE', help='also write all results as JUnit XML')
    add_common(parser)
    parser.set_defaults(sandbox='require')  # skip submissions of other students
    return parser


def _count(text: str) -> int:
    if not text.isdecimal() or not 0 < int(text) <= 1024:
        raise argparse.ArgumentTypeError(f'{text} is not a number from 1 to 1024')
    return int(text)

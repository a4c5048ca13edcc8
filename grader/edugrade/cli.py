"""The command ``edugrade``: read, run, judge, show."""

from __future__ import annotations

import argparse
import io
import os
import sys
from collections.abc import Sequence

from edulaunch.errors import UnusableInput

from .catalogue import exercises, find_rubric
from .limits import Limits
from .runner import Runner
from .submission import Submission

EPILOG = """\
examples:
  edugrade exercises/circle.launch.py                  grade a launch file; the rubric is found by its name
  edugrade circle.launch.py --json report.json         write the report as data too
  edugrade my_try.launch.py --rubric circle            a file of another name
  edugrade exercises/circle.launch.py --hint 1         a hint instead of a report (levels 1 to 3)

exit codes:
  0  all checks passed
  1  some failed or could not be run
  2  unusable input: no such file, no rubric for it, or a launch file that cannot be run at all
  3  the grader broke; that is never the student's fault and gives no mark
"""


def main(argv: Sequence[str] | None = None) -> int:
    """Grade a launch file and print the report. Returns the exit code."""
    options = _parser().parse_args(argv)
    try:
        return _hint(options) if options.hint else _grade(options)
    except UnusableInput as error:
        print(f'edugrade: {error}', file=sys.stderr)
        return 2
    except Exception as error:  # also a rubric that cannot be loaded: our fault, said in words
        print(f'edugrade: the grader broke: {type(error).__name__}: {error}', file=sys.stderr)
        return 3
    except KeyboardInterrupt:
        print('edugrade: stopped; nothing was written', file=sys.stderr)
        return 130


def _parser() -> argparse.ArgumentParser:
    parser = argparse.ArgumentParser(
        prog='edugrade',
        description='Grade a ROS 2 launch file by what it does when it is launched, in simulation.',
        epilog=EPILOG,
        formatter_class=argparse.RawDescriptionHelpFormatter,
    )
    parser.add_argument('path', metavar='PATH', help='the launch file')
    parser.add_argument('--json', metavar='FILE', help='write the report as JSON too')
    parser.add_argument(
        '--rubric', metavar='FILE|NAME', help='take this rubric; known names: ' + ', '.join(exercises())
    )
    parser.add_argument(
        '--seed',
        type=int,
        metavar='N',
        help="choose the runs' values by this number (default: by the file's content)",
    )
    parser.add_argument(
        '--limit', type=_seconds, default=30.0, metavar='SECONDS', help='real time for each run (default: 30)'
    )
    parser.add_argument(
        '--workspace',
        action='append',
        default=[],
        metavar='DIR',
        help='a folder with your own packages (repeatable)',
    )
    parser.add_argument('--hint', type=int, choices=(1, 2, 3), help='print a hint of this level and end')
    return parser


def _seconds(text: str) -> float:
    try:
        value = float(text)
    except ValueError:
        value = 0.0
    if not 0 < value < 86_400:
        raise argparse.ArgumentTypeError(f'{text} is not a sensible number of seconds')
    return value


def _hint(options: argparse.Namespace) -> int:
    from .hints import find_hint

    print(find_hint(Submission(options.path), options.hint))
    return 0


def _grade(options: argparse.Namespace) -> int:
    submission = Submission(options.path)
    name, rubric = find_rubric(submission.exercise, options.rubric)
    seed = submission.seed if options.seed is None else options.seed
    with Runner(submission, rubric.scenarios(seed), Limits(options.limit), options.workspace) as runner:
        from .judging import judge  # loaded while the runs are under way
        from .results import Report
        from .terminal import render

        outcomes = runner.wait()
    results = judge(rubric.checks, outcomes, submission.source)
    report = Report(
        submission.file,
        submission.given,
        submission.sha256,
        name,
        rubric.title,
        seed,
        tuple(outcomes),
        tuple(results),
        tuple(submission.source.gaps),
    )
    if options.json is not None:
        from .document import write_document

        write_document(report, options.json)
    _show(render(report, colour=_colour()))
    return report.exit_code


def _show(text: str) -> None:
    """Print; a reader that has seen enough (``| head``) is no fault of the grader."""
    if isinstance(sys.stdout, io.TextIOWrapper):
        sys.stdout.reconfigure(errors='backslashreplace')
    try:
        print(text, end='', flush=True)
    except BrokenPipeError:
        os.dup2(os.open(os.devnull, os.O_WRONLY), sys.stdout.fileno())


def _colour() -> bool:
    return sys.stdout.isatty() and 'NO_COLOR' not in os.environ and os.environ.get('TERM') != 'dumb'

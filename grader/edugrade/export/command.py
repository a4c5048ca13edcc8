"""``edugrade export moodle|canvas RESULTS/``: the marks of a class, as a learning platform imports them."""

from __future__ import annotations

import argparse
from collections.abc import Sequence

from edulaunch.errors import UnusableInput

from ..batch.store import Store
from ..whole_file import write_whole
from .canvas import canvas_csv
from .marks import marks_of
from .moodle import moodle_csv, moodle_worksheet


def main(words: Sequence[str]) -> int:
    """The command. Says of whom the platform's list knows nothing."""
    parser = argparse.ArgumentParser(
        prog='edugrade export',
        description='Write the marks of a batch for a learning platform. No mark stays empty: it is no zero.',
    )
    parser.add_argument('format', choices=('moodle', 'canvas'))
    parser.add_argument('results', metavar='RESULTS', help='the folder that edugrade batch has written')
    parser.add_argument('--out', metavar='FILE', required=True)
    parser.add_argument('--exercise', metavar='NAME', help='of which exercise (needed when the results have several)')
    parser.add_argument(
        '--list',
        metavar='FILE',
        help="the platform's own file, to be filled in: Moodle's offline grading worksheet, or the gradebook of Canvas",
    )
    parser.add_argument('--title', metavar='TEXT', help='what the column is called (default: the exercise)')
    options = parser.parse_args(words)
    exercise, marks = marks_of(Store(options.results).all(), options.exercise)
    title = options.title or exercise
    if options.format == 'canvas':
        if options.list is None:
            raise UnusableInput(
                'Canvas imports its own gradebook only', help='export it there (Grades, Export), and give --list FILE'
            )
        text, unknown = canvas_csv(options.list, title, marks)
    elif options.list is not None:
        text, unknown = moodle_worksheet(options.list, marks)
    else:
        text, unknown = moodle_csv(title, marks), []
    write_whole(options.out, text)
    without = sum(mark.earned is None for mark in marks)
    print(f'{len(marks) - without} marks of {exercise} for {len(marks)} students: {options.out}')
    if unknown:
        print('not in the list: ' + ', '.join(unknown))
    return 1 if unknown else 0

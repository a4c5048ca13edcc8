"""``edugrade decoys [FOLDER] [NAME ...]``: shows how many points the rubrics of a course give for names without behaviour.

FOLDER (default: the current folder) is the folder of a course, as for ``edugrade course``. The command makes decoys of each
solution, which have the names but not the behaviour of the solution, and grades them like submissions. A rubric may give a decoy
half of its points, or the share that it allows (``decoys: 0.75``). If a rubric gives more, the exit code is 1.
"""

from __future__ import annotations

import argparse
import os
from collections.abc import Iterator, Sequence
from tempfile import TemporaryDirectory
from typing import TYPE_CHECKING, NamedTuple

from edulaunch.errors import UnusableInput

from ..course import MANIFEST, Exercise, read_course
from ..evidence import Outcome
from ..grading import Work, grade, plan_work, runner_here
from ..job import Limits
from ..results import PASSED
from ..rubrics.catalogue import course_rubrics, rubrics_folder, rubrics_in
from ..submission import Submission
from .maker import KINDS, decoys

if TYPE_CHECKING:
    from edulaunch.engine.recording import Recording

SEED = 7
"""The seed of the recordings and the gradings. A decoy knows the values of the first run, like a student who has seen a
report.
"""


class Paid(NamedTuple):
    """The points that a rubric gives a decoy.

    `earned` has the value None if the grader broke. `passed` lists the passed checks with points, and `most` is the share of the
    points that the rubric allows.
    """

    exercise: str
    kind: str
    earned: float | None
    possible: int
    passed: tuple[str, ...]
    most: float = 0.5

    @property
    def share(self) -> float:
        """The share of the points that the decoy earned, from 0 to 1. Without a mark, the share is 1."""
        return 1.0 if self.earned is None else self.earned / max(1, self.possible)


def main(argv: Sequence[str]) -> int:
    """Print the points of each decoy. Return the exit code.

    :param argv: the words of the command line after `decoys`.
    """
    options = _options(argv)
    found = list(pay(options.folder, options.names, options.limit))
    too_much = [paid for paid in found if paid.share > paid.most]
    width = max((len(paid.exercise) for paid in found), default=0)
    for paid in found:
        mark = 'TOO MUCH' if paid in too_much else 'ok'
        points = 'no mark' if paid.earned is None else f'{paid.earned:g} of {paid.possible}'
        print(f'{paid.exercise:{width}}  {paid.kind:12}  {points:>8}  {mark}')
        if paid in too_much:
            print(f'{"":{width}}  paid for: {", ".join(paid.passed)}')
    print(f'{len(found)} decoys; {len(too_much)} of them get more points than their rubric allows')
    return 1 if too_much or not found else 0


def pay(folder: str, names: Sequence[str] = (), limit_s: float = 60.0, kinds: Sequence[str] = KINDS) -> Iterator[Paid]:
    """Yield the points of each decoy of a course's exercises.

    :param folder: the folder of the course.
    :param names: the names of the exercises (default: all exercises).
    :param limit_s: the limit on the real time of each run, in seconds.
    :param kinds: the kinds of decoys (default: all kinds).
    :raises UnusableInput: if the folder has no course, the course does not have an exercise, or a rubric is missing.
    """
    places = [os.path.join(folder, MANIFEST), os.path.join(folder, 'exercises', MANIFEST)]
    course = read_course(next((place for place in places if os.path.isfile(place)), places[1]))
    strange = [name for name in names if name not in {item.name for item in course}]
    if strange:
        raise UnusableInput(
            f'the course has no exercise {strange[0]}', help=f'choose one of: {", ".join(i.name for i in course)}'
        )
    rubrics = rubrics_in(course_rubrics(folder) or rubrics_folder())
    chosen = [item for item in course if not names or item.name in names]
    bare = [item.name for item in chosen if item.name not in rubrics]
    if bare:
        raise UnusableInput(f'the rubric of {bare[0]} is missing', help='type edugrade course to see which files are missing')
    works = [plan_work(Submission(_solution(folder, item)), rubrics[item.name], SEED) for item in chosen]
    limits = Limits(limit_s)
    with TemporaryDirectory(prefix='edugrade-decoys-') as place:
        allowed, made = {work.name: work.rubric.decoys for work in works}, list(_made(works, place, limits, kinds))
        for (name, kind, _), report in zip(made, grade([work for *_, work in made], limits), strict=True):
            passed = tuple(result.name for result in report.results if result.status == PASSED and result.points)
            yield Paid(name, kind, report.earned, report.possible, passed, allowed[name])


def _solution(folder: str, item: Exercise) -> str:
    return os.path.join(folder, 'solutions', item.path)


def _made(works: Sequence[Work], place: str, limits: Limits, kinds: Sequence[str]) -> Iterator[tuple[str, str, Work]]:
    """Record the first run of each solution, write the decoys, and yield (exercise, kind of decoy, work)."""
    with runner_here(limits) as runner:
        jobs = [runner.add(work.submission, work.scenarios[:1]) for work in works]
        for work, job in zip(works, jobs, strict=True):
            (outcome,) = runner.wait(job)
            for kind, path in decoys(work.submission, _recording(work, outcome), os.path.join(place, work.name)):
                if kind in kinds:
                    yield work.name, kind, plan_work(Submission(path), work.rubric.file or work.name, SEED)


def _recording(work: Work, outcome: Outcome) -> Recording:
    if outcome.recording is None:
        raise UnusableInput(f'the solution of {work.name} cannot be run: {outcome.text}', help='type edugrade course for details')
    return outcome.recording


def decoys_parser() -> argparse.ArgumentParser:
    """Return the parser of the words after ``edugrade decoys``."""
    parser = argparse.ArgumentParser(prog='edugrade decoys', description='Grade submissions that have names and no behaviour.')
    parser.add_argument('words', nargs='*', metavar='FOLDER or NAME', help='the folder of a course, and names of its exercises')
    parser.add_argument('--limit', type=float, default=60.0, metavar='SECONDS', help='longest real time of each run')
    return parser


def _options(argv: Sequence[str]) -> argparse.Namespace:
    options = decoys_parser().parse_args(argv)
    folders = [word for word in options.words if os.path.isdir(word)]
    options.folder = folders[0] if folders else '.'
    options.names = [word for word in options.words if word not in folders[:1]]
    return options

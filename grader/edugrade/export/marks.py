"""One mark for each student, from the results of a class."""

from __future__ import annotations

from collections.abc import Sequence
from typing import Any, NamedTuple

from edulaunch.errors import UnusableInput

from ..batch.tables import first_problem


class Mark(NamedTuple):
    """What a student has: points, or None for no mark, of how many, and what is said about it."""

    student: str
    id: str
    earned: float | None
    possible: int
    feedback: str


def marks_of(results: Sequence[dict[str, Any]], exercise: str | None = None) -> tuple[str, list[Mark]]:
    """The exercise and the marks in it; of several submissions of a student the best one counts.

    :param exercise: its name; may be left out when the results know one exercise only.
    :raises UnusableInput: when it is not clear which exercise is meant, or nobody handed it in.
    """
    known = sorted({result['rubric']['name'] for result in results if 'rubric' in result})
    if exercise is None and len(known) == 1:
        exercise = known[0]
    if exercise is None or exercise not in known:
        raise UnusableInput(f'the results have the exercises {", ".join(known) or "(none)"}', help='give --exercise NAME')
    possible = max(result['points']['possible'] for result in results if result.get('rubric', {}).get('name') == exercise)
    best: dict[tuple[str, str], Mark] = {}
    for result in results:
        if result.get('rubric', {}).get('name', exercise) == exercise:
            mark = _mark(result, possible)
            other = best.get((mark.student, mark.id))
            if other is None or (mark.earned is not None and (other.earned is None or mark.earned > other.earned)):
                best[mark.student, mark.id] = mark
    return exercise, list(best.values())


def _mark(result: dict[str, Any], possible: int) -> Mark:
    earned = result.get('points', {}).get('earned')
    words = first_problem(result)
    feedback = 'All checks passed.' if words is None else words if earned is not None else f'Not graded: {words}'
    return Mark(result['student'], result.get('student_id') or '', earned, possible, ' '.join(feedback.split()))

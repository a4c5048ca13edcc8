"""Has results made by a worker, and takes them from its answer."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from dataclasses import asdict
from typing import Any

from edulaunch.advice.finding import Finding

from .judging import broken
from .place import Place
from .results import CheckResult
from .worker import in_worker


def judged(judge: Callable[[], Sequence[CheckResult]]) -> list[CheckResult]:
    """What `judge` comes to in a worker; the one result that says so when the grader broke in it.

    :raises Exceeded, Lost: as `in_worker`.
    """
    return [_result(row) for row in in_worker(lambda: _rows(judge))]


def _rows(judge: Callable[[], Sequence[CheckResult]]) -> list[dict[str, Any]]:
    try:
        results = judge()
    except MemoryError:
        raise  # the worker has an answer for it
    except Exception as error:
        results = [broken(error)]
    return [asdict(result) for result in results]


def _result(row: dict[str, Any]) -> CheckResult:
    row['needs'] = tuple(row['needs'])
    row['steps'] = tuple(row['steps'])
    row['where'] = Place(*row['where']) if row['where'] else None
    row['cause'] = Finding(*row['cause']) if row['cause'] else None
    return CheckResult(**row)

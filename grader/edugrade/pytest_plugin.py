"""``pytest --edugrade``: pytest collects launch files and packages with a rubric, and each check is a test."""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path
from typing import TYPE_CHECKING, Any

import pytest

if TYPE_CHECKING:
    from .grading import Work
    from .results import CheckResult, Report


def pytest_addoption(parser: pytest.Parser) -> None:
    """Add the options of edugrade. Without ``--edugrade``, pytest collects no submissions."""
    group = parser.getgroup('edugrade')
    group.addoption('--edugrade', action='store_true', help='grade launch files: every check of their rubrics is a test')
    group.addoption(
        '--edugrade-rubric', metavar='FILE|NAME', help='use this rubric (default: the rubric with the name of the launch file)'
    )
    group.addoption('--edugrade-seed', type=int, metavar='N', help='select the values of the runs from this number')


def pytest_collect_file(file_path: Path, parent: pytest.Collector) -> GradedFile | None:
    """Return a collector for a launch file that has a rubric. Return None for other files."""
    if not parent.config.getoption('--edugrade'):
        return None
    from .rubrics.catalogue import exercises
    from .submission import ENDINGS, exercise_of

    if not file_path.name.endswith(ENDINGS):
        return None
    if parent.config.getoption('--edugrade-rubric') is None and exercise_of(file_path.name) not in exercises():
        return None
    return GradedFile.from_parent(parent, path=file_path)


class GradedFile(pytest.File):
    """A submission as a pytest collector. The first of its checks runs the submission for all of them."""

    _report: Report | None = None
    _work: Work

    def collect(self) -> Iterator[GradedCheck]:
        """Yield a test for each check. The first test states whether the launch file runs, which all other checks need."""
        from .grading import plan_work
        from .results import LAUNCHES
        from .submission import Submission

        seed = self.config.getoption('--edugrade-seed')
        self._work = plan_work(Submission(str(self.path)), self.config.getoption('--edugrade-rubric'), seed)
        for name in (LAUNCHES, *(check.name for check in self._work.rubric.checks)):
            yield GradedCheck.from_parent(self, name=name)

    def result(self, name: str) -> CheckResult:
        """Return the result of a check."""
        if self._report is None:
            from .grading import grade

            (self._report,) = grade([self._work])
        found = {result.name: result for result in self._report.results}
        return found.get(name) or self._report.results[0]  # if the grader failed, there is only one result


class GradedCheck(pytest.Item):
    """A check as a test. A check that was not run is skipped. The points are properties of the test, which JUnit files
    contain.
    """

    parent: GradedFile

    def runtest(self) -> None:
        """Grade the submission if necessary, and report the result of this check."""
        from .results import NOT_RUN, PASSED

        result = self.parent.result(self.name)
        self.user_properties += [('points', result.points), ('earned', result.earned)]
        if result.status == NOT_RUN:
            pytest.skip(result.reason)
        if result.status != PASSED:
            raise CheckFailed(result)

    def repr_failure(self, excinfo: pytest.ExceptionInfo[BaseException], style: Any = None) -> Any:
        """Return the reason and the advice of the report, without a traceback."""
        if isinstance(excinfo.value, CheckFailed):
            return str(excinfo.value)
        return super().repr_failure(excinfo, style)

    def reportinfo(self) -> tuple[Path, int | None, str]:
        """Return the place at which the student should look."""
        return self.path, None, self.name


class CheckFailed(Exception):
    """A check did not pass."""

    def __init__(self, result: CheckResult) -> None:
        from .reports.terminal import printable

        fields = {'expected': result.expected, 'seen': result.seen, 'where': result.where, 'try': result.try_}
        lines = [f'{result.sentence}: {result.reason}', *(f'  {label}: {text}' for label, text in fields.items() if text)]
        super().__init__(printable('\n'.join(lines)))

"""Grading plans the runs, makes them, and gives reports in order.

A bar on a terminal, silence elsewhere.
"""

from __future__ import annotations

import io
import sys
from pathlib import Path

import pytest
from edugrade import bare_runs, grading, judging
from edugrade.grading import grade, plan_work, progress_bar
from edugrade.reports import document as made
from edugrade.submission import Submission

import edulaunch

REPOSITORY = Path(__file__).resolve().parents[2]
STATIC, BROKEN = (REPOSITORY / 'solutions' / f'{name}.launch.py' for name in ('static_frame', 'broken_follow'))


def test_the_seed_is_that_of_the_text_unless_one_is_given() -> None:
    submission = Submission(str(STATIC))
    assert plan_work(submission).seed == submission.seed
    assert plan_work(submission, seed=5).seed == 5
    assert plan_work(submission, 'circle').name == 'circle'


@pytest.mark.processes
def test_reports_come_in_the_order_of_the_submissions_and_each_run_is_counted() -> None:
    done: list[int] = []
    work = [plan_work(Submission(str(path))) for path in (BROKEN, STATIC)]
    reports = list(grade(work, on_outcome=lambda: done.append(1)))
    assert [report.rubric for report in reports] == ['broken_follow', 'static_frame']
    assert (len(done), [report.exit_code for report in reports]) == (5, [0, 0])


@pytest.mark.processes
def test_a_graded_run_is_the_run_that_the_student_sees() -> None:
    (report,) = grade([plan_work(Submission(str(STATIC)))])
    for outcome in report.outcomes:
        scenario = outcome.scenario
        own = edulaunch.run(STATIC, arguments=scenario.arguments, duration_s=scenario.duration_s, seed=scenario.seed)
        assert outcome.recording is not None
        assert outcome.recording.digest() == own.digest()


@pytest.mark.processes
@pytest.mark.parametrize(('path', 'workers'), [(STATIC, 1), (REPOSITORY / 'solutions' / 'circle.launch.py', 1)])
def test_one_worker_reads_the_recordings_of_a_submission(path: Path, workers: int, monkeypatch: pytest.MonkeyPatch) -> None:
    asked: list[object] = []
    in_worker = grading.in_worker
    for module in (grading, bare_runs, judging, made):
        monkeypatch.setattr(module, 'in_worker', lambda work: asked.append(work) or in_worker(work))
    (report,) = grade([plan_work(Submission(str(path)))], for_documents=True)
    document = made.document(report)
    assert len(asked) == workers and report.earned == 12
    assert [row['digest'] for row in document['scenarios']] == [made.digest_of(outcome) for outcome in report.outcomes]


class Terminal(io.StringIO):
    def isatty(self) -> bool:
        return True


def test_without_a_terminal_nothing_is_shown(capsys: pytest.CaptureFixture[str]) -> None:
    with progress_bar(3) as advance:
        advance()
    assert capsys.readouterr() == ('', '')


def test_on_a_terminal_runs_are_counted(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(sys, 'stderr', Terminal())
    with progress_bar(2) as advance:
        advance()
        advance()
    said = sys.stderr.getvalue().split('\r\x1b[K')
    assert [line.rpartition(' ')[2] for line in said] == ['', '0/2', '1/2', '2/2', ''], 'at the end nothing is left of it'


@pytest.mark.processes
def test_what_cannot_be_read_any_more_has_no_mark(tmp_path: Path) -> None:
    """Somebody else took it away while it was graded: a zero would be the student's."""
    path = tmp_path / 'circle.launch.py'
    path.write_text('nothing\n')
    work = plan_work(Submission(str(path)))
    path.unlink()
    (report,) = grade([work])
    assert (report.exit_code, report.earned) == (3, None)
    assert 'could be read before the runs' in report.results[0].reason

"""A report with one check of every kind, made by hand."""

from __future__ import annotations

from edugrade import Scenario
from edugrade.evidence import Outcome
from edugrade.results import CheckResult, Report
from edugrade.source import Gap, Place

FILE = '/home/student/work/a.launch.py'
PASSED = CheckResult('starts', 'It starts', 'passed', 2)
FAILED = CheckResult(
    'drives',
    'It drives',
    'failed',
    3,
    ('starts',),
    'the robot stands',
    'a circle',
    'no movement',
    Place(FILE, 12),
    f'look at {FILE}:12',
)
NOT_RUN = CheckResult('arrives', 'It arrives', 'not_run', 4, ('drives',), 'because "It drives" failed', root_cause='drives')
BROKE = CheckResult('counts', 'It counts', 'grader_broke', 1, (), 'the check itself broke: KeyError: 1')
RECORDED = Outcome(Scenario('fast', {'speed': '2.0'}), 'recorded')


def report(
    *results: CheckResult, outcome: Outcome = RECORDED, gaps: tuple[Gap, ...] = (), given: str = 'work/a.launch.py'
) -> Report:
    """A report of these results on FILE, as if graded from the folder above it."""
    return Report(FILE, given, FILE.rpartition('/')[0], 'work/', None, 'f00d', 'a', 'A robot', 7, (outcome,), results, gaps)

"""The golden reports: one folder for each submission, with the exact reports it must get.

After a wanted change, write them anew with ``python tests/grader/golden_reports.py`` in a set-up environment, and read the
difference.
"""

from __future__ import annotations

import os
from pathlib import Path
from typing import Any

from edugrade.grading import Work, grade, plan_work
from edugrade.job import Limits
from edugrade.reports.document import document, json_text
from edugrade.reports.terminal import render
from edugrade.submission import Submission

FOLDER = Path(__file__).parent / 'golden'
CASES = sorted(path.name for path in FOLDER.iterdir())


def grade_all() -> dict[str, tuple[str, str]]:
    """For each case, the terminal's text with the exit code as its last line, and the JSON text."""
    reports = grade([_work(case) for case in CASES], Limits(60.0, sandbox='off'))
    return {
        case: (f'{render(report)}exit code {report.exit_code}\n', json_text(_steady(document(report))))
        for case, report in zip(CASES, reports, strict=True)
    }


def _steady(found: dict[str, Any]) -> dict[str, Any]:
    """A report without what changes with every version of the engine and every word of a rubric, and the launch graph."""
    scenarios = [{**scenario, 'digest': bool(scenario['digest'])} for scenario in found['scenarios']]
    return {**{key: value for key, value in found.items() if key not in ('receipt', 'graph')}, 'scenarios': scenarios}


def _work(case: str) -> Work:
    """The submission as it is named by somebody who stands in its folder."""
    before = os.getcwd()
    os.chdir(FOLDER / case)
    try:
        work = plan_work(Submission('circle.launch.py'))
        assert work.submission.shown_folder == ''
        return work
    finally:
        os.chdir(before)


if __name__ == '__main__':
    for name, (text, data) in grade_all().items():
        (FOLDER / name / 'report.txt').write_text(text, encoding='utf-8')
        (FOLDER / name / 'report.json').write_text(data, encoding='utf-8')
        print(name)

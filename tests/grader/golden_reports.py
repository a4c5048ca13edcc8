"""The golden reports: one folder for each submission, with the exact reports it must get.

After a wanted change, write them anew with ``python tests/grader/golden_reports.py`` and read the difference.
"""

from __future__ import annotations

import contextlib
import io
import os
import sys
from pathlib import Path

FOLDER = Path(__file__).parent / 'golden'
CASES = sorted(path.name for path in FOLDER.iterdir())


def grade(case: str, json_file: Path) -> tuple[str, str]:
    """The terminal's text, with the exit code as its last line, and the JSON text of a submission."""
    from edugrade.cli import main

    before = os.getcwd()
    os.chdir(FOLDER / case)
    try:
        with contextlib.redirect_stdout(io.StringIO()) as text, contextlib.redirect_stderr(text):
            limit = '2' if case == 'endless_loop' else '20'
            code = main(['circle.launch.py', '--json', str(json_file), '--limit', limit])
    finally:
        os.chdir(before)
    return f'{text.getvalue()}exit code {code}\n', json_file.read_text(encoding='utf-8')


if __name__ == '__main__':
    repository = Path(__file__).resolve().parents[2]
    sys.path[:0] = [str(repository / 'grader'), str(repository)]
    for name in CASES:
        report, data = grade(name, FOLDER / name / 'report.json')
        (FOLDER / name / 'report.txt').write_text(report, encoding='utf-8')
        print(name)

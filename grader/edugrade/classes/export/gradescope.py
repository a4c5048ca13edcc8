"""Gradescope: ``edugrade gradescope build`` packs an autograder, which runs ``edugrade gradescope run``.

Formats: gradescope-autograders.readthedocs.io, "Autograder Specifications" (``results.json``) and "Submission Metadata".
"""

from __future__ import annotations

import argparse
import io
import json
import os
import sys
import tempfile
import zipfile
from collections.abc import Sequence
from dataclasses import replace
from typing import Any

from edulaunch.errors import UnusableInput
from edulaunch.runtime.version import __version__

from ...files import read_given, read_regular, write_whole
from ...grading import grade, plan_work
from ...job import Limits
from ...reports.document import document, explanation, json_text
from ...reports.terminal import printable, sandbox_line
from ...reports.wording import at_level, level_of
from ...results import BROKEN_GRADER, GRADER_BROKE, PASSED
from ...rubrics.catalogue import find_rubric
from ...submission import Submission, exercise_of
from ...variant import CourseSecret
from ..batch.entries import Finder

LARGEST_WHEEL = 200_000_000
LONGEST_OUTPUT = 8000
SETUP = """#!/usr/bin/env bash
# Made by edugrade gradescope build. Runs once, when Gradescope builds the image.
set -euo pipefail
apt-get update && apt-get install -y python3 python3-venv
python3 -m venv /opt/edugrade
/opt/edugrade/bin/pip install {wheel}
"""
RUN = """#!/usr/bin/env bash
# Made by edugrade gradescope build. Runs for each submission.
set -euo pipefail
PATH="/opt/edugrade/bin:$PATH" exec edugrade gradescope run "${AUTOGRADER:-/autograder}"
"""


def gradescope_parser() -> argparse.ArgumentParser:
    """Return the parser of the words after ``edugrade gradescope``."""
    parser = argparse.ArgumentParser(prog='edugrade gradescope', description='Grade on Gradescope.')
    verbs = parser.add_subparsers(dest='verb', required=True)
    build_ = verbs.add_parser('build', help='pack an autograder for one exercise')
    build_.add_argument('exercise', help='the name of an exercise, or the file of a rubric')
    build_.add_argument('--out', metavar='FILE', default='autograder.zip')
    build_.add_argument(
        '--wheel', metavar='FILE', help='install this wheel of edulaunch there (default: this version, from PyPI)'
    )
    build_.add_argument(
        '--course-secret-file',
        metavar='FILE',
        help='select the runs from this secret and the student; the archive contains the secret',
    )
    build_.add_argument('--limit', type=float, default=30.0, metavar='SECONDS', help='real time for each run (default: 30)')
    run_ = verbs.add_parser('run', help='grade the submission in this folder, as Gradescope lays it out')
    run_.add_argument('folder', nargs='?', default='/autograder')
    return parser


def main(words: Sequence[str]) -> int:
    """Run the command, and return its exit code."""
    options = gradescope_parser().parse_args(words)
    if options.verb == 'run':
        return run(options.folder)
    build(options.exercise, options.out, options.wheel, options.course_secret_file, options.limit)
    print(f'{options.out}: upload it under "Configure Autograder" of the assignment')
    if options.wheel is None:
        print(
            f'edugrade: Gradescope installs edulaunch {__version__} from PyPI. If this version is not published there, '
            'use --wheel FILE.',
            file=sys.stderr,
        )
    return 0


def build(exercise: str, out: str, wheel: str | None = None, secret: str | None = None, limit_s: float = 30.0) -> None:
    """Write the zip file for Gradescope with setup.sh, run_autograder and the files that they need. Equal input gives equal
    bytes.

    :raises UnusableInput: when there is no such rubric, wheel or secret.
    """
    name, rubric = find_rubric(exercise, exercise)
    rubric.scenarios(0)  # this finds a mistake in the rubric now
    source = 'edulaunch==' + __version__ if wheel is None else f'/autograder/source/{os.path.basename(wheel)}'
    rubric_file = f'rubrics/{name}{os.path.splitext(rubric.file)[1]}'
    config = {'exercise': name, 'rubric': rubric_file, 'limit_s': limit_s, 'edulaunch': __version__}
    files = {'setup.sh': SETUP.format(wheel=source).encode(), 'run_autograder': RUN.encode(), rubric_file: rubric.text}
    if wheel is not None:
        files[os.path.basename(wheel)] = read_given(wheel, LARGEST_WHEEL)
    if secret is not None:
        CourseSecret(secret)
        config['secret'] = 'course_secret'
        files['course_secret'] = read_given(secret, LARGEST_WHEEL)
    files['edugrade.json'] = json_text(config).encode()
    packed = io.BytesIO()
    with zipfile.ZipFile(packed, 'w', zipfile.ZIP_DEFLATED) as archive:
        for path, data in files.items():
            info = zipfile.ZipInfo(path)
            info.external_attr = (0o755 if path in ('setup.sh', 'run_autograder') else 0o600) << 16
            archive.writestr(info, data)
    write_whole(out, packed.getvalue())


def run(folder: str) -> int:
    """Grade ``submission/`` with the rubric in ``source/``, and write ``results/results.json``.

    If the grader fails, write nothing, and return the exit code 3. Gradescope then reports a failed autograder without a
    mark.
    """
    source = os.path.join(folder, 'source')
    config = json.loads(read_given(os.path.join(source, 'edugrade.json'), LARGEST_WHEEL))
    rubric = os.path.join(source, config['rubric'])
    secret = CourseSecret(os.path.join(source, config['secret'])) if 'secret' in config else None
    student, name, tries = _student(folder)
    os.makedirs(os.path.join(folder, 'results'), exist_ok=True)
    with tempfile.TemporaryDirectory(prefix='edugrade-unpacked-', ignore_cleanup_errors=True) as unpacked:
        try:
            submission = Submission(_find(os.path.join(folder, 'submission'), os.path.join(unpacked, 'all'), config['exercise']))
            work = plan_work(submission, rubric, None, secret, student)
        except UnusableInput as error:
            possible = sum(check.points for check in find_rubric('', rubric)[1].checks)
            found = refused(f'{error.message}\n{error.help or ""}', possible)
        else:
            (report,) = grade([work], Limits(config['limit_s']))
            shown = tuple(at_level(result, level_of(tries, [], False)) for result in report.results)
            report = replace(report, student=name, results=shown)
            if report.exit_code == BROKEN_GRADER:
                broken = next(result for result in report.results if result.status == GRADER_BROKE)
                raise RuntimeError(f'{broken.sentence}: {broken.reason}')
            found = results(document(report), sandbox_line([report]))
    write_whole(os.path.join(folder, 'results', 'results.json'), json_text(found))
    return 0


def results(found: dict[str, Any], note: str = '') -> dict[str, Any]:
    """Return a JSON report in the form of Gradescope's ``results.json``, with a test and the points for each check."""
    return {
        'score': found['points']['earned'],
        'output': f'{found["rubric"]["title"]}: {found["verdict"]}. Seed {found["seed"]}. {note}'.strip(),
        'output_format': 'text',
        'test_output_format': 'text',
        'test_name_format': 'text',
        'visibility': 'visible',
        'stdout_visibility': 'hidden',
        'tests': [_test(check) for check in found['checks']],
        'extra_data': {'edugrade': {key: found[key] for key in ('receipt', 'verdict')}},
    }


def refused(reason: str, possible: int) -> dict[str, Any]:
    """Return the results of a submission that cannot be graded, for a reason in the submission."""
    test = {
        'name': 'It can be graded',
        'score': 0,
        'max_score': possible,
        'status': 'failed',
        'output': printable(reason).strip(),
    }
    return {'score': 0, 'output': printable(reason).strip(), 'output_format': 'text', 'visibility': 'visible', 'tests': [test]}


def _test(check: dict[str, Any]) -> dict[str, Any]:
    return {
        'name': printable(check['sentence']),
        'score': check['earned'],
        'max_score': check['points'],
        'status': 'passed' if check['status'] == PASSED else 'failed',
        'output': printable('\n'.join([check['reason'] or '', *explanation(check)])).strip()[:LONGEST_OUTPUT],
        'tags': [check['status']],
    }


def _student(folder: str) -> tuple[str, str, int]:
    """Return the numbers and names of the submitting students and the attempt, from Gradescope's metadata. Unknown values are
    ''.
    """
    try:
        found = json.loads(read_regular(os.path.join(folder, 'submission_metadata.json'), LARGEST_WHEEL))
        known = sorted((str(user['id']), str(user.get('name', ''))) for user in found['users'])
        tries = len(found.get('previous_submissions') or ()) + 1
    except (OSError, ValueError, KeyError, TypeError, AttributeError):
        return '', '', 1
    return ','.join(number for number, _ in known), ' and '.join(name for _, name in known), tries


def _find(folder: str, unpacked: str, exercise: str) -> str:
    """Return the launch file or package of the exercise, anywhere in the submission."""
    entries = Finder(folder, unpacked, lambda name: exercise_of(name) == exercise).entries()
    found = next((entry.file for entry in entries if entry.file), None)
    if found is None:
        reason = next((entry.refused for entry in entries if entry.path.count('.')), '')
        raise UnusableInput(f'there is no {exercise}.launch.py in the submission' + (f': {reason}' if reason else ''))
    return found

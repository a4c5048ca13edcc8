"""GitHub Classroom: ``edugrade classroom EXERCISE...`` writes the autograding files for an assignment's template repository.

Formats: github.com/education/autograding (``.github/classroom/autograding.json``) and github.com/classroom-resources
(``autograding-command-grader``, ``autograding-grading-reporter``), one test for each check that has points.
"""

from __future__ import annotations

import argparse
import json
import os
import shlex
from collections.abc import Sequence
from typing import NamedTuple

import yaml

from edulaunch.errors import UnusableInput
from edulaunch.runtime.version import __version__

from ...course import find_course, read_course
from ...files import write_whole
from ...rubrics.catalogue import find_rubric

MINUTES = 2


class Test(NamedTuple):
    """A command with exit code 0 if a check passes, and the points of the check."""

    id: str
    name: str
    command: str
    points: int


def classroom_parser() -> argparse.ArgumentParser:
    """Return the parser of the words after ``edugrade classroom``."""
    parser = argparse.ArgumentParser(
        prog='edugrade classroom', description='Write the autograding of a GitHub Classroom assignment.'
    )
    parser.add_argument(
        'exercises', metavar='EXERCISE', nargs='+', help='the name of an exercise, or NAME=PATH in the repository'
    )
    parser.add_argument(
        '--out', metavar='DIR', default='.', help="the assignment's template repository (default: the current folder)"
    )
    parser.add_argument(
        '--install',
        metavar='COMMAND',
        default=f'pip install edulaunch=={__version__}',
        help='installs edulaunch (default: %(default)s). edulaunch is not on PyPI yet: name a wheel or a repository',
    )
    return parser


def main(words: Sequence[str]) -> int:
    """Run the command, and return its exit code."""
    options = classroom_parser().parse_args(words)
    found = [test for exercise in options.exercises for test in tests(exercise)]
    files = {
        'workflows/classroom.yml': workflow(found, options.install),
        'classroom/autograding.json': autograding(found, options.install),
    }
    for name, text in files.items():
        path = os.path.join(options.out, '.github', name)
        try:
            os.makedirs(os.path.dirname(path), exist_ok=True)
        except OSError as error:
            raise UnusableInput(f'{path} cannot be written: {error.strerror}') from None
        write_whole(path, text)
        print(path)
    return 0


def tests(exercise: str) -> list[Test]:
    """Return the tests of an exercise: a command for each check that has points.

    :raises UnusableInput: when there is no such exercise.
    """
    name, _, path = exercise.partition('=')
    rubric = find_rubric(name, name)[1]
    if not path:
        known = {entry.name: entry.path for entry in read_course(find_course(os.getcwd()))}
        path = known.get(name, f'{name}.launch.py')
    return [
        Test(
            f'{name}-{check.name}',
            f'{name}: {check.sentence}',
            shlex.join(['edugrade', path, '--only', check.name]),
            check.points,
        )
        for check in rubric.checks
        if check.points
    ]


def workflow(found: Sequence[Test], install: str) -> str:
    """Return the content of ``.github/workflows/classroom.yml``, which GitHub Classroom runs today."""
    steps: list[dict[str, object]] = [
        {'name': 'Checkout code', 'uses': 'actions/checkout@v4'},
        {'uses': 'actions/setup-python@v5', 'with': {'python-version': '3.12'}},
        {'name': 'edulaunch', 'run': install},
    ]
    for test in found:
        settings = {
            'test-name': test.name,
            'setup-command': '',
            'command': test.command,
            'timeout': MINUTES,
            'max-score': test.points,
        }
        steps.append(
            {'name': test.name, 'id': test.id, 'uses': 'classroom-resources/autograding-command-grader@v1', 'with': settings}
        )
    results = {f'{test.id.upper()}_RESULTS': f'${{{{steps.{test.id}.outputs.result}}}}' for test in found}
    reporter = 'classroom-resources/autograding-grading-reporter@v1'
    steps.append({'name': 'Report', 'uses': reporter, 'env': results, 'with': {'runners': ','.join(test.id for test in found)}})
    job = {'runs-on': 'ubuntu-latest', 'if': "github.actor != 'github-classroom[bot]'", 'steps': steps}
    content = {
        'name': 'Autograding Tests',
        'on': ['push', 'repository_dispatch'],
        'permissions': {'checks': 'write', 'actions': 'read', 'contents': 'read'},
        'jobs': {'run-autograding-tests': job},
    }
    return yaml.safe_dump(content, sort_keys=False, allow_unicode=True, width=120)


def autograding(found: Sequence[Test], install: str) -> str:
    """Return the content of ``.github/classroom/autograding.json``, the older form, which other tools still read."""
    tests = [
        {
            'name': test.name,
            'setup': install if number == 0 else '',
            'run': test.command,
            'input': '',
            'output': '',
            'comparison': 'included',
            'timeout': MINUTES,
            'points': test.points,
        }
        for number, test in enumerate(found)
    ]
    return json.dumps({'tests': tests}, indent=2, ensure_ascii=False) + '\n'

"""`edulaunch course template classroom|gradescope` writes the files that these platforms need to grade the exercises of a
course.
"""

from __future__ import annotations

import os
import tempfile
from collections.abc import Sequence
from pathlib import Path

REQUIREMENTS = 'requirements.txt'


def classroom(requirements: str, exercises: Sequence[tuple[str, str]]) -> dict[str, bytes]:
    """Return the files of GitHub Classroom, with a command for each check of each exercise.

    :param requirements: the content of requirements.txt, for a course without such a file.
    :param exercises: the name of each exercise, and its path relative to the current folder, which is the course.
    """
    from .classroom import autograding, tests, workflow

    found = [test for name, path in exercises for test in tests(f'{name}={path}')]
    install = f'pip install -r {REQUIREMENTS}'
    files = {
        '.github/workflows/classroom.yml': workflow(found, install).encode(),
        '.github/classroom/autograding.json': autograding(found, install).encode(),
    }
    return files if os.path.exists(REQUIREMENTS) else {REQUIREMENTS: requirements.encode(), **files}


def gradescope(requirements: str, exercises: Sequence[tuple[str, str]]) -> dict[str, bytes]:
    """Return the files of an autograder for each exercise; :func:`classroom` explains the parameters."""
    from .gradescope import build

    files = {}
    with tempfile.TemporaryDirectory() as folder:
        for name, _ in exercises:
            path = os.path.join(folder, f'{name}.zip')
            build(name, path)
            files[f'gradescope/{name}.zip'] = Path(path).read_bytes()
    return files

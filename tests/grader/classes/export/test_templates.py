"""The templates of a course whose files are made of its exercises: what graders call there is run."""

from __future__ import annotations

import json
import shutil
import subprocess
from pathlib import Path
from zipfile import ZipFile

import pytest

from edulaunch.course.copying import new_course
from edulaunch.course.templates import write_template
from tests.course.test_templates import run


@pytest.fixture
def course(tmp_path: Path) -> Path:
    folder = tmp_path / 'My course 1'
    new_course(str(folder))
    for name in ('classroom', 'gradescope'):
        write_template(name, str(folder))
    return folder


@pytest.mark.whole
def test_the_classroom_commands_tell_solution_from_stub(course: Path) -> None:
    tests = json.loads((course / '.github' / 'classroom' / 'autograding.json').read_text())['tests']
    assert sum(test['points'] for test in tests) == 6
    assert tests[0]['setup'] == 'pip install -r requirements.txt' and (course / 'requirements.txt').is_file()
    commands = ' && '.join(test['run'] for test in tests)
    assert run(commands, course).returncode == 1
    shutil.copy(course / 'solutions' / 'spin.launch.py', course / 'exercises')
    shutil.rmtree(course / 'solutions')
    assert run(commands, course).returncode == 0


def test_gradescope_grades_what_is_handed_in(course: Path, tmp_path: Path) -> None:
    place = tmp_path / 'autograder'
    with ZipFile(course / 'gradescope' / 'spin.zip') as packed:
        packed.extractall(place / 'source')
    (place / 'submission').mkdir()
    (place / 'submission_metadata.json').write_text('{"users": [{"id": 7, "name": "Anna"}]}')
    shutil.copy(course / 'solutions' / 'spin.launch.py', place / 'submission')
    script = place / 'run_autograder'
    shutil.copy(place / 'source' / 'run_autograder', script)  # there it stands beside the folders
    assert subprocess.run(['sh', '-n', str(place / 'source' / 'setup.sh')]).returncode == 0
    done = run(f'bash {script}', tmp_path, AUTOGRADER=str(place))
    assert done.returncode == 0, done.stdout + done.stderr
    assert json.loads((place / 'results' / 'results.json').read_text())['score'] == 6

"""The templates: each file is read as its platform reads it, and what graders call there is run."""

from __future__ import annotations

import json
import os
import re
import shutil
import subprocess
import sys
from pathlib import Path

import pytest
import yaml

from edulaunch.course.copying import new_course
from edulaunch.course.templates import FOLDER, NEXT, write_template
from edulaunch.errors import UnusableInput
from edulaunch.runtime import plugins

ROOT = Path(__file__).resolve().parents[2]
SHELL = ('postBuild', 'setup.sh', 'run_autograder')
DEVCONTAINER = {
    'name': str,
    'build': dict,
    'remoteUser': str,
    'remoteEnv': dict,
    'postCreateCommand': str,
    'forwardPorts': list,
    'portsAttributes': dict,
    'customizations': dict,
}
"""What a devcontainer.json may have, as containers.dev has it."""


@pytest.fixture
def course(tmp_path: Path) -> Path:
    """A course of one's own, with all templates."""
    folder = tmp_path / 'My course 1'
    new_course(str(folder))
    for name in NEXT:
        if plugins.template(name) is not None or plugins.absent(f'edulaunch course template {name}') is None:
            write_template(name, str(folder))
    return folder


def run(command: str, folder: Path, **env: str) -> subprocess.CompletedProcess[str]:
    """A command line in a folder, with this environment's commands first on the path."""
    path = os.pathsep.join([os.path.dirname(sys.executable), os.environ['PATH']])
    surroundings = {**os.environ, 'PATH': path, 'PYTHONPATH': os.pathsep.join([str(ROOT), str(ROOT / 'grader')]), **env}
    return subprocess.run(
        ['bash', '-e', '-c', command], cwd=folder, env=surroundings, capture_output=True, text=True, encoding='utf-8', timeout=300
    )


def test_every_template_has_files_and_says_what_to_do() -> None:
    assert set(os.listdir(FOLDER)) | {'classroom', 'gradescope', 'vscode'} == set(NEXT)


def test_every_file_is_of_its_form_and_names_the_course(course: Path) -> None:
    for path in sorted(course.rglob('*')):
        if path.suffix in ('.yml', '.yaml'):
            assert yaml.safe_load(path.read_text(encoding='utf-8'))
        elif path.suffix == '.json':
            assert json.loads(path.read_text(encoding='utf-8'))
        elif path.name in SHELL:
            assert subprocess.run(['sh', '-n', str(path)]).returncode == 0 and os.access(path, os.X_OK)
        elif path.suffix == '.py':
            compile(path.read_text(encoding='utf-8'), str(path), 'exec')
        if path.is_file() and path.suffix != '.zip':
            assert not re.search(r'@[A-Z]+@', path.read_text(encoding='utf-8')), path
    assert json.loads((course / '.devcontainer' / 'devcontainer.json').read_text())['name'] == 'my-course-1'
    assert "image = 'my-course-1-hub'" in (course / 'jupyterhub' / 'jupyterhub_config.py').read_text()
    assert (course / 'requirements.txt').read_text() == (course / 'binder' / 'requirements.txt').read_text()


def test_the_devcontainer_has_what_the_format_knows(course: Path) -> None:
    found = json.loads((course / '.devcontainer' / 'devcontainer.json').read_text())
    assert {key: type(value) for key, value in found.items()} == {key: DEVCONTAINER[key] for key in found}
    assert (course / '.devcontainer' / found['build']['dockerfile']).is_file()


def test_dockerfiles_have_known_instructions_and_copy_what_is_there(course: Path) -> None:
    for path in (course / 'Dockerfile', course / '.devcontainer' / 'Dockerfile'):
        lines = [line for line in path.read_text().splitlines() if line and not line.startswith('#')]
        assert lines[0].startswith('FROM python:3.12')
        assert {line.split()[0] for line in lines} <= {'FROM', 'ARG', 'RUN', 'COPY', 'USER', 'WORKDIR', 'EXPOSE', 'CMD'}
    ignored = (course / '.dockerignore').read_text().split('\n')
    assert 'solutions' in ignored and 'requirements.txt' not in ignored


def test_the_spawner_is_configured_for_the_image(course: Path) -> None:
    class Options(dict):  # type: ignore[type-arg]
        __getattr__ = dict.__getitem__
        __setattr__ = dict.__setitem__  # type: ignore[assignment]

    config = Options(JupyterHub=Options(), DockerSpawner=Options())
    exec((course / 'jupyterhub' / 'jupyterhub_config.py').read_text(), {'get_config': lambda: config})
    assert config.DockerSpawner['notebook_dir'] in (course / 'Dockerfile').read_text()
    assert '{username}' in next(iter(config.DockerSpawner['volumes']))


@pytest.mark.whole
def test_the_steps_of_the_workflow_do_what_they_say(course: Path, tmp_path: Path) -> None:
    job = yaml.safe_load((course / '.github' / 'workflows' / 'course.yml').read_text())['jobs']['course']
    steps = {step['name']: step['run'] for step in job['steps'] if 'run' in step}
    assert list(steps) == ['Install', *[name for name in steps if name != 'Install']]
    for student, origin in (('anna', 'solutions'), ('ben', 'exercises')):
        (course / 'submissions' / student).mkdir(parents=True)
        shutil.copy(course / origin / 'spin.launch.py', course / 'submissions' / student)
    done = run(steps['Lessons, exercises, solutions and rubrics belong together'], course)
    assert done.returncode == 0, done.stdout + done.stderr
    done = run(steps['Submissions'], course, GITHUB_STEP_SUMMARY=str(tmp_path / 'summary.md'))
    assert done.returncode == 0, done.stdout + done.stderr
    summary = (tmp_path / 'summary.md').read_text()
    assert re.search(r'^anna,.*\b6\b', summary, re.M) and re.search(r'^ben,', summary, re.M)
    assert (course / 'marks.xml').read_text().startswith('<?xml') and (course / 'pages').is_dir()


def test_what_is_there_already_stays(course: Path) -> None:
    assert write_template('docker', str(course)) == ['.dockerignore', 'Dockerfile']  # the same once more
    (course / 'Dockerfile').write_text('FROM scratch\n')
    with pytest.raises(UnusableInput, match='already exists with other content'):
        write_template('jupyterhub', str(course))
    assert (course / 'Dockerfile').read_text() == 'FROM scratch\n'
    with pytest.raises(UnusableInput, match='no template'):
        write_template('nothub', str(course))
    with pytest.raises(UnusableInput, match='no course'):
        write_template('docker', str(course / 'lessons'))

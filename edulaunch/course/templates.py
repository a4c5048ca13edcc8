"""`edulaunch course template`: write the files with which a platform opens, checks or grades a course."""

from __future__ import annotations

import os
import re
from collections.abc import Iterator
from contextlib import contextmanager
from pathlib import Path

from edugrade.course import read_course
from edugrade.files import files_below

from edulaunch.engine.nearest import did_you_mean
from edulaunch.errors import UnusableInput
from edulaunch.runtime import plugins
from edulaunch.runtime.version import __version__

from .copying import write_file
from .lessons import EXERCISES, given_course, manifest

FOLDER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'template')
REQUIREMENTS = 'requirements.txt'
EXECUTABLE = ('postBuild',)
NEXT = {
    'github': 'push it to GitHub: each push checks the course and grades the files in submissions/',
    'classroom': 'give it to an assignment as its template repository; with rubrics (release --with-rubrics), without solutions',
    'gradescope': 'upload a zip file under "Configure Autograder" of its assignment',
    'devcontainer': 'push the output of `edulaunch course release` with these files; on GitHub, "Code", "Codespaces" opens it',
    'binder': 'push the output of `edulaunch course release` with these files, and enter the address of the repository at Binder',
    'docker': 'build and run it as described at the top of Dockerfile',
    'vscode': 'open the course in VS Code, and install the extension that it suggests, which helps to write launch files',
    'jupyterhub': 'build and run it as described at the top of jupyterhub/jupyterhub_config.py',
}
"""The next step for each template."""
WITH = {'jupyterhub': ('docker',)}
"""The templates on which another template builds."""


def write_template(name: str, course: str) -> list[str]:
    """Write the files of a template to a course. Return their paths relative to the course, including a new requirements.txt.

    :raises UnusableInput: for an unknown template or course, or when a file exists with other content; then nothing
        is written.
    """
    if name not in NEXT:
        raise UnusableInput(
            f'there is no template {name!r}', help=did_you_mean(name, NEXT) or 'choose one of: ' + ', '.join(NEXT)
        )
    given_course(course)
    files = {name: text for part in (*WITH.get(name, ()), name) for name, text in _files(part, course).items()}
    for path, data in files.items():
        there = os.path.join(course, path)
        if os.path.exists(there) and Path(there).read_bytes() != data:
            raise UnusableInput(f'{there} already exists with other content', help='move it away; nothing was written')
    for path, data in files.items():
        write_file(course, path, data)
        if os.path.basename(path) in EXECUTABLE:
            os.chmod(os.path.join(course, path), 0o755)
    return sorted(files)


def _files(name: str, course: str) -> dict[str, bytes]:
    requirements = _requirements(course)
    made = plugins.template(name)
    if made is not None:
        with _inside(course):
            files: dict[str, bytes] = made(requirements, _exercises())
        return files
    if (missing := plugins.absent(f'edulaunch course template {name}')) is not None:
        raise missing
    found = {} if os.path.exists(os.path.join(course, REQUIREMENTS)) else {REQUIREMENTS: requirements.encode()}
    folder = os.path.join(FOLDER, name)
    title = re.sub(r'[^a-z0-9]+', '-', os.path.basename(os.path.abspath(course)).lower()).strip('-') or 'course'
    for path in files_below(folder, lambda name, inside: not name.endswith('.pyc')):
        text = Path(folder, path).read_text('utf-8')
        found[path] = text.replace('@COURSE@', title).replace('@REQUIREMENTS@\n', requirements).encode()
    return found


def _exercises() -> list[tuple[str, str]]:
    """Return the name and the path of each exercise of the course in the current folder."""
    place = manifest('.')
    return [(entry.name, f'{EXERCISES}/{entry.path}') for entry in (read_course(place) if place else ())]


def _requirements(course: str) -> str:
    """Return the requirements of the course. If it has none, return this version of edulaunch with the notebook extra."""
    path = os.path.join(course, REQUIREMENTS)
    return Path(path).read_text('utf-8') if os.path.exists(path) else f'edulaunch[notebook]=={__version__}\n'


@contextmanager
def _inside(folder: str) -> Iterator[None]:
    before = os.getcwd()
    os.chdir(folder)
    try:
        yield
    finally:
        os.chdir(before)

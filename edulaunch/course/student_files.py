"""What students get of a course: lessons without outputs, exercises, questions; no solution, no rubric, no kept output."""

from __future__ import annotations

import json
import os
from collections.abc import Iterator

from edugrade.course import MANIFEST

from edulaunch.errors import UnusableInput

from .notes import FOLDER as NOTES
from .place import EXERCISES, LESSONS
from .stored import as_text, without_outputs

RUBRICS = 'rubrics'
KEPT_BACK = ('solutions', RUBRICS, '__pycache__', 'my_progress.toml', 'my_progress.toml.bak')
"""Never handed out, in whatever folder."""
BESIDE = (MANIFEST, 'README.md', 'LICENSE', 'requirements.txt')
"""Files beside the folders of a course, handed out where the course is a folder of its own (with its manifest in it)."""


def student_files(course: str, *, rubrics: bool = False) -> dict[str, bytes]:
    """The files that students get, by their path in the course with slashes, in alphabetical order.

    :param rubrics: also the rubrics, so that students can check what they wrote.
    :raises UnusableInput: when a notebook cannot be read, or a file is a link (which may lead to a solution).
    """
    found: dict[str, bytes] = {}
    for name in (*BESIDE, LESSONS, EXERCISES, *([RUBRICS] if rubrics else [])):
        path = os.path.join(course, name)
        if os.path.isdir(path):
            found |= {
                f'{name}/{inner}': _content(os.path.join(path, *inner.split('/'))) for inner in _files(path, name == LESSONS)
            }
        elif os.path.isfile(path) and os.path.isfile(os.path.join(course, MANIFEST)):
            found[name] = _content(path)
    return dict(sorted(found.items()))


def _files(folder: str, lessons: bool) -> Iterator[str]:
    for place, folders, names in os.walk(folder):
        here = os.path.relpath(place, folder).replace(os.sep, '/')
        beside_notebooks = lessons and here == '.'
        folders[:] = sorted(name for name in folders if _is_handed_out(name, beside_notebooks))
        for name in sorted(names):
            if _is_handed_out(name, beside_notebooks):
                yield name if here == '.' else f'{here}/{name}'


def _is_handed_out(name: str, beside_notebooks: bool) -> bool:
    """Not what is kept back, what is hidden (.outputs, .ipynb_checkpoints), nor, beside the notebooks, what running them left
    (my_launch, my_ws), the notes for teachers and what serves our tests. An exercise may be called my_package, or notes.
    """
    if beside_notebooks and (name.startswith('my_') or name in (NOTES, 'conftest.py', 'coverage.toml')):
        return False
    return name not in KEPT_BACK and not name.startswith('.') and not name.endswith(('.pyc', '.results'))


def _content(path: str) -> bytes:
    if os.path.islink(path):
        raise UnusableInput(f'{path} is a link: what it leads to may not be meant for students', help='put the file itself there')
    with open(path, 'rb') as file:
        data = file.read()
    if not path.endswith('.ipynb'):
        return data
    try:
        return as_text(without_outputs(json.loads(data))).encode()
    except (ValueError, KeyError, TypeError, AttributeError) as error:
        raise UnusableInput(f'the notebook {path} cannot be read: {error!r}', help='open it in JupyterLab and save it') from None

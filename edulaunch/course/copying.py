"""Functions that create a course, and that copy or pack a course for all students or for one student.

Students get lessons without outputs, exercises and questions, but no solutions, rubrics or stored outputs.
"""

from __future__ import annotations

import json
import os
import shutil
from collections.abc import Callable, Mapping
from functools import partial
from hashlib import sha256
from typing import NamedTuple

from edugrade.course import MANIFEST, read_course
from edugrade.files import files_below
from edugrade.variant import FILE, CourseSecret, personal, write_variants

from edulaunch.errors import UnusableInput

from .lessons import EXERCISES, LESSONS, manifest
from .lessons import FOLDER as NOTES
from .notebook_file import parse_notebook
from .questions import FILE as QUESTIONS
from .questions import SEALED, questions_file, seal
from .stored import as_text, without_outputs

STARTER = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'starter')
"""The course from which a new course is copied. It consists of files, so that tests can check it like every course."""


def new_course(folder: str) -> list[str]:
    """Create a course. Return the names of its files, relative to the folder.

    :raises UnusableInput: when the folder exists and is not empty, or cannot be created.
    """
    if os.path.lexists(folder) and not (os.path.isdir(folder) and not os.listdir(folder)):
        raise UnusableInput(f'{folder} already exists and is not empty', help='name a new folder')
    try:
        shutil.copytree(STARTER, folder, dirs_exist_ok=True, ignore=shutil.ignore_patterns('__pycache__', 'my_*'))
    except OSError as error:
        raise UnusableInput(f'cannot create {folder}: {error}') from None
    return sorted(files_below(folder, lambda name, inside: True))


RUBRICS = 'rubrics'
KEPT_BACK = ('solutions', RUBRICS, '__pycache__', 'my_progress.toml', 'my_progress.toml.bak')
"""The names of files that students never get, in any folder."""
BESIDE = (MANIFEST, 'README.md', 'LICENSE', 'requirements.txt')
"""The files beside the folders of a course. Students get them if the course has its own folder, which contains the manifest."""


def student_files(course: str, *, rubrics: bool = False) -> dict[str, bytes]:
    """Return a dict from the path of each file that students get to its content, in alphabetical order. The paths are relative
    to the course, with slashes.

    :param rubrics: whether to include the rubrics, so that students can check their work.
    :raises UnusableInput: when a notebook cannot be read, or a file is a link (which may lead to a solution).
    """
    found: dict[str, bytes] = {}
    for name in (*BESIDE, LESSONS, EXERCISES, *([RUBRICS] if rubrics else [])):
        path = os.path.join(course, name)
        if os.path.isdir(path):
            inner = files_below(path, partial(_is_handed_out, name == LESSONS))
            found |= {f'{name}/{each}': _content(os.path.join(path, *each.split('/'))) for each in inner}
        elif os.path.isfile(path) and os.path.isfile(os.path.join(course, MANIFEST)):
            found[name] = _content(path)
    found.pop(f'{LESSONS}/{QUESTIONS}', None)
    if (questions := questions_file(os.path.join(course, LESSONS))) is not None:
        data = _content(questions)
        found[f'{LESSONS}/{SEALED}'] = data if os.path.basename(questions) == SEALED else seal(data)
    return dict(sorted(found.items()))


def _is_handed_out(in_lessons: bool, name: str, inside: str) -> bool:
    """Return whether students get a file. Hidden files (.outputs, .ipynb_checkpoints) and files for teachers are left out.

    In the folder of the notebooks, the results of running them (my_launch, my_ws) are left out, too. So are the notes for
    teachers and the files for edulaunch's own tests. An exercise may still have the name my_package, or notes.
    """
    if in_lessons and not inside and (name.startswith('my_') or name in (NOTES, 'conftest.py', 'coverage.toml')):
        return False
    return name not in KEPT_BACK and not name.startswith('.') and not name.endswith(('.pyc', '.results'))


def _content(path: str) -> bytes:
    if os.path.islink(path):
        raise UnusableInput(
            f'{path} is a link, and its target may not be meant for students', help='replace the link by the file'
        )
    with open(path, 'rb') as file:
        data = file.read()
    if not path.endswith('.ipynb'):
        return data
    return as_text(without_outputs(parse_notebook(data, path).content)).encode()


LONGEST_NAME = 80


def personal_files(files: Mapping[str, bytes], course: str, student: str, secret: CourseSecret) -> dict[str, bytes]:
    """Return the copy for one student: exercises in the student's variant, and the file that the grader uses.

    :param files: the files that all students get, by path.
    :raises UnusableInput: for an invalid name, or when no exercise of the course has variants.
    """
    if not student.isprintable() or not 0 < len(student) <= LONGEST_NAME:
        raise UnusableInput(
            f'{student!r} is not a student name', help='use the name of the folder with the submissions of the student'
        )
    path = manifest(course)
    known = read_course(path) if path else []
    variants = {item.name: found for item in known if (found := personal(item, student, secret)) is not None}
    if not variants:
        raise UnusableInput(
            'no exercise of this course has variants', help=f'write variants = [["usual", "other"], ...] in {MANIFEST}'
        )
    made = dict(files)
    for item in known:
        for name in files:
            inside = name.split('/')
            if item.name in variants and inside[0] == EXERCISES and inside[1:2] == [item.path]:
                made[name] = _made(files[name], variants[item.name].stub)
    made[f'{EXERCISES}/{FILE}'] = write_variants(student, variants)
    return dict(sorted(made.items()))


def _made(data: bytes, personal: Callable[[str], str]) -> bytes:
    try:
        return personal(data.decode('utf-8')).encode()
    except UnicodeDecodeError:
        return data  # the file is not text, for example a picture


RECORD = '.edulaunch_course.json'
"""A file beside the copy, with a digest of each copied file. A later copy finds the files that the student changed with it."""
MOST_NAMED = 8
_NO_DATE = (1980, 1, 1, 0, 0, 0)


class Copied(NamedTuple):
    """The result of a copy: the files that were written, and the student's files that were not replaced by newer files of the
    course.
    """

    written: list[str]
    left_alone: list[str]


def copy_files(files: Mapping[str, bytes], target: str, *, update: bool = False) -> Copied:
    """Write the files to a folder. Replace an existing file only if it equals the file of an earlier copy.

    :param update: whether to write all other files if the student changed some. If False, reject the whole copy.
    :raises UnusableInput: when the student changed files and `update` is False (nothing is then written), or when a file cannot
        be read or written.
    """
    known = _record(target)
    wanted = [name for name, data in files.items() if _read(target, name) != data]
    changed = [name for name in wanted if _is_changed(target, name, known)]
    if changed and not update:
        more = f' and {len(changed) - MOST_NAMED} more' if len(changed) > MOST_NAMED else ''
        raise UnusableInput(
            f'nothing was copied, because you changed {", ".join(changed[:MOST_NAMED])}{more} in {target}',
            help='add --update to keep your files and copy the new ones, or copy to another folder',
        )
    written = [name for name in wanted if name not in changed]
    for name in written:
        write_file(target, name, files[name])
    digests = {name: _digest(files[name]) for name in files if name not in changed}
    write_file(target, RECORD, (json.dumps({**known, **digests}, indent=1, sort_keys=True) + '\n').encode())
    return Copied(written, changed)


def write_zip(files: Mapping[str, bytes], path: str) -> None:
    """Write a zip file. Equal files always give the same bytes.

    :raises UnusableInput: when the zip file cannot be written.
    """
    from zipfile import ZIP_DEFLATED, ZipFile, ZipInfo

    try:
        with ZipFile(path, 'w', ZIP_DEFLATED) as zipped:
            for name, data in files.items():
                entry = ZipInfo(name, _NO_DATE)
                entry.external_attr = 0o644 << 16
                zipped.writestr(entry, data, ZIP_DEFLATED)
    except OSError as error:
        raise UnusableInput(f'cannot write {path}: {error.strerror}') from None


def _is_changed(target: str, name: str, known: Mapping[str, str]) -> bool:
    there = _read(target, name)
    return there is not None and known.get(name) != _digest(there)


def _digest(data: bytes) -> str:
    return sha256(data).hexdigest()


def _record(target: str) -> dict[str, str]:
    """Return the record of the previous copy. If it cannot be read, return an empty record, so that every file that differs
    counts as changed.
    """
    try:
        found = json.loads(_read(target, RECORD) or b'{}')
    except ValueError:
        return {}
    return found if isinstance(found, dict) else {}


def _read(target: str, name: str) -> bytes | None:
    try:
        with open(os.path.join(target, *name.split('/')), 'rb') as file:
            return file.read()
    except FileNotFoundError:
        return None
    except OSError as error:
        raise UnusableInput(f'cannot read {os.path.join(target, name)}: {error.strerror}') from None


def write_file(target: str, name: str, data: bytes | str) -> None:
    """Write a file to a folder, and create the folders between.

    :param name: the path of the file in the folder, with slashes.
    :raises UnusableInput: when the file cannot be written.
    """
    path = os.path.join(target, *name.split('/'))
    try:
        os.makedirs(os.path.dirname(os.path.abspath(path)), exist_ok=True)
        with open(path, 'wb') as file:
            file.write(data.encode() if isinstance(data, str) else data)
    except OSError as error:
        raise UnusableInput(f'cannot write {path}: {error.strerror}') from None

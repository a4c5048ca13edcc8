"""Run the lessons of a course for pages and slides. Several lessons run at the same time, and unchanged lessons do not run again.

Each lesson runs in a separate folder with the files that earlier lessons write with ``%%writefile``, as for a student.
A lesson that needs more files fails in such a folder. Then all lessons run in one folder, in order.
"""

from __future__ import annotations

import json
import os
import sys
from collections.abc import Callable, Iterator
from concurrent.futures import ThreadPoolExecutor
from hashlib import sha256
from tempfile import TemporaryDirectory
from typing import Any

import edugrade
from edugrade.files import files_below, write_whole
from edugrade.rubrics.catalogue import rubrics_folder

from edulaunch.engine.underlay_place import engine_folder
from edulaunch.errors import UnusableInput

from .copying import copy_files, student_files
from .lessons import LESSONS
from .notebook_file import parse_notebook, read_outputs_file
from .stored import run_notebook, without_place

WRITES = '%%writefile '
Outputs = dict[str, list[dict[str, Any]]]
"""The outputs of each code cell of a lesson, by the ID of the cell."""
Say = Callable[[str], None]


def run_lessons(course: str, names: list[str], wanted: list[str], say: Say = lambda line: None) -> dict[str, Outputs]:
    """Return the outputs of lessons by the name of the lesson. The lessons run as for a student.

    :param names: all lessons up to the last wanted lesson, in their order.
    :param wanted: the lessons whose outputs are needed.
    :param say: called with one line before the run, and one line for each lesson that has run.
    :raises UnusableInput: when a cell fails that is not tagged `raises-exception`.
    """
    files = student_files(course, rubrics=True)
    keys = {name: _key(files, names[: names.index(name) + 1]) for name in wanted}
    found = {name: kept for name in wanted if (kept := _read(keys[name])) is not None}
    missing = [name for name in wanted if name not in found]
    if found:
        say(f'{len(found)} of {len(wanted)} lessons have not changed since their last run')
    if missing:
        say(f'running {len(missing)} {"lesson" if len(missing) == 1 else "lessons"}')
    try:
        run = dict(_run_separately(files, names, missing, say))
    except UnusableInput:
        say('a lesson needs more than the files of earlier lessons: all lessons run in order')
        run = {name: gave for name, gave in _in_order(files, names, say) if name in wanted}
    for name in missing:
        _store(keys[name], run[name])
    return {**found, **run}


def _run_separately(files: dict[str, bytes], names: list[str], missing: list[str], say: Say) -> Iterator[tuple[str, Outputs]]:
    """Run each lesson in a folder with the files of the earlier lessons. Use one process for each processor."""

    def one(name: str) -> Outputs:
        with TemporaryDirectory(prefix='edulaunch-lesson-', ignore_cleanup_errors=True) as place:
            copy_files({**files, **_written(files, names[: names.index(name)])}, place)
            return _outputs(place, name)

    with ThreadPoolExecutor(max(1, os.cpu_count() or 1)) as pool:
        for number, (name, gave) in enumerate(zip(missing, pool.map(one, missing), strict=True)):
            say(f'{name}: lesson {number + 1} of {len(missing)}')
            yield name, gave


def _in_order(files: dict[str, bytes], names: list[str], say: Say) -> Iterator[tuple[str, Outputs]]:
    """Run the lessons in order in one folder."""
    with TemporaryDirectory(prefix='edulaunch-lesson-', ignore_cleanup_errors=True) as place:
        copy_files(files, place)
        for number, name in enumerate(names):
            yield name, _outputs(place, name)
            say(f'{name}: lesson {number + 1} of {len(names)}')


def _outputs(place: str, name: str) -> Outputs:
    folder = os.path.join(place, LESSONS)
    done = run_notebook(os.path.join(folder, f'{name}.ipynb'), called=f'{LESSONS}/{name}.ipynb')
    given = {cell['id']: cell['outputs'] for cell in done['cells'] if cell['cell_type'] == 'code'}
    return dict(without_place(given, folder))


def _written(files: dict[str, bytes], names: list[str]) -> dict[str, bytes]:
    """Return the files that lessons write with ``%%writefile``, in their state after the last lesson."""
    written: dict[str, bytes] = {}
    for name in names:
        path = f'{LESSONS}/{name}.ipynb'
        for cell in parse_notebook(files[path], path).cells:
            first, _, rest = cell.source.partition('\n')
            path = first.removeprefix(WRITES).strip()
            if first.startswith(WRITES) and not os.path.isabs(path) and '..' not in path:
                written[f'{LESSONS}/{path}'] = f'{rest}\n'.encode()
    return written


def _key(files: dict[str, bytes], names: list[str]) -> str:
    """Return a digest of everything that influences the outputs: edulaunch, the course's files, and the lessons up to this
    one.
    """
    digest = sha256(sys.version.encode())
    for root in (engine_folder(), os.path.dirname(os.path.abspath(edugrade.__file__)), rubrics_folder()):
        for name in files_below(root, lambda each, inside: each not in ('__pycache__', 'ours') and not each.endswith('.pyc')):
            state = os.stat(os.path.join(root, name))
            digest.update(f'{name} {state.st_mtime_ns} {state.st_size}\n'.encode())
    lessons = {f'{LESSONS}/{name}.ipynb' for name in names}
    for name, data in files.items():
        if not name.endswith('.ipynb') or name in lessons:
            digest.update(f'{name} {sha256(data).hexdigest()}\n'.encode())
    return digest.hexdigest()


def _place(key: str) -> str:
    home = os.environ.get('XDG_CACHE_HOME') or os.path.join(os.path.expanduser('~'), '.cache')
    return os.path.join(home, 'edulaunch', 'lessons', f'{key}.json')


def _read(key: str) -> Outputs | None:
    try:
        return read_outputs_file(_place(key))
    except (OSError, ValueError):
        return None


def _store(key: str, outputs: Outputs) -> None:
    """Store outputs for the next call. If the folder cannot be written, store nothing: the lessons then run again."""
    try:
        os.makedirs(os.path.dirname(_place(key)), exist_ok=True)
        write_whole(_place(key), json.dumps(outputs))
    except (OSError, UnusableInput):
        return

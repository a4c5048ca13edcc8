"""`edulaunch course lite`: write the files of the browser edition, which any web server can serve."""

from __future__ import annotations

import json
import os
import shutil
from pathlib import Path
from typing import Any

import edugrade
from edugrade.files import files_below

from edulaunch.course.copying import student_files, write_zip
from edulaunch.engine.underlay_place import engine_folder
from edulaunch.errors import UnusableInput

TRIED, ABI = '0.29.5', '2025_0'
RUNTIME = ('pyodide.mjs', 'pyodide.asm.js', 'pyodide.asm.wasm', 'python_stdlib.zip', 'pyodide-lock.json')
PAGE = os.path.join(os.path.dirname(os.path.abspath(__file__)), 'page')
LEFT_OUT = ('__pycache__', 'ours')
BINARY = ('.so', '.pyd', '.pyc')
WANTED = 'numpy'
"""A package that is included if the folder of the runtime contains it, because messages with arrays of numbers need it."""


def make_site(out: str, runtime: str, course: str) -> list[str]:
    """Write the browser edition to a new folder.

    :param runtime: the folder of Pyodide, such as ``node_modules/pyodide``.
    :param course: the folder of the course whose exercises the page offers, with their rubrics.
    :returns: warnings about differences from the tested setup.
    :raises UnusableInput: when the folder is not empty, or `runtime` is not a folder of Pyodide.
    """
    lock = _lock(runtime)
    if os.path.isdir(out) and os.listdir(out):
        raise UnusableInput(f'{out} is not empty', help='name a new folder')
    os.makedirs(os.path.join(out, 'pyodide'), exist_ok=True)
    for name in ('index.html', 'desk.mjs', 'worker.mjs', 'style.css'):
        shutil.copy(os.path.join(PAGE, name), out)
    wheel = lock['packages'].get(WANTED, {}).get('file_name', '')
    has_wheel = bool(wheel) and os.path.isfile(os.path.join(runtime, wheel))
    for name in (*RUNTIME, *([wheel] if has_wheel else [])):
        shutil.copy(os.path.join(runtime, name), os.path.join(out, 'pyodide'))
    write_zip(_engine(), os.path.join(out, 'edulaunch.zip'))
    write_zip(_exercises(course), os.path.join(out, 'course.zip'))
    with open(os.path.join(out, 'site.json'), 'w', encoding='utf-8') as file:
        json.dump({'packages': [WANTED] if has_wheel else []}, file)
    return [] if has_wheel else [f'{runtime} has no {WANTED}: messages with arrays of numbers (Odometry, LaserScan) do not work']


def _lock(runtime: str) -> dict[str, Any]:
    missing = [name for name in RUNTIME if not os.path.isfile(os.path.join(runtime, name))]
    help = f'get one in node_modules/pyodide with `npm install pyodide@{TRIED}`'
    if missing:
        raise UnusableInput(f'{runtime} is not a folder of Pyodide {TRIED}: it lacks {", ".join(missing)}', help=help)
    with open(os.path.join(runtime, 'pyodide-lock.json'), encoding='utf-8') as file:
        found: dict[str, Any] = json.load(file)
    if found['info']['abi_version'] != ABI:
        raise UnusableInput(f'{runtime} is not of the Pyodide series {TRIED}; other series crash when tasks switch', help=help)
    return found


def _exercises(course: str) -> dict[str, bytes]:
    files = student_files(course, rubrics=True)
    return {name: data for name, data in files.items() if name.startswith(('exercises/', 'rubrics/', 'course.toml'))}


def _engine() -> dict[str, bytes]:
    """Return the Python packages for the browser: edulaunch, edugrade with rubrics, PyYAML without C, and a replacement for
    greenlet.
    """
    import yaml
    from edugrade.rubrics.catalogue import rubrics_folder

    grader, parser = (os.path.dirname(os.path.abspath(str(module.__file__))) for module in (edugrade, yaml))
    places = [(engine_folder(), 'edulaunch'), (grader, 'edugrade'), (rubrics_folder(), 'edugrade/checks'), (parser, 'yaml')]
    files = {'greenlet.py': Path(PAGE, 'greenlet.py').read_bytes()}
    for folder, name in places:
        inner = files_below(folder, lambda each, inside: each not in LEFT_OUT and not each.endswith(BINARY))
        files |= {f'{name}/{each}': Path(folder, each).read_bytes() for each in inner}
    return files

"""All solutions and built-in launch files give the same recordings whatever the environment of the process is.

One process runs all files. Each of sixteen others differs from it in everything that two computers of a class differ in (folders, language, time
zone, hash seed, terminal, a copy of edulaunch at another place) and runs a quarter of the files, so that each file is run in five environments.
"""

from __future__ import annotations

import json
import os
import shutil
import subprocess
import sys
from collections.abc import Iterator
from pathlib import Path

import pytest

ROOT = Path(__file__).resolve().parents[1]
PROGRAM = """
import json, os, sys
code, part = sys.argv[1:]
sys.path[:0] = [code, os.path.join(code, 'grader')]
import edulaunch
assert edulaunch.__file__.startswith(code), edulaunch.__file__
edulaunch.source()
from edulaunch.engine.packages.sourced import sourced_index
from edulaunch.extras.comparing.sweep import launch_files

index, words = sourced_index(), []
for package in sorted(index.packages()):
    share = os.path.join(index.prefix(package), 'share', package)
    words += [(package, os.path.basename(path)) for path in launch_files(share)]
words += [(path,) for path in launch_files('solutions')]
found = {}
for number, each in enumerate(words):
    if part == 'all' or number % 4 == int(part) % 4:
        try:
            found[' '.join(each)] = edulaunch.run(*each, duration_s=2.0, seed=1).digest()
        except edulaunch.errors.EdulaunchError as error:
            found[' '.join(each)] = type(error).__name__
print(json.dumps(found), file=sys.__stdout__)
"""
TERMINALS = ({'TERM': 'dumb', 'COLUMNS': '40'}, {'TERM': 'xterm-256color', 'COLUMNS': '200', 'NO_COLOR': '1'})
LANGUAGES = ({'LC_ALL': 'C', 'TZ': 'Asia/Kathmandu'}, {'LC_ALL': 'C.UTF-8', 'LANG': 'tr_TR.UTF-8', 'LANGUAGE': 'de', 'TZ': 'UTC'})
PEOPLE = ({'USER': 'ada', 'LOGNAME': 'ada'}, {'USER': 'Grace H', 'LOGNAME': 'grace', 'EDITOR': 'vi', 'PS1': '$ '})


def digests(code: Path, folder: Path, part: str, **env: str) -> dict[str, str]:
    """What the process that runs that part of the files found: the digest of each."""
    for name in ('home', 'tmp'):
        (folder / name).mkdir(parents=True)
    shutil.copytree(ROOT / 'solutions', folder / 'solutions')
    done = subprocess.run(
        [sys.executable, '-c', PROGRAM, str(code), part],
        capture_output=True,
        text=True,
        cwd=folder,
        env={'PATH': os.environ['PATH'], 'HOME': str(folder / 'home'), 'TMPDIR': str(folder / 'tmp'), **env},
    )
    assert done.returncode == 0, done.stderr
    found: dict[str, str] = json.loads(done.stdout.splitlines()[-1])
    return found


@pytest.fixture(scope='module')
def elsewhere(tmp_path_factory: pytest.TempPathFactory) -> Path:
    """A copy of the code at another place, as an installation is one."""
    place = tmp_path_factory.mktemp('a copy') / 'site-packages'
    skip = shutil.ignore_patterns('__pycache__')
    shutil.copytree(ROOT / 'edulaunch', place / 'edulaunch', ignore=skip)
    shutil.copytree(ROOT / 'grader', place / 'grader', ignore=skip)
    return place


def environments(copy: Path) -> Iterator[tuple[int, Path, dict[str, str]]]:
    """(number, where the code lies, variables) of each."""
    for number in range(16):
        bits = [number >> bit & 1 for bit in range(4)]
        variables = {'PYTHONHASHSEED': str(number), **TERMINALS[bits[0]], **LANGUAGES[bits[1]], **PEOPLE[bits[2]]}
        yield number, copy if bits[3] else ROOT, variables


@pytest.mark.whole
def test_sixteen_environments_give_the_same_recordings(tmp_path: Path, elsewhere: Path) -> None:
    here = digests(ROOT, tmp_path / 'here', 'all', PYTHONHASHSEED='42')
    assert len(here) > 50 and sum(len(digest) == 64 for digest in here.values()) > 45, here
    differ = []
    for number, code, variables in environments(elsewhere):
        folder = tmp_path / f'{number} für' / ('deep/' * (number % 3)) / 'there'
        there = digests(code, folder, str(number), **variables)
        assert len(there) >= len(here) // 4
        differ += [(number, file) for file in there if there[file] != here[file]]
    assert differ == []

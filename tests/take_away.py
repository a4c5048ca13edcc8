"""The take-away test: `python -m tests.take_away [FOLDER...]` deletes extras in a copy of the house, and shows that nothing else notices.

For each extra, and for all at once: what is left is in `--help` and runs, what went is not, and whoever asks for it reads which plug-in
is missing and how to install it. Once, with all extras gone, the unit tests of everything that is left run.
"""

from __future__ import annotations

import os
import shutil
import subprocess
import sys
import time
from collections.abc import Iterator, Sequence
from contextlib import contextmanager
from functools import cache
from itertools import takewhile
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple

from tests.house import ROOT
from tests.kinds import KINDS

SOURCED = ('AMENT_', 'COLCON_', 'ROS_')
"""The beginnings of variables that an activated environment sets: they lead to the house itself, not to the copy."""
LEFT_OUT = shutil.ignore_patterns('.git', '.venv*', '__pycache__', '.*_cache', '.ipynb_checkpoints', 'build', 'dist')
OF_THE_HOUSE = (
    'tests/test_tested.py',
    'tests/lessons/test_features.py::test_the_tests_that_are_named_exist',
    'tests/test_docs.py::test_the_files_of_the_three_walks_are_there',
    'tests/test_docs.py::test_the_files_that_a_page_names_are_there',
    'tests/test_errors.py::test_every_extra_that_a_message_names_is_there',
)
"""Tests that name every folder, and so also those that went."""


class Extra(NamedTuple):
    """What can be taken away.

    :ivar folders: its files, from the root of the house; their tests go with them.
    :ivar words: commands that it brings, and the plug-in that each of them names when the extra is gone.
    """

    folders: tuple[str, ...]
    words: dict[tuple[str, ...], str] = {}


CIRCLE = 'solutions/circle.launch.py'
COMPARE, NETWORK, REAL = (
    ('edulaunch', 'compare', CIRCLE),
    ('edulaunch', 'network', 'on'),
    ('edulaunch', 'launch', '--real', CIRCLE),
)
CLASSES = ('batch', 'classroom', 'doctor', 'export', 'gradescope', 'sign', 'similar', 'verify')
EXTRAS = {
    'comparing': Extra(('edulaunch/extras/comparing', 'tests/extras/comparing'), {COMPARE: 'comparing'}),
    'network': Extra(
        ('edulaunch/extras/network', 'tests/extras/network'), {COMPARE: 'network', NETWORK: 'network', REAL: 'network'}
    ),
    'native': Extra(('edulaunch/extras/native', 'tests/extras/native'), {COMPARE: 'native', NETWORK: 'native', REAL: 'native'}),
    'editor': Extra(
        ('edulaunch/extras/editor', 'tests/extras/editor'),
        {('edulaunch', 'lsp', '--stdio'): 'editor', ('edulaunch', 'course', 'template', 'vscode', '.'): 'editor'},
    ),
    'foxglove': Extra(('edulaunch/extras/foxglove', 'tests/extras/foxglove'), {('edulaunch', 'view', '--foxglove'): 'foxglove'}),
    'testing': Extra(
        (
            *(f'edulaunch/extras/{name}' for name in ('testing', 'pytest_plugin', 'launch_test.py')),
            *(f'tests/extras/{name}' for name in ('testing', 'launch_testing', 'launch_pytest')),
        )
    ),
    'classes': Extra(
        ('grader/edugrade/classes', 'tests/grader/classes', 'tests/browser/test_reports.py'),
        {
            **{('edugrade', verb, 'x'): 'classes' for verb in CLASSES},
            ('edulaunch', 'course', 'template', 'gradescope', '.'): 'classes',
        },
    ),
    'course': Extra(('edulaunch/course', 'tests/course'), {('edulaunch', 'course', 'list'): 'course'}),
}
STAYS = ('course',)
"""Taken away alone only: lessons import it, and their tests are many."""


def main(tests: Sequence[str]) -> int:
    """Take away each extra, then all; returns the exit code.

    :param tests: the folders of unit tests that are run without any extra; none: all of them.
    """
    with TemporaryDirectory(prefix='take-away-') as temporary:
        house = Path(temporary, 'house')
        shutil.copytree(ROOT, house, ignore=LEFT_OUT, symlinks=True)
        wrong = [line for name, extra in EXTRAS.items() for line in _without(house, [extra], name)]
        all_extras = [extra for name, extra in EXTRAS.items() if name not in STAYS]
        with _taken_away(house, [*all_extras, Extra(('tests/extras/test_ours.py',))]):
            began = time.monotonic()
            code = _unit_tests(house, tests or ['tests'])
        print(f'without any extra: the unit tests of what is left end with {code} ({time.monotonic() - began:.0f} s)')
    for line in wrong:
        print(f'WRONG {line}')
    return 1 if wrong or code else 0


def _without(house: Path, extras: Sequence[Extra], name: str) -> list[str]:
    words = {words: plugin for extra in extras for words, plugin in extra.words.items()}
    before = _helps_of_all(house)
    with _taken_away(house, extras):
        wrong = [f'{name}: {problem}' for call, plugin in words.items() for problem in _refusal(house, call, plugin)]
        after = _helps(house)
        ours = {' '.join(call[:2]) for call in words if call[1] not in ('launch', 'view') and call[2] != 'template'}
        wrong += [f'{name}: {word} is not in --help even before' for word in sorted(ours - before)]
        wrong += [f'{name}: {word} is still in --help' for word in sorted(ours & after)]
        wrong += [f'{name}: {word} went from --help, too' for word in sorted(before - after - ours)]
        run = _run(house, 'edulaunch', 'launch', CIRCLE, '--fast', '--for', '1')
        graded = _run(house, 'edugrade', CIRCLE)
        wrong += [
            f'{name}: {done.args[2:]} ends with {done.returncode}: {done.stderr}' for done in (run, graded) if done.returncode
        ]
    print(f'without {name}: {len(words)} commands name what is missing, {len(after)} verbs are left')
    return wrong


@cache
def _helps_of_all(house: Path) -> set[str]:
    """The verbs of the complete house, which is the same before each extra is taken away."""
    return _helps(house)


def _helps(house: Path) -> set[str]:
    """The verbs that the helps of both commands name."""
    found = set()
    for command in ('edulaunch', 'edugrade'):
        below = _run(house, command, '--help').stdout.partition('commands')[2]
        lines = takewhile(str.strip, below.splitlines()[1:])
        found |= {f'{command} {line.split()[0]}' for line in lines if line[:2] == '  ' and line[2:3].isalpha()}
    return found


def _refusal(house: Path, call: Sequence[str], plugin: str) -> Iterator[str]:
    done = _run(house, *call)
    wanted = f"needs the plug-in '{plugin}', which is not installed.\n  help: install it: pip install "
    if done.returncode != 2 or wanted not in done.stderr or 'Traceback' in done.stderr:
        yield f'{" ".join(call)} ends with {done.returncode} and says {done.stdout}{done.stderr}'


@contextmanager
def _taken_away(house: Path, extras: Sequence[Extra]) -> Iterator[None]:
    """Without the folders of extras; they are brought back."""
    away = house.with_name('away')
    away.mkdir()
    taken = [folder for extra in extras for folder in extra.folders]
    try:
        for number, folder in enumerate(taken):
            os.rename(house / folder, away / str(number))
        yield
    finally:
        for number, folder in enumerate(taken):
            os.rename(away / str(number), house / folder)
        away.rmdir()


def _environment(house: Path) -> dict[str, str]:
    path = os.pathsep.join((str(house), str(house / 'grader')))
    kept = {name: value for name, value in os.environ.items() if name != 'EDULAUNCH_THOROUGH' and not name.startswith(SOURCED)}
    return {**kept, 'PYTHONPATH': path, 'COLUMNS': '200'}


def _run(house: Path, command: str, *words: str) -> subprocess.CompletedProcess[str]:
    line = [sys.executable, '-m', command, *words]
    return subprocess.run(line, cwd=house, env=_environment(house), capture_output=True, text=True, timeout=120)


def _unit_tests(house: Path, tests: Sequence[str]) -> int:
    """The tests that the README runs, of what is left; pytest's own entry point of the extra `pytest_plugin` is gone with it."""
    options = ['-q', '-p', 'no:edulaunch', '-p', 'no:cacheprovider', '-r', 'fE', '-m', f'not ({" or ".join(KINDS)})']
    deselected = [f'--deselect={test}' for test in OF_THE_HOUSE]
    return subprocess.run(
        [sys.executable, '-m', 'pytest', *options, *deselected, *tests], cwd=house, env=_environment(house), timeout=900
    ).returncode


if __name__ == '__main__':
    sys.exit(main(sys.argv[1:]))

"""Every module has tests: a file of its name in a folder of its room, tests that import what it defines, or a line of tested_by.toml
that says who runs it."""

from __future__ import annotations

import re
import sys
from collections.abc import Iterator
from fnmatch import fnmatchcase
from functools import cache
from pathlib import Path

import pytest

from tests.house import FACES, ROOT, modules

if sys.version_info >= (3, 11):
    import tomllib
else:
    import tomli as tomllib

TESTS = ROOT / 'tests'
GROUPS = tomllib.loads((TESTS / 'tested_by.toml').read_text(encoding='utf-8'))['group']
FROM = re.compile(r'(?m)^ *from ([\w.]+) import (\([^)]*\)|.+)$')
NOT_RUN = {'corpus', 'golden'}
"""Folders with packages of students, whose own tests are no tests of ours."""


@cache
def untested() -> list[str]:
    """Modules without a test file of their name in a folder of their room, and of which no test imports anything by name."""
    files: dict[str, list[set[str]]] = {}
    for path in TESTS.rglob('test_*.py'):
        files.setdefault(path.stem.removeprefix('test_'), []).append(set(path.relative_to(TESTS).parts[:-1]))
    names = {
        name
        for path in [*TESTS.rglob('test_*.py'), *TESTS.rglob('conftest.py')]
        if not NOT_RUN & set(path.parts)
        for name in _imported(path.read_text(encoding='utf-8'))
    }
    return [
        name
        for name, path in modules().items()
        if path.name != '__init__.py' and not _is_mirrored(name, files) and not _is_imported(name, path, names)
    ]


def _is_mirrored(name: str, files: dict[str, list[set[str]]]) -> bool:
    """Whether a test file has the name of a module, and its folder that of a package which the module is in. Tests of edugrade
    lie in tests/grader, tests of ROS's smaller packages in tests/ros/underlay, those of modules in no room in their wing's folder.
    """
    *packages, last = name.split('.')
    rooms = {*packages, 'grader' if packages[0] == 'edugrade' else '', 'underlay' if packages[0] in FACES else ''}
    return any(folders & rooms or (not folders and packages == ['edulaunch']) for folders in files.get(last.lstrip('_'), ()))


def _imported(text: str) -> Iterator[str]:
    """Dotted names that a file imports, or writes as a text (to patch them)."""
    for module, words in FROM.findall(text):
        yield from (f'{module}.{word}' for word in re.findall(r'(\w+)(?: as \w+)?', words.split('#')[0].strip('()')))
    for words in re.findall(r'(?m)^ *import (.+)$', text):
        yield from re.findall(r'([\w.]+)(?: as \w+)?', words)
    yield from re.findall(r"'(\w+(?:\.\w+)+)'", text)


def _is_imported(name: str, path: Path, names: set[str]) -> bool:
    """Whether a test imports the module, or what it defines from it or from a package above it (`launch.actions.TimerAction`)."""
    parts = name.split('.')
    places = ['.'.join(parts[: count + 1]) for count in range(len(parts))]
    defined = re.findall(r'(?m)^(?:class|(?:async )?def) (\w+)', path.read_text(encoding='utf-8'))
    return name in names or any(f'{place}.{word}' in names for place in places for word in defined)


@pytest.mark.parametrize(
    ('name', 'folders', 'answer'),
    [
        ('edulaunch.engine.graph.names', {'graph'}, True),
        ('edulaunch.engine.graph.names', {'tf'}, False),
        ('edulaunch.engine.graph.names', set(), False),
        ('edulaunch.engine.nearest', {'engine'}, True),
        ('edugrade.reports.names', {'grader', 'reports'}, True),
        ('rclpy.impl._names', {'underlay'}, True),
    ],
)
def test_a_test_counts_where_its_folder_is_that_of_the_module(name: str, folders: set[str], answer: bool) -> None:
    assert _is_mirrored(name, {'names': [folders], 'nearest': [folders]}) is answer


def test_every_module_has_tests_or_a_reason() -> None:
    patterns = [pattern for group in GROUPS for pattern in group['modules']]
    missing = [name for name in untested() if not any(fnmatchcase(name, pattern) for pattern in patterns)]
    assert missing == [], (
        'write tests/<room>/test_<module>.py, or say in tests/tested_by.toml which tests run it, and why that is enough'
    )


@pytest.mark.parametrize('group', GROUPS, ids=lambda group: group['why'])
def test_no_reason_is_out_of_date(group: dict[str, list[str]]) -> None:
    assert [place for place in group['by'] if not (ROOT / place).exists()] == []
    unused = [pattern for pattern in group['modules'] if not any(fnmatchcase(name, pattern) for name in untested())]
    assert unused == [], 'these have tests by name now: take them out of tests/tested_by.toml'

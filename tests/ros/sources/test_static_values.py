"""Values of a setup.py that is read without running it: paths, lists of files, packages."""

from __future__ import annotations

import glob
import os
from pathlib import Path
from typing import Any

import pytest

from edulaunch.ros.sources.static_values import PATH_ATTRIBUTES, PathText, Unknown, callables, find_packages, first_unknown

FILES = [
    'setup.py',
    'launch/a.launch.py',
    'launch/deep/b.launch.py',
    'robot/__init__.py',
    'robot/part/__init__.py',
    'robot/data/x.txt',
    'test/__init__.py',
    'no-name/__init__.py',
]


@pytest.fixture
def folder(tmp_path: Path) -> str:
    for name in FILES:
        (tmp_path / name).parent.mkdir(parents=True, exist_ok=True)
        (tmp_path / name).touch()
    return str(tmp_path)


@pytest.fixture
def inside(folder: str, monkeypatch: pytest.MonkeyPatch) -> str:
    monkeypatch.chdir(folder)
    return folder


SAME = ['launch', 'launch/a.launch.py', 'launch/deep/b.launch.py', 'setup.py', 'nothing/x.tar.gz']


@pytest.mark.parametrize('name', SAME)
def test_a_path_answers_as_a_real_one(inside: str, name: str) -> None:
    text, real = PathText.below(inside, name), Path(name)
    for attribute in PATH_ATTRIBUTES - {'parents'}:
        assert str(getattr(text, attribute)) == str(getattr(real, attribute)), attribute
    assert [str(one) for one in text.parents] == [str(one) for one in real.parents]
    assert (text.is_file(), text.is_dir(), text.exists()) == (real.is_file(), real.is_dir(), real.exists())
    assert (str(text.resolve()), str(text.absolute()), text.as_posix()) == (str(real.absolute()), str(real.absolute()), str(real))
    assert os.path.normpath(text / 'x') == os.path.normpath(text.joinpath('x')) == str(real / 'x')
    assert text.joinpath('x').folder == inside


@pytest.mark.parametrize(('start', 'pattern'), [('.', '*.py'), ('launch', '*.py'), ('launch', '*'), ('nothing', '*')])
def test_a_path_lists_files_in_order(inside: str, start: str, pattern: str) -> None:
    text, real = PathText.below(inside, start), Path(start)
    assert list(map(os.path.normpath, text.glob(pattern))) == sorted(map(str, real.glob(pattern)))
    assert list(map(os.path.normpath, text.rglob(pattern))) == sorted(map(str, real.rglob(pattern)))
    there = sorted(map(str, real.iterdir())) if real.is_dir() else []
    assert list(map(os.path.normpath, text.iterdir())) == there


def test_a_path_is_read_below_the_packages_folder_whatever_the_working_folder_is(folder: str) -> None:
    text = PathText.below(folder)
    assert (text, text.folder, (text / 'launch').is_dir(), (text / 'setup.py').is_file()) == ('.', folder, True, True)
    assert PathText.below(folder, f'{folder}/launch').relative_to(folder) == 'launch'
    assert PathText.below(folder, 'a', 'b').parents == ['a', '.']


@pytest.mark.parametrize(
    ('value', 'line'),
    [
        ([1, 'a', None], None),
        (Unknown(3, 'x'), 3),
        ([1, (2, {Unknown(4, 'x')})], 4),
        ({'a': [Unknown(5, 'x')]}, 5),
        ({Unknown(6, 'x'): 1}, 6),
        ({}, None),
    ],
)
def test_the_first_unknown_part_is_found(value: Any, line: int | None) -> None:
    found = first_unknown(value)
    assert (None if found is None else found.line) == line


@pytest.mark.parametrize('pattern', ['*.py', 'launch/*', '**/*.launch.py', 'launch/**'])
def test_glob_lists_as_the_real_one_but_sorted(inside: str, pattern: str) -> None:
    table = callables(inside)
    for recursive in (True, False):
        expected = sorted(glob.glob(pattern, recursive=recursive))
        for name in ('glob.glob', 'glob.iglob'):
            assert list(map(os.path.normpath, table[name](pattern, recursive=recursive))) == list(map(os.path.normpath, expected))
    assert table['glob.glob'](f'{inside}/*.py') == [f'{inside}/setup.py']


def test_folders_are_walked_in_order(folder: str) -> None:
    table = callables(folder)
    assert table['os.walk']('launch') == [('launch', ['deep'], ['a.launch.py']), ('launch/deep', [], ['b.launch.py'])]
    assert table['os.listdir']() == ['launch', 'no-name', 'robot', 'setup.py', 'test']
    assert table['os.listdir']('launch') == ['a.launch.py', 'deep']


@pytest.mark.parametrize(
    ('call', 'given', 'value'),
    [
        ('os.path.relpath', ('launch/deep', 'launch'), 'deep'),
        ('os.path.relpath', ('launch',), 'launch'),
        ('os.path.exists', ('launch',), True),
        ('os.path.exists', ('nothing',), False),
        ('os.path.isfile', ('setup.py',), True),
        ('os.path.isfile', ('launch',), False),
        ('os.path.isdir', ('launch',), True),
        ('os.path.isdir', ('setup.py',), False),
        ('os.path.splitext', ('a.tar.gz',), ('a.tar', '.gz')),
        ('range', (1, 4), [1, 2, 3]),
        ('reversed', ([1, 2],), [2, 1]),
        ('zip', ([1, 2], 'abc'), [(1, 'a'), (2, 'b')]),
        ('enumerate', ('ab',), [(0, 'a'), (1, 'b')]),
        ('map', (str.upper, 'ab'), ['A', 'B']),
        ('filter', (str.isupper, 'aB'), ['B']),
        ('setuptools.find_packages', (), ['robot', 'robot.part', 'test']),
        ('setuptools.find_packages', ('.', ['test', '*.part']), ['robot']),
        ('setuptools.find_packages', ('.', (), ['robot*']), ['robot', 'robot.part']),
        ('setuptools.find_packages', ('robot',), ['part']),
    ],
)
def test_functions_give_what_the_real_ones_give_there(folder: str, call: str, given: tuple[Any, ...], value: Any) -> None:
    assert callables(folder)[call](*given) == value


def test_places_are_below_the_folder(folder: str) -> None:
    table = callables(folder)
    assert (table['os.getcwd'](), table['os.path.abspath']('a/../b')) == (folder, f'{folder}/b')
    assert table['os.path.realpath']('launch') == os.path.realpath(f'{folder}/launch')
    assert (table['pathlib.Path'](), table['pathlib.Path']('a', 'b'), table['pathlib.Path.cwd']()) == ('.', 'a/b', folder)


def test_namespace_packages_need_no_init(folder: str) -> None:
    found = callables(folder)['setuptools.find_namespace_packages']()
    assert found == ['launch', 'launch.deep', 'robot', 'robot.data', 'robot.part', 'test']
    assert find_packages(folder, marker='x.txt') == []

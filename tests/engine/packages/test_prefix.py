"""Install prefixes, and the built-in packages."""

from __future__ import annotations

import builtins
import errno
import os
import sys
from pathlib import Path

import pytest

from edulaunch.engine.packages.prefix import MARKERS, Prefix, Underlay, expand_prefixes, is_python
from edulaunch.engine.packages.reading import Program


def test_the_underlay_is_looked_through_once(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'share' / 'shapes' / 'msg').mkdir(parents=True)
    (tmp_path / 'share' / 'licences').mkdir()
    assert (Underlay(str(tmp_path)).packages(), Underlay(str(tmp_path)).interface_packages()) == (['shapes'], ['shapes'])
    monkeypatch.setattr(os, 'listdir', lambda path: pytest.fail(f'{path} is listed again'))
    assert (Underlay(str(tmp_path)).packages(), Underlay(str(tmp_path)).interface_packages()) == (['shapes'], ['shapes'])


def test_a_moment_without_memory_is_no_package_without_programs(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    (tmp_path / 'share' / 'robo').mkdir(parents=True)
    (tmp_path / 'share' / 'robo' / 'console_scripts.txt').write_text('drive = robo.drive:main\n')
    underlay = Underlay(str(tmp_path))

    def fails(*arguments: object, **options: object) -> object:
        raise OSError(errno.ENOMEM, os.strerror(errno.ENOMEM))

    with monkeypatch.context() as moment:
        moment.setattr(builtins, 'open', fails)
        with pytest.raises(OSError, match='Cannot allocate memory'):
            underlay.executables('robo')
    assert underlay.executables('robo') == ['drive']
    assert underlay.executables('other') == []


SCRIPT = '#!/usr/bin/python3\n# EASY-INSTALL-ENTRY-SCRIPT: robo\nfrom importlib import metadata  # console_scripts\n'


@pytest.fixture
def installed(tmp_path: Path) -> Path:
    """What colcon writes for a package `robo` with two entry points, a script, a program in C++ and a file that is no program."""
    packages = tmp_path / 'lib' / f'python3.{sys.version_info.minor}' / 'site-packages'
    for folder in (
        tmp_path / MARKERS,
        tmp_path / 'lib' / 'robo',
        packages / 'robo',
        packages / 'robo-1.0.dist-info',
        packages / 'no-name',
    ):
        folder.mkdir(parents=True)
    for name in ('robo', 'bare', '.hidden'):
        (tmp_path / MARKERS / name).write_text('')
    (packages / 'robo' / '__init__.py').write_text('')
    (packages / 'alone.py').write_text('')
    (packages / 'robo-1.0.dist-info' / 'entry_points.txt').write_text(
        '[console_scripts]\ndrive = robo.drive : main [extra]\nTurn=robo.turn:go\n[other]\nx = y:z\n'
    )
    for name, text in (
        ('drive', SCRIPT),
        ('Turn', SCRIPT),
        ('tool.py', 'print()\n'),
        ('shell', '#!/bin/sh\n'),
        ('native', '\x7fELF'),
    ):
        (tmp_path / 'lib' / 'robo' / name).write_text(text)
        (tmp_path / 'lib' / 'robo' / name).chmod(0o755)
    (tmp_path / 'lib' / 'robo' / 'notes.py').write_text('')
    (tmp_path / 'share' / 'robo' / 'srv').mkdir(parents=True)
    return tmp_path


def test_an_installed_prefix_has_the_packages_of_the_index(installed: Path) -> None:
    prefix = Prefix(str(installed))
    assert (prefix.packages(), prefix.interface_packages()) == (['bare', 'robo'], ['robo'])
    assert Prefix(str(installed / 'nowhere')).packages() == []


@pytest.mark.skipif(sys.platform == 'win32', reason='a file has no mark of a program there')
def test_the_programs_of_an_installed_package(installed: Path) -> None:
    prefix = Prefix(str(installed))
    assert prefix.executables('robo') == ['Turn', 'drive', 'native', 'shell', 'tool.py'] and prefix.executables('bare') == []
    roots = (str(installed / 'lib' / f'python3.{sys.version_info.minor}' / 'site-packages'),)
    path = str(installed / 'lib' / 'robo')
    assert prefix.program('robo', 'drive') == Program(
        'entry_point', 'robo', 'drive', f'{path}/drive', 'robo.drive', 'main', python_roots=roots
    )
    turn, tool = prefix.program('robo', 'Turn'), prefix.program('robo', 'tool.py')
    assert turn is not None and (turn.module, turn.function) == ('robo.turn', 'go')
    file = os.path.realpath(f'{path}/tool.py')
    assert tool == Program('script', 'robo', 'tool.py', f'{path}/tool.py', file=file, python_roots=roots)
    assert [prefix.program('robo', name) for name in ('native', 'shell', 'notes.py', 'absent')] == [None] * 4


def test_the_modules_of_a_prefix_and_of_its_links(installed: Path, tmp_path_factory: pytest.TempPathFactory) -> None:
    source = tmp_path_factory.mktemp('source')
    (source / 'robo').mkdir()
    (source / 'linked').mkdir()
    packages = installed / 'lib' / f'python3.{sys.version_info.minor}' / 'site-packages'
    (packages / 'robo.egg-link').write_text(f'{source}\n.')
    (packages / 'gone.egg-link').write_text(f'{source}/gone\n.')
    other = installed / 'lib' / 'python3.1' / 'dist-packages'
    (other / 'alone').mkdir(parents=True)
    (other / 'old').mkdir()
    assert Prefix(str(installed)).modules() == {
        'robo': str(packages / 'robo'),
        'alone': str(packages / 'alone.py'),
        'linked': str(source / 'linked'),
        'old': str(other / 'old'),
    }


def test_a_file_of_a_prefix_is_the_one_that_it_links_to(installed: Path) -> None:
    prefix = Prefix(str(installed))
    (installed / 'share' / 'robo' / 'a.yaml').symlink_to(installed / 'lib' / 'robo' / 'notes.py')
    assert prefix.source_path(str(installed / 'share' / 'robo' / 'a.yaml')) == os.path.realpath(
        installed / 'lib' / 'robo' / 'notes.py'
    )
    assert prefix.source_path(f'{installed}2/a.yaml') is None


@pytest.mark.parametrize(
    ('name', 'text', 'answer'),
    [
        ('a', '#!/usr/bin/env python3\n', True),
        ('a.py', 'print()\n', True),
        ('a.py', '#!/bin/sh\n', False),
        ('a', 'python\n', False),
        ('a', '', False),
    ],
)
def test_python_is_known_by_its_first_line_or_its_name(tmp_path: Path, name: str, text: str, answer: bool) -> None:
    (tmp_path / name).write_text(text)
    assert is_python(str(tmp_path / name)) is answer


def test_an_isolated_install_is_one_prefix_for_each_package(installed: Path) -> None:
    assert expand_prefixes(str(installed)) == [str(installed)]
    assert expand_prefixes(str(installed / 'share')) == [str(installed / 'share')]
    for name in ('b', 'a'):
        (installed / 'share' / 'isolated' / name / MARKERS).mkdir(parents=True)
    (installed / 'share' / 'isolated' / 'log').mkdir()
    isolated = str(installed / 'share' / 'isolated')
    assert expand_prefixes(isolated) == [os.path.join(isolated, 'a'), os.path.join(isolated, 'b')]
    assert expand_prefixes('/nowhere/at/all') == ['/nowhere/at/all']


def test_a_built_in_program_has_the_folder_of_a_students_way_of_writing(tmp_path: Path) -> None:
    (tmp_path / 'share' / 'robo').mkdir(parents=True)
    (tmp_path / 'share' / 'robo' / 'console_scripts.txt').write_text(
        '# all\n\nturn = robo.turn : go  # turns\ndrive=other.drive:main\n'
    )
    for folder in ('programs/robo', 'python/face', 'python/rclcpp_like', 'python/bare'):
        (tmp_path / folder).mkdir(parents=True)
    for face in ('face', 'rclcpp_like'):
        (tmp_path / 'python' / face / '__init__.py').write_text('')
    underlay = Underlay(str(tmp_path))
    assert (underlay.packages(), underlay.executables('robo')) == (['face', 'robo'], ['drive', 'turn'])
    assert underlay.modules() == {'robo': str(tmp_path / 'programs' / 'robo')}
    path, programs = str(tmp_path / 'lib' / 'robo'), str(tmp_path / 'programs')
    assert underlay.program('robo', 'turn') == Program(
        'entry_point', 'robo', 'turn', f'{path}/turn', 'robo.turn', 'go', python_roots=(programs,)
    )
    drive = underlay.program('robo', 'drive')
    assert drive is not None and (drive.module, drive.function, drive.python_roots) == ('other.drive', 'main', ())
    assert (underlay.program('robo', 'fly'), underlay.source_path(path)) == (None, None)

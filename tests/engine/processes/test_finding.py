"""Where a program's own modules are looked for, and in which order."""

from __future__ import annotations

from pathlib import Path
from types import SimpleNamespace
from typing import Any

import pytest

from edulaunch.engine.processes.finding import Finder, Found, namespace, regular


@pytest.fixture
def files(tmp_path: Path) -> Path:
    for name in (
        'root/shapes.py',
        'root/robot/__init__.py',
        'late/shapes.py',
        'late/only_late.py',
        'late/plain/part.py',
        'late/deep/in/it.py',
    ):
        path = tmp_path / name
        path.parent.mkdir(parents=True, exist_ok=True)
        path.write_text('')
    (tmp_path / 'late' / 'empty').mkdir()
    return tmp_path


def finder(
    files: Path, installed: dict[str, str] | None = None, before: tuple[str, ...] = (), after: tuple[str, ...] = ()
) -> Finder:
    paths = [str(files / name) for name in before], [str(files / name) for name in after]
    view: Any = SimpleNamespace(private_path=lambda: paths)
    made = Finder(lambda: installed or {}, {'sys': view} if before or after else {})
    made.roots, made.last = [str(files / 'root')], [str(files / 'late')]
    return made


def test_a_package_comes_before_a_module_and_the_first_folder_before_the_second(files: Path) -> None:
    (files / 'root' / 'robot.py').write_text('')
    folders = [str(files / 'root'), str(files / 'late')]
    assert regular('robot', folders) == Found(str(files / 'root' / 'robot' / '__init__.py'), True)
    assert regular('shapes', folders) == Found(str(files / 'root' / 'shapes.py'), False)
    assert regular('only_late', folders) == Found(str(files / 'late' / 'only_late.py'), False)
    assert regular('plain', folders) is None


@pytest.mark.parametrize(('name', 'is_found'), [('plain', True), ('deep', True), ('empty', False), ('nowhere', False)])
def test_a_folder_with_code_in_it_or_one_below_is_a_package(files: Path, name: str, is_found: bool) -> None:
    assert namespace(name, [str(files / 'root'), str(files / 'late')]) == (
        Found(str(files / 'late' / name), True) if is_found else None
    )


def test_before_what_is_shared_come_the_script_and_the_workspace_and_the_package_folder_comes_last(files: Path) -> None:
    one = finder(files, {'installed': str(files / 'late' / 'only_late.py')})
    assert one.first_match('shapes') == Found(str(files / 'root' / 'shapes.py'), False)
    assert one.first_match('installed') is not None
    assert one.first_match('only_late') is None
    assert one.last_match('only_late') == Found(str(files / 'late' / 'only_late.py'), False)
    assert one.last_match('plain') == Found(str(files / 'late' / 'plain'), True)
    assert one.last_match('nowhere') is None


def test_the_module_of_the_entry_point_comes_from_its_own_folder(files: Path) -> None:
    one = finder(files, {'only_late': str(files / 'root' / 'shapes.py')})
    one.own = 'only_late'
    assert one.first_match('only_late') == Found(str(files / 'late' / 'only_late.py'), False)


def test_what_a_program_puts_on_its_path_counts_where_it_put_it(files: Path) -> None:
    first = finder(files, before=('late',)).first_match('shapes')
    assert first == Found(str(files / 'late' / 'shapes.py'), False)
    one = finder(files, after=('late',))
    assert one.first_match('shapes') == Found(str(files / 'root' / 'shapes.py'), False)
    assert one.last_match('shapes') == Found(str(files / 'late' / 'shapes.py'), False)


def test_a_module_that_was_not_there_is_looked_for_again_where_the_path_has_changed(files: Path) -> None:
    one = finder(files)
    assert one.first_match('only_late') is None
    one.roots.append(str(files / 'late'))
    assert one.first_match('only_late') == Found(str(files / 'late' / 'only_late.py'), False)


def test_each_folder_is_named_once(files: Path) -> None:
    one = finder(
        files,
        {'a': str(files / 'lib' / 'a'), 'b': str(files / 'lib' / 'b.py'), 'c': str(files / 'root' / 'c')},
        ('late',),
        ('more',),
    )
    assert one.folders() == [str(files / name) for name in ('late', 'root', 'more', 'lib')]

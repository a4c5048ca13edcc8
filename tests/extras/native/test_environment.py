from __future__ import annotations

import json
import platform
import sys
from pathlib import Path

import pytest

from edulaunch.errors import UnusableInput
from edulaunch.extras.native import environment


@pytest.fixture(autouse=True)
def own_cache(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> Path:
    monkeypatch.delenv(environment.PLACE_VARIABLE, raising=False)
    monkeypatch.setenv('XDG_CACHE_HOME', str(tmp_path))
    return tmp_path


def as_if_installed(folder: Path, text: str) -> None:
    folder.mkdir(parents=True)
    (folder / environment.MARK).write_text(text)


def test_it_lies_in_the_cache_once_for_each_python(own_cache: Path) -> None:
    version = '.'.join(map(str, sys.version_info[:2]))
    assert environment.place() == str(own_cache / 'edulaunch' / f'rclpy-jazzy-python{version}')


def test_a_variable_names_another_place(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setenv(environment.PLACE_VARIABLE, str(tmp_path / 'mine'))
    assert environment.place() == str(tmp_path / 'mine')


def test_it_is_found_when_it_was_finished() -> None:
    assert environment.found() is None
    as_if_installed(Path(environment.place()), json.dumps({'rclpy': '7.1.6'}))
    found = environment.found()
    assert found is not None
    assert (found.version, found.python) == ('7.1.6', f'{environment.place()}/bin/python')


@pytest.mark.parametrize('text', ['', '[]', '{}', 'nonsense'])
def test_a_damaged_one_is_none(text: str) -> None:
    as_if_installed(Path(environment.place()), text)
    assert environment.found() is None


def test_who_needs_it_is_told_how_to_get_it(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(environment, 'unsuited', lambda: None)
    with pytest.raises(UnusableInput, match='not installed') as caught:
        environment.needed()
    assert caught.value.help == 'type: edulaunch network install (220 MB)'


def test_where_there_are_no_wheels_nothing_is_installed(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(platform, 'system', lambda: 'Darwin')
    monkeypatch.setattr(platform, 'machine', lambda: 'arm64')
    with pytest.raises(UnusableInput, match='for Linux on x86-64, and this is Darwin on arm64'):
        environment.install(print)
    assert not Path(environment.place()).exists()


def test_a_folder_of_somebody_else_is_not_removed(monkeypatch: pytest.MonkeyPatch, tmp_path: Path) -> None:
    monkeypatch.setattr(environment, 'unsuited', lambda: None)
    monkeypatch.setenv(environment.PLACE_VARIABLE, str(tmp_path))
    (tmp_path / 'thesis.tex').write_text('')
    with pytest.raises(UnusableInput, match='is not a Python environment'):
        environment.install(print)
    assert (tmp_path / 'thesis.tex').exists()


@pytest.mark.parametrize(
    ('said', 'told'),
    [
        ('WARNING: Retrying ... NewConnectionError(...)\nERROR: No matching distribution found', 'no connection'),
        ('ERROR: No matching distribution found for ros-jazzy-rclpy', 'no wheel of .* fits this machine'),
        ('one\ntwo\nERROR: disk full', 'could not be installed:\none\ntwo\nERROR: disk full'),
    ],
)
def test_what_an_installer_complains_of_is_told_in_a_sentence(said: str, told: str) -> None:
    with pytest.raises(Exception, match=told):
        raise environment._failure(said)


@pytest.mark.processes
def test_what_was_installed_is_tried_without_the_simulated_rclpy_of_an_active_terminal(
    monkeypatch: pytest.MonkeyPatch, tmp_path: Path
) -> None:
    monkeypatch.setenv('PYTHONPATH', str(tmp_path))
    said = environment._run([sys.executable, '-c', 'import os; print(os.environ.get("PYTHONPATH"))'], 'it failed')
    assert said == 'None\n'

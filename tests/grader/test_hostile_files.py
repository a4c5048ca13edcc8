"""Odd files, names and texts in one submission cost no other one its report."""

from __future__ import annotations

import json
import os
from collections.abc import Callable
from pathlib import Path

import pytest
from edugrade.cli import main
from edugrade.grading import plan_work
from edugrade.reports.wording import LONGEST_TEXT, ShortPaths
from edugrade.sandbox.remove_tree import remove_tree
from edugrade.submission import Submission

GOOD = """from launch import LaunchDescription
from launch_ros.actions import Node


def generate_launch_description():
    return LaunchDescription([Node(package='tf2_ros', executable='tf2_echo', arguments=['a', 'b'])])
"""


def package(folder: Path) -> Path:
    (folder / 'launch').mkdir(parents=True)
    (folder / 'package.xml').write_text('<package><name>static_frame</name></package>')
    (folder / 'launch' / 'static_frame.launch.py').write_text(GOOD)
    return folder


def many_digits(folder: Path) -> Path:
    (package(folder) / 'a.py').write_text('# TODO ' + '9' * 5000 + '\n')
    return folder


def half_a_character(folder: Path) -> Path:
    (package(folder) / 'launch' / 'static_frame.launch.py').write_text("raise ValueError('\\udcff and \\ud800')\n")
    return folder


def odd_entries(folder: Path) -> Path:
    package(folder)
    (folder / 'gone.yaml').symlink_to(folder / 'nowhere')
    (folder / 'ring.py').symlink_to(folder / 'ring.py')
    (folder / 'up').symlink_to('..')
    os.mkfifo(folder / 'pipe.py')
    (folder / 'secret.txt').write_text('x')
    (folder / 'secret.txt').chmod(0)
    (Path(os.fsdecode(os.fsencode(folder) + b'/\xff.yaml'))).write_text('a: 1')
    return folder


def nested(folder: Path) -> Path:
    package(folder)
    before = os.getcwd()
    os.chdir(folder)
    try:
        for _ in range(1100):
            os.mkdir('deep')
            os.chdir('deep')
    finally:
        os.chdir(before)
    return folder


def manifest_is_a_pipe(folder: Path) -> Path:
    package(folder)
    (folder / 'package.xml').unlink()
    os.mkfifo(folder / 'package.xml')
    return folder / 'launch' / 'static_frame.launch.py'


def launch_file_is_a_pipe(folder: Path) -> Path:
    folder.mkdir()
    os.mkfifo(folder / 'static_frame.launch.py')
    return folder / 'static_frame.launch.py'


def launch_file_is_a_device(folder: Path) -> Path:
    folder.mkdir()
    (folder / 'static_frame.launch.py').symlink_to('/dev/zero')
    return folder / 'static_frame.launch.py'


ODD = [many_digits, half_a_character, odd_entries, nested, manifest_is_a_pipe, launch_file_is_a_pipe, launch_file_is_a_device]


@pytest.mark.whole
@pytest.mark.parametrize('make', ODD, ids=[make.__name__ for make in ODD])
def test_the_next_submission_gets_its_report(
    tmp_path: Path, make: Callable[[Path], Path], capsys: pytest.CaptureFixture[str]
) -> None:
    odd = make(tmp_path / 'odd')
    good = tmp_path / 'static_frame.launch.py'
    good.write_text(GOOD)
    written = {name: str(tmp_path / f'report.{name}') for name in ('json', 'junit', 'html')}
    options = [word for name, path in written.items() for word in (f'--{name}', path)]
    assert main([str(odd), str(good), *options]) in (1, 2)
    found = json.loads(Path(written['json']).read_text(encoding='utf-8'))
    assert len(found['reports']) + len(found['refused']) == 2
    assert found['reports'][-1]['points']['earned'] == 1
    assert all(Path(path).stat().st_size > 500 for path in written.values())
    assert 'sum' in capsys.readouterr().out
    remove_tree(str(tmp_path / 'odd'))  # pytest cannot


def test_a_long_word_does_not_take_long() -> None:
    paths = ShortPaths('/w', package='p')
    for piece in ('a/', 'edulaunch-a/', 'edulaunch-', 'edugrade-', 'edulaunch-a/b-01234567/share/'):
        assert len(paths.text(piece * 200_000) or '') <= LONGEST_TEXT + 100


@pytest.mark.processes
def test_a_name_with_control_characters_moves_no_cursor(tmp_path: Path, capsys: pytest.CaptureFixture[str]) -> None:
    folder = tmp_path / 'a\x1b[2Jb'
    folder.mkdir()
    (folder / 'static_frame.launch.py').write_text(GOOD)
    main([str(folder / 'static_frame.launch.py')])
    assert '\x1b' not in capsys.readouterr().out


def test_the_seed_is_made_of_all_texts_of_a_package(tmp_path: Path) -> None:
    folder = package(tmp_path / 'static_frame')
    before = plan_work(Submission(str(folder))).seed
    (folder / 'b.yaml').write_text('a: 1')
    assert plan_work(Submission(str(folder))).seed != before

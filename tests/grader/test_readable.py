"""A run reads the engine and Python's packages, and nothing of the grader, in whatever way both are installed."""

from __future__ import annotations

import os
from pathlib import Path

import pytest
from edugrade import job
from edugrade.submission import Submission


def allows(read: list[str], path: Path) -> bool:
    return any(os.path.realpath(path).startswith(os.path.join(os.path.realpath(place), '')) for place in read)


def test_the_grader_is_hidden_among_the_installed_packages(tmp_path: Path, monkeypatch: pytest.MonkeyPatch) -> None:
    packages = tmp_path / 'lib' / 'site-packages'
    for name in ('numpy', 'edugrade/checks', 'edugrade/sandbox', 'elsewhere'):
        (packages / name).mkdir(parents=True)
    (tmp_path / 'lib64').symlink_to('lib')
    (packages / 'ring').symlink_to('..')
    (packages / 'again').symlink_to('edugrade/checks')
    monkeypatch.setattr('sys.prefix', str(tmp_path))
    monkeypatch.setattr(job, '__file__', str(packages / 'edugrade' / 'readable.py'))
    monkeypatch.setattr(job, 'rubrics_folder', lambda: str(packages / 'edugrade' / 'checks'))
    read, listed = job.readable_by_all([str(packages)])
    assert allows(read, packages / 'numpy' / 'a.py')
    assert not allows(read, packages / 'edugrade' / 'checks' / 'circle.py')
    assert not allows(read, packages / 'edugrade' / 'sandbox' / 'child.py')
    assert {str(tmp_path), str(tmp_path / 'lib'), str(packages)} <= set(listed)


def test_of_a_checkout_only_the_engine_is_read(tmp_path: Path) -> None:
    for name in ('edulaunch', 'solutions', 'tests'):
        (tmp_path / name).mkdir()
    read, _ = job.readable_by_all([str(tmp_path)])
    assert not allows(read, tmp_path / 'solutions' / 'circle.launch.py')


def test_a_launch_file_alone_reads_itself_and_a_package_its_folder(tmp_path: Path) -> None:
    alone = tmp_path / 'a.launch.py'
    alone.touch()
    assert job.readable_by_run(Submission(str(alone)), ['/ws']) == [str(alone), '/ws']
    (tmp_path / 'p' / 'launch').mkdir(parents=True)
    (tmp_path / 'p' / 'package.xml').write_text('<package><name>p</name></package>')
    inside = tmp_path / 'p' / 'launch' / 'p.launch.py'
    inside.touch()
    assert job.readable_by_run(Submission(str(inside)), []) == [str(tmp_path / 'p')]

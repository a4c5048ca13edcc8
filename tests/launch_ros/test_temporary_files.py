"""Parameter files that one run leaves for the next."""

from __future__ import annotations

import os
from pathlib import Path

from launch_ros._temporary_files import TemporaryFiles, temporary_path


def test_a_file_with_the_same_text_stays(tmp_path: Path) -> None:
    path = tmp_path / 'file'
    TemporaryFiles().write(str(path), 'text')
    before = os.stat(path).st_mtime_ns, os.stat(path).st_ino
    TemporaryFiles().write(str(path), 'text')
    assert (os.stat(path).st_mtime_ns, os.stat(path).st_ino) == before


def test_a_file_with_another_text_is_replaced(tmp_path: Path) -> None:
    path = tmp_path / 'file'
    path.write_bytes(b'\xff not text')
    TemporaryFiles().write(str(path), 'text')
    assert path.read_text() == 'text'


def test_a_file_that_was_not_changed_is_still_removed(tmp_path: Path) -> None:
    path = tmp_path / 'file'
    path.write_text('text')
    files = TemporaryFiles()
    files.write(str(path), 'text')
    files.remove()
    assert not path.exists()


def test_paths_repeat_from_run_to_run_and_differ_within_one() -> None:
    first, second = {}, {}  # type: ignore[var-annotated]
    assert temporary_path('a', first) == temporary_path('a', second) == temporary_path('a', first)
    assert temporary_path('b', first) != temporary_path('a', first)
